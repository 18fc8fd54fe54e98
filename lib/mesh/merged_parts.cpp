#include "mesh/merged_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/normalize.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
namespace index = bg::index;
using Place = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Place, int>;
using Tree = index::rtree<Entry, index::quadratic<16>>;

Place place_of(const Mesh& mesh, int node) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const double* x = &mesh.coordinates[static_cast<std::size_t>(node) * d];
  return {x[0], x[1], d == 3 ? x[2] : 0.0};
}

/// Returns the number of each block's part.
std::vector<int> parts_of_blocks(const Mesh& mesh, const std::vector<MeshPart>& parts) {
  std::vector<int> result;
  for (const ElementBlock& block : mesh.blocks) {
    const auto own = [&](const MeshPart& part) { return is_in_part(part.name, block.name); };
    result.push_back(static_cast<int>(std::find_if(parts.begin(), parts.end(), own) - parts.begin()));
  }
  return result;
}

/// The nodes on the boundary of a part, ascending.
std::vector<int> boundary_nodes(const Mesh& mesh, const std::vector<Side>& sides, const std::vector<int>& part_of_block,
                                int part) {
  std::set<int> nodes;
  for (const Side& side : sides)
    if (part_of_block[static_cast<std::size_t>(side.block)] == part)
      for (const int node : nodes_of_side(mesh, side)) nodes.insert(node);
  return {nodes.begin(), nodes.end()};
}

/// Finds, part after part, the node of an earlier part that each node of the boundary is to be.
class Merging {
 public:
  Merging(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance), same_(all_nodes(mesh)) {}

  void add(const std::string& part, const std::vector<int>& nodes) {
    std::vector<Entry> fresh;
    std::set<int> taken;
    for (const int node : nodes) {
      const Place place = place_of(mesh_, node);
      std::vector<Entry> nearest;
      tree_.query(index::nearest(place, 1), std::back_inserter(nearest));
      if (nearest.empty() || bg::distance(place, nearest.front().first) > tolerance_) {
        fresh.emplace_back(place, node);
        continue;
      }
      same_[static_cast<std::size_t>(node)] = nearest.front().second;
      ++merged_;
      if (!taken.insert(nearest.front().second).second)
        throw InputError(fmt::format(
            "{} is too large: it makes one node of two nodes of the part \"{}\" near {}; it must be smaller than the "
            "distance of its nodes",
            tolerance_, part, in_words(node)));
    }
    tree_.insert(fresh.begin(), fresh.end());
  }
  int merged() const { return merged_; }
  int of(int node) const { return same_[static_cast<std::size_t>(node)]; }
  std::string in_words(int node) const {
    const Place place = place_of(mesh_, node);
    return mesh_.dimension == 2
               ? fmt::format("({:.6g}, {:.6g})", place.get<0>(), place.get<1>())
               : fmt::format("({:.6g}, {:.6g}, {:.6g})", place.get<0>(), place.get<1>(), place.get<2>());
  }

 private:
  static std::vector<int> all_nodes(const Mesh& mesh) {
    std::vector<int> nodes(static_cast<std::size_t>(mesh.nodes()));
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<int> same_;  ///< by node
  Tree tree_;
  int merged_ = 0;
};

void renumber(Mesh& mesh, const Merging& merging) {
  for (ElementBlock& block : mesh.blocks)
    for (int& node : block.nodes) node = merging.of(node);
  for (NodeSet& set : mesh.node_sets) {
    for (int& node : set.nodes) node = merging.of(node);
    std::sort(set.nodes.begin(), set.nodes.end());
    set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
  }
}

/// Returns the parts whose cells have each node.
std::vector<std::set<int>> parts_of_nodes(const Mesh& mesh, const std::vector<int>& part_of_block) {
  std::vector<std::set<int>> parts(static_cast<std::size_t>(mesh.nodes()));
  for (std::size_t block = 0; block < mesh.blocks.size(); ++block)
    for (const int node : mesh.blocks[block].nodes) parts[static_cast<std::size_t>(node)].insert(part_of_block[block]);
  return parts;
}

/// Throws if a side that only one cell has has all its corners in common with another part.
void refuse_faces_that_do_not_match(const Mesh& mesh, const std::vector<Side>& sides,
                                    const std::vector<CellSide>& sorted, const std::vector<int>& part_of_block,
                                    const std::vector<MeshPart>& all, const Merging& merging) {
  const std::vector<std::set<int>> parts = parts_of_nodes(mesh, part_of_block);
  for (const Side& side : sides) {
    const auto [first, last] = sides_with(sorted, sorted_corners(mesh, side));
    if (last - first > 1) continue;
    const int own = part_of_block[static_cast<std::size_t>(side.block)];
    const std::vector<int> nodes = nodes_of_side(mesh, side);
    const std::size_t corners = mesh.dimension == 2 ? 2 : 4;
    for (int other = 0; other < static_cast<int>(all.size()); ++other) {
      if (other == own) continue;
      const auto shared = [&](int node) { return parts[static_cast<std::size_t>(node)].count(other) > 0; };
      if (std::all_of(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(std::min(corners, nodes.size())),
                      shared))
        throw InputError(
            fmt::format("the parts \"{}\" and \"{}\" touch near {}, but their faces do not match; give both the same "
                        "divisions there, or let them stick by an interaction with a Primary Side Set",
                        all[static_cast<std::size_t>(own)].name, all[static_cast<std::size_t>(other)].name,
                        merging.in_words(nodes.front())));
    }
  }
}

/// Sides that two cells have are no boundary.
void drop_inner_sides(Mesh& mesh, const std::vector<CellSide>& sorted) {
  const auto is_inner = [&](const Side& side) {
    const auto [first, last] = sides_with(sorted, sorted_corners(mesh, side));
    return last - first > 1;
  };
  std::vector<SideSet> kept;
  for (SideSet& set : mesh.side_sets) {
    const bool was_empty = set.sides.empty();
    set.sides.erase(std::remove_if(set.sides.begin(), set.sides.end(), is_inner), set.sides.end());
    if (was_empty || !set.sides.empty()) kept.push_back(std::move(set));
  }
  mesh.side_sets = std::move(kept);
}

}  // namespace

void merge_parts(const std::vector<MeshPart>& parts, double tolerance, Mesh& mesh) {
  const std::vector<int> part_of_block = parts_of_blocks(mesh, parts);
  const std::vector<Side> sides = boundary_sides(mesh);
  Merging merging(mesh, tolerance);
  for (std::size_t part = 0; part < parts.size(); ++part)
    merging.add(parts[part].name, boundary_nodes(mesh, sides, part_of_block, static_cast<int>(part)));
  if (merging.merged() == 0)
    throw InputError(fmt::format("no node of a part is within {} of a node of another part", tolerance));
  renumber(mesh, merging);
  const std::vector<CellSide> sorted = sorted_sides(mesh);
  refuse_faces_that_do_not_match(mesh, sides, sorted, part_of_block, parts, merging);
  drop_inner_sides(mesh, sorted);
  const std::vector<std::string> notes = mesh.notes;
  drop_unused_nodes(mesh);
  mesh.notes = notes;
  mesh.notes.push_back(fmt::format("{} nodes of parts were merged with those of other parts", merging.merged()));
}

}  // namespace ixos
