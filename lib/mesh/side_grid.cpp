#include "mesh/side_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/vector3.hpp"

namespace ixos {

void refuse_edge(const std::string& name, long long a, long long b) {
  throw InputError(
      fmt::format("more than two sides of the surface \"{}\", or two in opposite directions, meet in the edge between "
                  "the nodes {} and {} of the mesh",
                  name, a, b));
}

SideGrid::SideGrid(std::vector<Face> faces, const std::vector<Vec<3>>& x, const std::string& name,
                   const std::vector<long long>& numbers)
    : faces_(std::move(faces)), ends_(x.size()), count_(x.size(), 0), x_(x) {
  find_edges(name, numbers);
  find_strips(x);
}

void SideGrid::find_edges(const std::string& name, const std::vector<long long>& numbers) {
  const auto at = [](int node) { return static_cast<std::size_t>(node); };
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = faces_[f][k], b = faces_[f][(k + 1) % 4];
      ++count_[at(a)];
      Edge& own = edges_[std::minmax(a, b)];
      int& place = own.faces[a < b ? 0 : 1];  // by the direction in which the face goes along it
      if (place >= 0) refuse_edge(name, numbers[at(a)], numbers[at(b)]);
      place = static_cast<int>(f);
    }
  for (auto& [nodes, own] : edges_) {
    ends_[at(nodes.first)].push_back(nodes.second);
    ends_[at(nodes.second)].push_back(nodes.first);
    if (own.faces[0] >= 0 && own.faces[1] >= 0) own.crease = !meet_smoothly(normal(own.faces[0]), normal(own.faces[1]));
  }
}

Vec<3> SideGrid::normal(int face) const {
  const auto at = [](int node) { return static_cast<std::size_t>(node); };
  const Face& n = faces_[at(face)];
  return cross(x_[at(n[2])] - x_[at(n[0])], x_[at(n[3])] - x_[at(n[1])]);
}

SideGrid::OpenCreases SideGrid::open_creases() const {
  const auto is_end = [&](int node) {
    const std::vector<int>& ends = ends_[static_cast<std::size_t>(node)];
    return std::count_if(ends.begin(), ends.end(), [&](int end) { return is_crease(node, end); }) == 1;
  };
  OpenCreases result;
  for (const auto& [nodes, own] : edges_) {
    if (!own.crease || own.faces[0] < 0 || own.faces[1] < 0) continue;
    if (!is_end(nodes.first) && !is_end(nodes.second)) continue;
    ++result.count;
    const Vec<3> a = normal(own.faces[0]), b = normal(own.faces[1]);
    result.angle = std::max(result.angle, std::atan2(length(cross(a, b)), inner(a, b)));
  }
  return result;
}

void SideGrid::find_strips(const std::vector<Vec<3>>& x) {
  int count = 0;
  for (auto& [nodes, own] : edges_) own.strip = count++;
  DisjointSets sets(count);
  for (const Face& face : faces_)
    for (const std::size_t k : {0U, 1U})
      sets.join(edge(face[k], face[k + 1]).strip, edge(face[k + 2], face[(k + 3) % 4]).strip);
  std::vector<double> sum(edges_.size(), 0.0), edges(edges_.size(), 0.0);
  for (auto& [nodes, own] : edges_) {
    own.strip = sets.of(own.strip);
    const auto strip = static_cast<std::size_t>(own.strip);
    sum[strip] += length(x[static_cast<std::size_t>(nodes.second)] - x[static_cast<std::size_t>(nodes.first)]);
    edges[strip] += 1;
  }
  strip_length_.resize(edges_.size(), 0.0);
  for (std::size_t s = 0; s < sum.size(); ++s)
    if (edges[s] > 0) strip_length_[s] = sum[s] / edges[s];
}

int SideGrid::across(int face, int a, int b) const {
  const Edge& own = edge(a, b);
  return own.faces[0] == face ? own.faces[1] : own.faces[0];
}

bool SideGrid::has(int face, int node) const {
  const Face& own = faces_[static_cast<std::size_t>(face)];
  return std::find(own.begin(), own.end(), node) != own.end();
}

int SideGrid::opposite(int face, int node) const {
  const Face& own = faces_[static_cast<std::size_t>(face)];
  const auto found = std::find(own.begin(), own.end(), node);
  if (found == own.end()) return -1;
  return own[static_cast<std::size_t>(found - own.begin() + 2) % 4];
}

bool SideGrid::is_regular(int node) const {
  const std::vector<int>& ends = ends_[static_cast<std::size_t>(node)];
  return count_[static_cast<std::size_t>(node)] == 4 && ends.size() == 4 &&
         std::none_of(ends.begin(), ends.end(), [&](int end) { return is_crease(node, end); });
}

int SideGrid::continuation(int node, int far) const {
  const std::vector<int>& ends = ends_[static_cast<std::size_t>(node)];
  if (!is_crease(node, far)) {
    if (!is_regular(node)) return -1;
    const Edge& own = edge(node, far);
    for (const int end : ends)
      if (end != far && !has(own.faces[0], end) && !has(own.faces[1], end)) return end;
    return -1;
  }
  int other = -1;
  for (const int end : ends) {
    if (end == far || !is_crease(node, end)) continue;
    if (other >= 0) return -1;
    other = end;
  }
  const auto place = [&](int n) { return x_[static_cast<std::size_t>(n)]; };
  if (other < 0 || !meet_smoothly(place(node) - place(far), place(other) - place(node))) return -1;
  return other;
}

SideGrid::OpenCreases open_creases(const Mesh& mesh, const SideSet& set) {
  std::vector<SideGrid::Face> faces;
  for (const Side& side : set.sides) {
    const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const std::vector<int>& corners = side_nodes(block.type, side.side);
    if (corners.size() != 4) return {};
    SideGrid::Face face;
    for (std::size_t k = 0; k < 4; ++k)
      face[k] = block.nodes[cell_entry(side.cell, nodes_per_cell(block.type), corners[k])];
    faces.push_back(face);
  }
  std::vector<Vec<3>> x;
  std::vector<long long> numbers;
  for (std::size_t k = 0; k + 2 < mesh.coordinates.size(); k += 3) {
    x.push_back({mesh.coordinates[k], mesh.coordinates[k + 1], mesh.coordinates[k + 2]});
    numbers.push_back(static_cast<long long>(x.size()));
  }
  return SideGrid(std::move(faces), x, set.name, numbers).open_creases();
}

}  // namespace ixos
