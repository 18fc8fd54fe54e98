#include "mesh/cell_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_element.hpp"
#include "mesh/enrichment/contact_nodes.hpp"
#include "mesh/side_set_nodes.hpp"

namespace ixos {
namespace {

constexpr std::size_t corner_count(int dimension) { return std::size_t{1} << dimension; }

/// The middle nodes of a mesh's edges and faces, by their corners.
class Middles {
 public:
  explicit Middles(Mesh& mesh) : mesh_(mesh), pattern_(corners_of_nodes(mesh.dimension)) {
    for (const ElementBlock& block : mesh.blocks)
      for (int cell = 0; is_quadratic(block.type) && cell < block.cells(); ++cell) {
        const int* nodes = &block.nodes[cell_entry(cell, nodes_per_cell(block.type))];
        for (std::size_t a = corner_count(mesh.dimension); a < pattern_.size(); ++a)
          nodes_.insert({sorted(corners_of(nodes, a)), nodes[a]});
      }
  }

  /// Returns a linear cell's nodes and the middle ones, which are added to the mesh if they are missing.
  std::vector<int> completed(const int* nodes) {
    std::vector<int> all(nodes, nodes + corner_count(mesh_.dimension));
    for (std::size_t a = all.size(); a < pattern_.size(); ++a) all.push_back(middle(corners_of(nodes, a)));
    return all;
  }

  /// Returns the nodes that were added on edges and faces.
  const std::vector<Between>& added() const { return added_; }

 private:
  using Corners = std::vector<int>;

  Corners corners_of(const int* nodes, std::size_t a) const {
    Corners corners;
    for (int corner : pattern_[a]) corners.push_back(nodes[corner]);
    return corners;
  }

  static Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  int middle(const Corners& corners) {
    const auto [found, fresh] = nodes_.insert({sorted(corners), mesh_.nodes()});
    if (!fresh) return found->second;
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::vector<double> x(d, 0.0);
    for (int corner : corners)
      for (std::size_t i = 0; i < d; ++i)
        x[i] += mesh_.coordinates[static_cast<std::size_t>(corner) * d + i] / static_cast<double>(corners.size());
    add_node(mesh_, x, -1);
    if (corners.size() < corner_count(mesh_.dimension)) added_.push_back({corners, {found->second}});
    return found->second;
  }

