#include "mesh/merged_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/assign.hpp>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/algorithms/expand.hpp>
#include <boost/geometry/arithmetic/arithmetic.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "base/vector3.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/normalize.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
namespace index = bg::index;
using Entry = std::pair<TreePoint, int>;

/// Returns the number of each block's part.
std::vector<int> parts_of_blocks(const Mesh& mesh, const std::vector<MeshPart>& parts) {
  std::vector<int> result;
  for (const ElementBlock& block : mesh.blocks) {
    const auto own = [&](const MeshPart& part) { return is_in_part(part.name, block.name); };
    result.push_back(static_cast<int>(std::find_if(parts.begin(), parts.end(), own) - parts.begin()));
  }
  return result;
}

/// Returns the nodes on the boundary of each part, ascending.
std::vector<std::set<int>> boundary_nodes(const Mesh& mesh, const std::vector<Side>& sides,
                                          const std::vector<int>& part_of_block, std::size_t parts) {
  std::vector<std::set<int>> nodes(parts);
  for (const Side& side : sides)
    for (const int node : nodes_of_side(mesh, side))
      nodes[static_cast<std::size_t>(part_of_block[static_cast<std::size_t>(side.block)])].insert(node);
  return nodes;
}

/// Finds, part after part, the node of an earlier part that each node of the boundary is to be.
class Merging {
 public:
  /// Both must outlive it.
  Merging(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance), same_(all_nodes(mesh)) {}

  void add(const std::string& part, const std::set<int>& nodes) {
    std::vector<Entry> fresh;
    std::set<int> taken;
    for (const int node : nodes) {
      const TreePoint place = tree_point(node_place(mesh_, node));
      std::vector<Entry> nearest;
      tree_.query(index::nearest(place, 1), std::back_inserter(nearest));
      if (nearest.empty() || bg::distance(place, nearest.front().first) > tolerance_) {
        fresh.emplace_back(place, node);
        continue;
      }
      const int target = nearest.front().second;
      same_[static_cast<std::size_t>(node)] = target;
      targets_.insert(target);
      ++merged_;
      if (!taken.insert(target).second)
        throw InputError(fmt::format(
            "{} is too large: it makes one node of two nodes of the part \"{}\" near {}; it must be smaller than the "
            "distance of its nodes",
            tolerance_, part, in_words(node)));
    }
    tree_.insert(fresh.begin(), fresh.end());
  }
  int merged() const { return merged_; }
  int of(int node) const { return same_[static_cast<std::size_t>(node)]; }
  /// Returns whether the node became another one, or another one became it.
  bool is_shared(int node) const { return of(node) != node || targets_.count(node) > 0; }
  std::string in_words(int node) const { return point_in_words(node_place(mesh_, node), mesh_.dimension); }

