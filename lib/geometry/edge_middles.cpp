#include "geometry/edge_middles.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/ldl.hpp"
#include "base/vector3.hpp"
#include "geometry/curve_patches.hpp"

namespace ixos {
namespace {

constexpr std::size_t unknowns = 5;  ///< of a quadratic function that is known at one point
using Row = std::array<double, unknowns>;

std::size_t at(int number) { return static_cast<std::size_t>(number); }

}  // namespace

EdgeMiddles::EdgeMiddles(std::vector<Face> faces, const std::vector<Vec<3>>& x)
    : faces_(std::move(faces)), ends_(x.size()), x_(x) {
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t k = 0; k < faces_[f].size(); ++k)
      edges_[std::minmax(faces_[f][k], faces_[f][(k + 1) % faces_[f].size()])].faces.push_back(static_cast<int>(f));
  for (auto& [nodes, own] : edges_) {
    own.crease = own.faces.size() != 2 || !meet_smoothly(normal(own.faces[0]), normal(own.faces[1]));
    if (!own.crease) continue;
    ends_[at(nodes.first)].push_back(nodes.second);
    ends_[at(nodes.second)].push_back(nodes.first);
  }
}

/// Returns the outward normal, twice as long as the face is large.
Vec<3> EdgeMiddles::normal(int face) const {
  const Face& n = faces_[at(face)];
  if (n.size() == 3) return cross(x_[at(n[1])] - x_[at(n[0])], x_[at(n[2])] - x_[at(n[0])]);
  return cross(x_[at(n[2])] - x_[at(n[0])], x_[at(n[3])] - x_[at(n[1])]);
}

NodeWeights EdgeMiddles::middle(int a, int b) const {
  NodeWeights result;
  result.add(a, 0.5);
  result.add(b, 0.5);
  const std::optional<NodeWeights> from = slope(a, b), to = slope(b, a);  // to: in the direction from b to a
  const double share = from && to ? 1.0 / 8 : 1.0 / 4;
  for (const auto& [own, node, far] : {std::tuple(&from, a, b), std::tuple(&to, b, a)}) {
    if (!*own) continue;
    result.add(**own, share);
    if (from && to) continue;
    result.add(far, -share);
    result.add(node, share);
  }
  return result;
}

/// Returns the surface's slope at a in the direction of b, for the length of the edge; none if it is not known.
std::optional<NodeWeights> EdgeMiddles::slope(int a, int b) const {
  const Edge& own = edge(a, b);
  if (own.crease) return along_crease(a, b);
  std::vector<int> faces = sector(a, own.faces.front());
  Vec<3> sum{};
  for (const int face : faces) sum = sum + normal(face);
  const Vec<3> n = 1 / length(sum) * sum;
  for (int ring = 0; ring < 3; ++ring) {
    if (auto result = fitted(a, b, faces, n)) return result;
    grow(faces);
  }
  return std::nullopt;
}

std::optional<NodeWeights> EdgeMiddles::along_crease(int a, int b) const {
  const std::vector<int>& ends = ends_[at(a)];
  if (ends.size() != 2) return std::nullopt;
  const int before = ends[0] == b ? ends[1] : ends[0];
  const Vec<3> behind = x_[at(a)] - x_[at(before)], ahead = x_[at(b)] - x_[at(a)];
  if (!meet_smoothly(behind, ahead)) return std::nullopt;
  const std::array<double, 3> weights = parabola_slope(length(behind), length(ahead));
  NodeWeights result;
  const std::array<int, 3> nodes{before, a, b};
  for (std::size_t k = 0; k < 3; ++k) result.add(nodes[k], length(ahead) * weights[k]);
  return result;
}

/// Returns the faces around a node that are reached from one of them across edges at the node without a crease.
std::vector<int> EdgeMiddles::sector(int node, int face) const {
  std::vector<int> result{face};
  for (std::size_t next = 0; next < result.size(); ++next) {
    const Face own = faces_[at(result[next])];
    for (std::size_t k = 0; k < own.size(); ++k) {
      const int a = own[k], b = own[(k + 1) % own.size()];
      if ((a != node && b != node) || edge(a, b).crease) continue;
      for (const int other : edge(a, b).faces)
        if (std::find(result.begin(), result.end(), other) == result.end()) result.push_back(other);
    }
  }
  return result;
}

/// Adds the faces beyond edges without a crease.
void EdgeMiddles::grow(std::vector<int>& faces) const {
  std::set<int> all(faces.begin(), faces.end());
  for (const int face : faces) {
    const Face& own = faces_[at(face)];
    for (std::size_t k = 0; k < own.size(); ++k)
      if (const Edge& each = edge(own[k], own[(k + 1) % own.size()]); !each.crease)
        all.insert(each.faces.begin(), each.faces.end());
  }
  faces.assign(all.begin(), all.end());
}

/// Returns the slope of the fit to the nodes of these faces; none if they do not determine it well.
std::optional<NodeWeights> EdgeMiddles::fitted(int a, int b, const std::vector<int>& faces, const Vec<3>& n) const {
  std::set<int> around;
  for (const int face : faces) around.insert(faces_[at(face)].begin(), faces_[at(face)].end());
  around.erase(a);
  if (around.size() < unknowns) return std::nullopt;
  const Vec<3> edge = x_[at(b)] - x_[at(a)], flat = edge - inner(edge, n) * n;
  const double unit = length(flat);  // of the coordinates
  const Vec<3> first = 1 / unit * flat, second = cross(n, first);
  std::vector<Row> rows;
  std::vector<double> weights;
  Small<double, unknowns> matrix{};
  for (const int node : around) {
    const Vec<3> r = x_[at(node)] - x_[at(a)];
    const double u = inner(r, first) / unit, v = inner(r, second) / unit;
    rows.push_back({u, v, u * u / 2, u * v, v * v / 2});
    weights.push_back(unit * unit / inner(r, r));
    for (std::size_t i = 0; i < unknowns; ++i)
      for (std::size_t j = 0; j < unknowns; ++j) matrix[i][j] += weights.back() * rows.back()[i] * rows.back()[j];
  }
  double largest = 0;
  for (std::size_t i = 0; i < unknowns; ++i) largest = std::max(largest, matrix[i][i]);
  const Ldl<double, unknowns> factors(matrix);
  if (!(factors.least_pivot() > 1e-4 * largest)) return std::nullopt;
  Row solution{1, 0, 0, 0, 0};  // of the derivative by u, which is 1 at b
  factors.solve(solution);
  NodeWeights result;
  std::size_t k = 0;
  double sum = 0;
  for (const int node : around) {
    double weight = 0;
    for (std::size_t i = 0; i < unknowns; ++i) weight += weights[k] * rows[k][i] * solution[i];
    result.add(node, weight);
    result.add(a, -weight);
    sum += std::abs(weight);
    ++k;
  }
  // Larger weights would multiply what moves single nodes; those of even rings are below 1.
  constexpr double most = 4;
  if (sum > most) return std::nullopt;
  return result;
}

}  // namespace ixos
