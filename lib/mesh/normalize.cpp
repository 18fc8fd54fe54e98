#include "mesh/normalize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

std::vector<double> plane_coordinates(const std::vector<double>& space) {
  if (space.empty()) return {};
  const auto [low, high] = std::minmax_element(space.begin(), space.end());
  const double slack = 1e-9 * (*high - *low);
  std::vector<double> plane;
  plane.reserve(space.size() / 3 * 2);
  for (std::size_t k = 0; k + 2 < space.size(); k += 3) {
    if (!(std::abs(space[k + 2]) <= slack))
      throw InputError(fmt::format(
          "the surface elements do not lie in the plane z = 0: a node stands at ({:.6g}, {:.6g}, {:.6g}). A "
          "mesh in two dimensions has z = 0 everywhere, a mesh in three has volume elements",
          space[k], space[k + 1], space[k + 2]));
    plane.insert(plane.end(), {space[k], space[k + 1]});
  }
  return plane;
}

}  // namespace

std::vector<int> drop_unused_nodes(Mesh& mesh) {
  std::vector<int> number(static_cast<std::size_t>(mesh.nodes()), -1);
  for (const ElementBlock& block : mesh.blocks)
    for (int node : block.nodes) number[static_cast<std::size_t>(node)] = 0;
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  int kept = 0;
  std::vector<int> old;
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] < 0) continue;
    old.push_back(static_cast<int>(node));
    std::copy_n(&mesh.coordinates[node * dimension], dimension,
                &mesh.coordinates[static_cast<std::size_t>(kept) * dimension]);
    number[node] = kept++;
  }
  mesh.coordinates.resize(static_cast<std::size_t>(kept) * dimension);
  if (mesh.linear_nodes >= 0)
    mesh.linear_nodes = static_cast<int>(std::lower_bound(old.begin(), old.end(), mesh.linear_nodes) - old.begin());
  const auto renumber = [&](std::vector<int>& nodes) {
    for (int& node : nodes) node = number[static_cast<std::size_t>(node)];
  };
  for (ElementBlock& block : mesh.blocks) renumber(block.nodes);
  for (Tie& tie : mesh.ties) {
    tie.node = number[static_cast<std::size_t>(tie.node)];
    renumber(tie.masters);
  }
  renumber(mesh.nodes_of_tied_sides);
  for (auto& edge : mesh.hanging_edges)
    for (int& node : edge) node = number[static_cast<std::size_t>(node)];
  for (NodeSet& set : mesh.node_sets) {
    renumber(set.nodes);
    set.nodes.erase(std::remove(set.nodes.begin(), set.nodes.end(), -1), set.nodes.end());
  }
  if (const int unused = static_cast<int>(number.size()) - kept; unused > 0)
    mesh.notes.push_back(fmt::format("{} node(s) of the mesh belong to no cell and are left out", unused));
  return old;
}

void flatten(Mesh& mesh) {
  mesh.coordinates = plane_coordinates(mesh.coordinates);
  mesh.dimension = 2;
}

}  // namespace ixos
