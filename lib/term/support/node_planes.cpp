#include "term/support/node_planes.hpp"

namespace ixos {
namespace {

/// A normal that is a combination of others has this length left at most [-].
constexpr double nothing_left = 1e-4;

/// Adds what is left of a normal across the others.
void add_orthogonal(Vec<3> normal, std::vector<Vec<3>>& normals) {
  const double size = length(normal);
  for (const Vec<3>& other : normals) normal = normal - inner(other, normal) * other;
  if (const double left = length(normal); left > nothing_left * size) normals.push_back(1 / left * normal);
}

}  // namespace

void NodePlanes::add(int node, std::size_t dimension, const Vec<3>& normal) {
  dimension_ = dimension;
  const auto [found, is_new] = index_.try_emplace(node, nodes_.size());
  if (is_new) nodes_.push_back({node, {}});
  add_orthogonal(1 / length(normal) * normal, nodes_[found->second].normals);
}

void NodePlanes::hold(int node, std::size_t i) {
  const auto found = index_.find(node);
  if (found == index_.end()) return;
  std::vector<Vec<3>>& normals = nodes_[found->second].normals;
  std::vector<Vec<3>> left;
  for (Vec<3> normal : normals) {
    normal[i] = 0;
    if (length(normal) > nothing_left) add_orthogonal(normal, left);
  }
  normals = left;
}

const std::vector<Vec<3>>& NodePlanes::normals(int node) const {
  static const std::vector<Vec<3>> none;
  const auto found = index_.find(node);
  return found == index_.end() ? none : nodes_[found->second].normals;
}

void NodePlanes::project(double* x, int end) const { add_across(-1, x, x, end); }

void NodePlanes::add_across(double factor, const double* from, double* to, int end) const {
  for (const Node& own : nodes_) {
    if (own.node >= end) continue;
    const std::size_t first = static_cast<std::size_t>(own.node) * dimension_;
    Vec<3> across{};
    for (const Vec<3>& normal : own.normals) {
      double along = 0;
      for (std::size_t i = 0; i < dimension_; ++i) along += normal[i] * from[first + i];
      across = across + along * normal;
    }
    for (std::size_t i = 0; i < dimension_; ++i) to[first + i] += factor * across[i];
  }
}

}  // namespace ixos