 private:
  static std::vector<int> all_nodes(const Mesh& mesh) {
    std::vector<int> nodes(static_cast<std::size_t>(mesh.nodes()));
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<int> same_;  ///< by node
  std::set<int> targets_;
  index::rtree<Entry, index::quadratic<16>> tree_;
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

/// A side that only one cell has.
struct FreeSide {
  int part;
  std::vector<int> nodes;
  std::vector<Vec<3>> corners;
  Vec<3> middle, normal;
};

FreeSide free_side(const Mesh& mesh, const Side& side, int part) {
  FreeSide own{
      part, nodes_of_side(mesh, side), {}, centre_of(mesh, sorted_corners(mesh, side)), outward_normal(mesh, side)};
  for (std::size_t k = 0; k < count_of(corners_of(mesh, side)); ++k)
    own.corners.push_back(node_place(mesh, own.nodes[k]));
  return own;
}

/// Returns whether a point lies on a side between its corners, away from its rim.
bool lies_within(const FreeSide& side, const Vec<3>& x, double tolerance) {
  const double size = length(side.normal);
  if (std::abs(dot(side.normal, x - side.corners[0])) > tolerance * size) return false;
  if (side.corners.size() == 2) {
    const Vec<3> along = side.corners[1] - side.corners[0];
    const double whole = length(along), place = dot(along, x - side.corners[0]) / whole;
    return place > tolerance && place < whole - tolerance;
  }
  for (std::size_t k = 0; k < side.corners.size(); ++k) {
    const Vec<3> edge = side.corners[(k + 1) % side.corners.size()] - side.corners[k];
    const double inside = dot(side.normal, cross(edge, x - side.corners[k]));
    if (!(inside > tolerance * size * length(edge))) return false;
  }
  return true;
}

using Box = bg::model::box<TreePoint>;

Box box_around(const std::vector<Vec<3>>& points, double margin) {
  Box box;
  bg::assign_inverse(box);
  for (const Vec<3>& x : points) bg::expand(box, tree_point(x));
  bg::add_value(box.max_corner(), margin);
  bg::subtract_value(box.min_corner(), margin);
  return box;
}

/// Throws if two sides of different parts that are not one lie on each other: the middle of one, or a node of it that
/// is no node of another part, is within the other. `sides`: of the boundary before nodes were merged.
void refuse_faces_that_do_not_match(const Mesh& mesh, const std::vector<Side>& sides,
                                    const std::vector<CellSide>& sorted, const std::vector<int>& part_of_block,
                                    const std::vector<MeshPart>& all, double tolerance, const Merging& merging) {
  std::vector<FreeSide> free;
  std::vector<std::pair<Box, std::size_t>> boxes;
  for (const Side& side : sides) {
    const auto [first, last] = sides_with(sorted, sorted_corners(mesh, side));
    const int part = part_of_block[static_cast<std::size_t>(side.block)];
    const bool overlaps = last - first > 2 || (last - first == 2 && dot(outward_normal(mesh, first->side),
                                                                        outward_normal(mesh, (first + 1)->side)) > 0);
    if (overlaps)
      throw InputError(fmt::format("the part \"{}\" overlaps another one near {}",
                                   all[static_cast<std::size_t>(part)].name,
                                   merging.in_words(nodes_of_side(mesh, side).front())));
    if (last - first > 1) continue;
    free.push_back(free_side(mesh, side, part));
    boxes.emplace_back(box_around(free.back().corners, tolerance), free.size() - 1);
  }
  const index::rtree<std::pair<Box, std::size_t>, index::quadratic<16>> tree(boxes);
  for (const FreeSide& own : free) {
    std::vector<Vec<3>> points{own.middle};
    for (const int node : own.nodes)
      if (!merging.is_shared(node)) points.push_back(node_place(mesh, node));
    for (const Vec<3>& x : points)
      for (auto found = tree.qbegin(index::intersects(tree_point(x))); found != tree.qend(); ++found) {
        const FreeSide& other = free[found->second];
        if (other.part == own.part || !lies_within(other, x, tolerance)) continue;
        throw InputError(fmt::format(
            "the parts \"{}\" and \"{}\" touch near {}, but their faces do not match; give both the same "
            "divisions there, tie them (Mesh/Ties), or let them stick by an interaction with a Primary Side Set",
            all[static_cast<std::size_t>(own.part)].name, all[static_cast<std::size_t>(other.part)].name,
            merging.in_words(own.nodes.front())));
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
  if (!mesh.ties.empty())
    throw InputError("nodes of the parts follow others already; merge the parts before they are tied");
  const std::vector<int> part_of_block = parts_of_blocks(mesh, parts);
  const std::vector<Side> sides = boundary_sides(mesh);
  Merging merging(mesh, tolerance);
  const std::vector<std::set<int>> nodes = boundary_nodes(mesh, sides, part_of_block, parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part) merging.add(parts[part].name, nodes[part]);
  if (merging.merged() == 0)
    throw InputError(fmt::format("no node of a part is within {} of a node of another part", tolerance));
  renumber(mesh, merging);
  const std::vector<CellSide> sorted = sorted_sides(mesh);
  refuse_faces_that_do_not_match(mesh, sides, sorted, part_of_block, parts, tolerance, merging);
  drop_inner_sides(mesh, sorted);
  const std::vector<std::string> notes = mesh.notes;
  drop_unused_nodes(mesh);
  mesh.notes = notes;
  mesh.notes.push_back(fmt::format("{} nodes of parts were merged with those of other parts", merging.merged()));
}

}  // namespace ixos
