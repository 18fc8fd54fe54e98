#include "mesh/cell_order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "mesh/added_nodes.hpp"
#include "mesh/middles.hpp"
#include "mesh/side_set_nodes.hpp"

namespace ixos {
namespace {

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
  int cell = 0;
  for (const auto& block : mesh.blocks) {
    const std::vector<NodeCorners>& pattern = cell_info(plain_type(block.type)).node_corners;
    const auto whole = static_cast<std::size_t>(nodes_per_cell(corner_type(block.type)));
    for (int c = 0; c < block.cells(); ++c, ++cell) {
      const int* nodes = &block.nodes[cell_entry(c, nodes_per_cell(block.type))];
      for (std::size_t a = 0; a < (is_quadratic(block.type) ? pattern.size() : 0); ++a) {
        if (pattern[a].size() == 1) is_corner[static_cast<std::size_t>(nodes[a])] = true;
        if (pattern[a].size() == 1 || pattern[a].size() == whole) continue;
        Middle middle{{-1, -1, -1, -1}, nodes[a], cell};
        for (std::size_t k = 0; k < pattern[a].size(); ++k)
          middle.corners[k] = nodes[static_cast<std::size_t>(pattern[a][k])];
        std::sort(middle.corners.begin(), middle.corners.end());
        middles.push_back(middle);
      }
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

void raise_order(Mesh& mesh, bool bubbles) {
  if (mesh.plain_nodes >= 0)
    throw InputError("the mesh has enriched sides; raise the order of its cells before it is enriched");
  const auto raised = [bubbles](const ElementBlock& block) {
    return bubbles || !is_quadratic(block.type) ? raised_type(block.type, bubbles) : block.type;
  };
  if (std::all_of(mesh.blocks.begin(), mesh.blocks.end(),
                  [&](const ElementBlock& block) { return block.type == raised(block); }))
    return;
  if (!mesh.ties.empty())
    throw InputError(
        "the cells need more nodes, and the mesh has tied nodes already; give it cells with these nodes, or tie it in "
        "the "
        "scene (Refine, Ties, Periodic)");
  const auto of_sides = sets_of_sides(mesh);
  const int before = mesh.nodes();
  Middles middles(mesh);
  for (ElementBlock& block : mesh.blocks) {
    const CellType type = raised(block);
    if (block.type == type) continue;
    std::vector<int> nodes;
    const int before_raised = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      middles.complete(&block.nodes[cell_entry(cell, before_raised)], before_raised, type, nodes);
    block.nodes = std::move(nodes);
    block.type = type;
  }
  complete_node_sets(mesh, middles.added());
  renew_sets_of_sides(mesh, of_sides);
  if (mesh.linear_nodes < 0) mesh.linear_nodes = before;
}

void add_bubbles(Mesh& mesh) {
  if (std::any_of(mesh.blocks.begin(), mesh.blocks.end(), [](const auto& block) { return is_quadratic(block.type); }))
    raise_order(mesh, true);
}

void place_bubbles(Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for_each_bubble(mesh, [&](int node, const std::vector<double>& place, double /*size*/) {
    std::copy_n(place.begin(), d, &mesh.coordinates[static_cast<std::size_t>(node) * d]);
  });
}

void require_placed_bubbles(const Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for_each_bubble(mesh, [&](int node, const std::vector<double>& place, double size) {
    for (std::size_t i = 0; i < d; ++i)
      if (std::abs(mesh.coordinates[static_cast<std::size_t>(node) * d + i] - place[i]) > 1e-9 * size)
        throw InputError(
            fmt::format("node {} is in the middle of a triangle or a cell, but stands elsewhere than the nodes on the "
                        "edges put it, "
                        "at ({:.6g}); place_bubbles() moves such nodes",
                        node + 1, fmt::join(place, ", ")));
  });
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
  // A triangle with a node in its middle beside one without.
  const auto with_bubbles = [](const ElementBlock& block) {
    return cell_info(block.type).bubbles && block.cells() > 0;
  };
  const auto without = [&](const ElementBlock& block) {
    return !is_cube(block.type) && is_quadratic(block.type) && !with_bubbles(block) && block.cells() > 0;
  };
  const auto bubbles = std::find_if(mesh.blocks.begin(), mesh.blocks.end(), with_bubbles);
  const auto plain = std::find_if(mesh.blocks.begin(), mesh.blocks.end(), without);
  if (mesh.dimension == 3 && bubbles != mesh.blocks.end() && plain != mesh.blocks.end())
    throw InputError(fmt::format(
        "block \"{}\" has {} cells and block \"{}\" {} ones, which do not conform: only one of them has nodes in the "
        "middle of triangles",
        bubbles->name, cell_info(bubbles->type).name, plain->name, cell_info(plain->type).name));
}

void require_shared_middles(const Mesh& mesh) {
  const auto has_bubbles = [](const ElementBlock& block) { return cell_info(block.type).bubbles; };
  if (mesh.linear_nodes >= 0 && std::none_of(mesh.blocks.begin(), mesh.blocks.end(), has_bubbles)) return;
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