  Mesh& mesh_;
  const std::vector<std::vector<int>>& pattern_;
  std::map<Corners, int> nodes_;
  std::vector<Between> added_;
};

/// Two cells that share an edge's or a face's corners, but not its middle, or a middle that is a corner elsewhere; -1
/// where there is none.
struct MiddleConflict {
  int corner = -1;                   ///< a node that is both
  std::array<int, 2> cells{-1, -1};  ///< counted from 0 over all blocks
  std::array<int, 2> nodes{-1, -1};
};

/// `MeshType`: Mesh or LocalMesh.
template <class MeshType>
MiddleConflict conflict_of_middles(const MeshType& mesh) {
  struct Middle {
    std::array<int, 4> corners;  ///< ascending, after -1 for those that an edge has not
    int node;
    int cell;
    bool operator<(const Middle& other) const { return std::tie(corners, node) < std::tie(other.corners, other.node); }
  };
  std::vector<Middle> middles;
  std::vector<bool> is_corner(static_cast<std::size_t>(mesh.nodes()), false);
  const auto& pattern = corners_of_nodes(mesh.dimension);
  int cell = 0;
  for (const auto& block : mesh.blocks)
    for (int c = 0; c < block.cells(); ++c, ++cell) {
      const int* nodes = &block.nodes[cell_entry(c, nodes_per_cell(block.type))];
      for (std::size_t a = 0; a < (is_quadratic(block.type) ? pattern.size() : 0); ++a) {
        if (pattern[a].size() == 1) is_corner[static_cast<std::size_t>(nodes[a])] = true;
        if (pattern[a].size() == 1 || pattern[a].size() == corner_count(mesh.dimension)) continue;
        Middle middle{{-1, -1, -1, -1}, nodes[a], cell};
        for (std::size_t k = 0; k < pattern[a].size(); ++k)
          middle.corners[k] = nodes[static_cast<std::size_t>(pattern[a][k])];
        std::sort(middle.corners.begin(), middle.corners.end());
        middles.push_back(middle);
      }
    }
  std::sort(middles.begin(), middles.end());
  for (std::size_t k = 0; k < middles.size(); ++k) {
    const Middle& here = middles[k];
    if (is_corner[static_cast<std::size_t>(here.node)]) return {here.node, {here.cell, -1}, {}};
    if (k > 0 && middles[k - 1].corners == here.corners && middles[k - 1].node != here.node)
      return {-1, {middles[k - 1].cell, here.cell}, {middles[k - 1].node, here.node}};
  }
  return {};
}

}  // namespace

void raise_order(Mesh& mesh) {
  if (mesh.plain_nodes >= 0)
    throw InputError("the mesh has enriched sides; raise the order of its cells before it is enriched");
  for (const ElementBlock& block : mesh.blocks)
    if (corner_type(block.type) != cube_type(mesh.dimension))
      throw InputError("block \"" + block.name + "\": only quadrilaterals and hexahedra can become quadratic");
  if (std::all_of(mesh.blocks.begin(), mesh.blocks.end(), [](const auto& block) { return is_quadratic(block.type); }))
    return;
  const auto of_sides = sets_of_sides(mesh);
  const int linear_nodes = mesh.nodes();
  Middles middles(mesh);
  for (ElementBlock& block : mesh.blocks) {
    if (is_quadratic(block.type)) continue;
    std::vector<int> nodes;
    for (int cell = 0; cell < block.cells(); ++cell) {
      const std::vector<int> all = middles.completed(&block.nodes[cell_entry(cell, nodes_per_cell(block.type))]);
      nodes.insert(nodes.end(), all.begin(), all.end());
    }
    block.nodes = std::move(nodes);
    block.type = cube_type(mesh.dimension, 2);
  }
  complete_node_sets(mesh, middles.added());
  renew_sets_of_sides(mesh, of_sides);
  mesh.linear_nodes = linear_nodes;
}

void require_one_order(const Mesh& mesh) {
  const auto quadratic = [](const ElementBlock& block) { return is_quadratic(block.type) && block.cells() > 0; };
  const auto linear = [](const ElementBlock& block) { return !is_quadratic(block.type) && block.cells() > 0; };
  const auto first = std::find_if(mesh.blocks.begin(), mesh.blocks.end(), quadratic);
  const auto other = std::find_if(mesh.blocks.begin(), mesh.blocks.end(), linear);
  if (first != mesh.blocks.end() && other != mesh.blocks.end())
    throw InputError(fmt::format(
        "block \"{}\" has quadratic cells and block \"{}\" linear ones, which do not conform; use one order "
        "in all blocks, or Mesh/Cell Order 2, which raises that of the linear ones",
        first->name, other->name));
}

void require_shared_middles(const Mesh& mesh) {
  if (mesh.linear_nodes >= 0) return;
  const MiddleConflict found = conflict_of_middles(mesh);
  if (found.corner >= 0)
    throw InputError(fmt::format("node {} is in the middle of an edge or a face of element {}, but a corner of another",
                                 found.corner + 1, found.cells[0] + 1));
  if (found.cells[1] >= 0)
    throw InputError(fmt::format(
        "elements {} and {} share the corners of an edge or a face, but have the nodes {} and {} in its middle",
        found.cells[0] + 1, found.cells[1] + 1, found.nodes[0] + 1, found.nodes[1] + 1));
}

void require_shared_middles(const LocalMesh& mesh) {
  const MiddleConflict found = conflict_of_middles(mesh);
  const auto id = [&mesh](int node) { return mesh.program_id(static_cast<std::size_t>(node)); };
  if (found.corner >= 0)
    throw InputError(fmt::format("node {} is in the middle of an edge or a face of one cell, but a corner of another",
                                 id(found.corner)));
  if (found.cells[1] >= 0)
    throw InputError(
        fmt::format("two cells share the corners of an edge or a face, but have the nodes {} and {} in its middle",
                    id(found.nodes[0]), id(found.nodes[1])));
}

}  // namespace ixos
