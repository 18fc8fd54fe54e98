#include "mesh/periodic_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/region.hpp"
#include "mesh/selection.hpp"
#include "mesh/side_set_nodes.hpp"
#include "mesh/tied_nodes.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
using PlacedNode = std::pair<TreePoint, int>;

Vec<3> middle_of(const Mesh& mesh, const std::set<int>& nodes) {
  Vec<3> sum{};
  for (const int node : nodes) sum = sum + 1 / static_cast<double>(nodes.size()) * node_place(mesh, node);
  return sum;
}

/// Throws InputError if sides of one set have no partner in the other although their nodes have: triangles may be cut
/// along other diagonals.
void require_same_sides(const Mesh& mesh, const SideSet& secondary, const SideSet& primary,
                        const std::map<int, int>& partner) {
  std::set<SideCorners> there;
  for (const Side& side : primary.sides) there.insert(sorted_corners(mesh, side));
  for (const Side& side : secondary.sides) {
    SideCorners corners = corners_of(mesh, side);
    const std::string place = point_in_words(centre_of(mesh, corners), mesh.dimension);
    for (int& node : corners)
      if (node >= 0) node = partner.at(node);
    std::sort(corners.begin(), corners.end());
    if (there.count(corners) == 0)
      throw InputError(
          fmt::format("the side at {} of the side set \"{}\" has no partner in \"{}\", though its nodes have: its "
                      "triangles are cut "
                      "along another diagonal. Periodic sides have the same mesh",
                      place, secondary.name, primary.name));
  }
}

/// The places of a body of revolution repeat along its axis only.
void refuse_translation_across_the_axis(const Mesh& mesh, const Vec<3>& translation, double reach) {
  if (mesh.axisymmetric && std::abs(translation[0]) > reach)
    throw InputError(
        fmt::format("the sides are {:.6g} L0 apart along x, the radius; an axisymmetric mesh can be periodic "
                    "along y, its axis, only",
                    std::abs(translation[0])));
}

/// Finds the partners of nodes. Several nodes of one place, of parts that only touch, have those beside which their
/// neighbours' partners stand.
class Partners {
 public:
  /// Nodes no farther apart than `slack` stand at one place [L0].
  Partners(const Mesh& mesh, const SideSet& secondary, const SideSet& primary, double slack)
      : beside_(neighbours(mesh, secondary)), beside_leaders_(neighbours(mesh, primary)), slack_(slack) {
    std::vector<PlacedNode> placed;
    placed.reserve(beside_leaders_.size());
    for (const auto& entry : beside_leaders_)
      placed.emplace_back(tree_point(node_place(mesh, entry.first)), entry.first);
    tree_ = decltype(tree_)(placed);
  }

  /// Returns the primary node nearest to a place, and those that stand where it does.
  std::vector<int> nearest(const Vec<3>& place) const {
    const TreePoint there = tree_point(place);
    constexpr unsigned most = 16;
    std::vector<PlacedNode> near;
    tree_.query(bg::index::nearest(there, most), std::back_inserter(near));
    std::sort(near.begin(), near.end(), [&](const PlacedNode& a, const PlacedNode& b) {
      return std::pair(bg::distance(a.first, there), a.second) < std::pair(bg::distance(b.first, there), b.second);
    });
    std::vector<int> found;
    for (const PlacedNode& own : near)
      if (bg::distance(own.first, near.front().first) <= slack_) found.push_back(own.second);
    return found;
  }

  /// Returns which of the candidates is beside the partner of a neighbour of the node; the first if none is.
  int choose(int node, const std::vector<int>& candidates, const std::map<int, int>& partner) const {
    for (const int candidate : candidates)
      for (const int neighbour : beside_.at(node))
        if (const auto known = partner.find(neighbour);
            known != partner.end() && beside_leaders_.at(candidate).count(known->second) > 0)
          return candidate;
    return candidates.front();
  }

 private:
  using Neighbours = std::map<int, std::set<int>>;
  static Neighbours neighbours(const Mesh& mesh, const SideSet& set) {
    Neighbours result;
    for (const Side& side : set.sides) {
      const std::vector<int> nodes = nodes_of_side(mesh, side);
      for (const int node : nodes) result[node].insert(nodes.begin(), nodes.end());
    }
    return result;
  }

  Neighbours beside_, beside_leaders_;
  double slack_;
  bg::index::rtree<PlacedNode, bg::index::rstar<16>> tree_;
};

/// Returns what a node follows, itself if it is not tied.
std::map<int, double> followed(const std::map<int, const Tie*>& ties, int node) {
  const auto tie = ties.find(node);
  if (tie == ties.end()) return {{node, 1.0}};
  std::map<int, double> result;
  for (std::size_t k = 0; k < tie->second->masters.size(); ++k)
    result[tie->second->masters[k]] = tie->second->weights[k];
  return result;
}

}  // namespace

PeriodicNodes make_periodic(Mesh& mesh, const std::string& secondary, const std::string& primary, double tolerance) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; make sides periodic before it is enriched");
  const std::set<int> followers = nodes_of(mesh, side_set_named(mesh, secondary)),
                      leaders = nodes_of(mesh, side_set_named(mesh, primary));
  for (const int node : followers)
    if (leaders.count(node) > 0)
      throw InputError(fmt::format("the side sets \"{}\" and \"{}\" share {}; periodic sides lie apart", secondary,
                                   primary, node_in_words(mesh, node)));
  if (followers.empty() || followers.size() != leaders.size())
    throw InputError(fmt::format(
        "the side set \"{}\" has {} nodes and \"{}\" {}; periodic sides have the same mesh and at least one side",
        secondary, followers.size(), primary, leaders.size()));
  const Vec<3> translation = middle_of(mesh, leaders) - middle_of(mesh, followers);
  const double slack = place_tolerance(mesh), reach = tolerance > 0 ? tolerance : slack;
  const Partners partners(mesh, side_set_named(mesh, secondary), side_set_named(mesh, primary), slack);
  refuse_translation_across_the_axis(mesh, translation, reach);
  std::set<int> tied;
  for (const Tie& tie : mesh.ties) tied.insert(tie.node);
  std::map<int, int> partner, follower;  // of the nodes of the secondary, the primary sides
  std::map<int, std::vector<int>> open;  // nodes with several candidates
  PeriodicNodes left;
  const auto pair = [&](int node, int leader) {
    partner[node] = leader;
    if (const auto [other, is_first] = follower.insert({leader, node}); !is_first)
      throw InputError(
          fmt::format("{} and {} of the side set \"{}\" have the same partner in \"{}\"; the sides differ, or the "
                      "tolerance, {:.3g} L0, is larger than them",
                      node_in_words(mesh, other->second), node_in_words(mesh, node), secondary, primary, reach));
    if (tied.count(node) > 0)
      left.push_back({node, leader});
    else
      mesh.ties.push_back({node, {leader}, {1.0}, false});
  };
  for (const int node : followers) {
    const Vec<3> x = node_place(mesh, node), wanted = x + translation;
    std::vector<int> candidates = partners.nearest(wanted);
    if (const double off = length(node_place(mesh, candidates.front()) - wanted); off > reach)
      throw InputError(
          fmt::format("node {} of the side set \"{}\" at {} has no partner in \"{}\": the nearest node to {} is {:.3g} "
                      "L0 away, and the tolerance is {:.3g} L0. Periodic sides have the same mesh, and are not turned",
                      node + 1, secondary, point_in_words(x, mesh.dimension), primary,
                      point_in_words(wanted, mesh.dimension), off, reach));
    if (candidates.size() == 1)
      pair(node, candidates.front());
    else
      open[node] = std::move(candidates);
  }
  for (const auto& [node, candidates] : open) pair(node, partners.choose(node, candidates, partner));
  require_same_sides(mesh, side_set_named(mesh, secondary), side_set_named(mesh, primary), partner);
  for (const std::set<int>& nodes : {followers, leaders})
    mesh.nodes_of_tied_sides.insert(mesh.nodes_of_tied_sides.end(), nodes.begin(), nodes.end());
  return left;
}

void require_periodic(const Mesh& mesh, const PeriodicNodes& nodes) {
  if (nodes.empty()) return;
  const std::vector<Tie> resolved = resolved_ties(mesh);
  std::map<int, const Tie*> ties;
  for (const Tie& tie : resolved) ties[tie.node] = &tie;
  for (const auto& [node, partner] : nodes) {
    std::map<int, double> difference = followed(ties, node);
    for (const auto& [master, weight] : followed(ties, partner)) difference[master] -= weight;
    for (const auto& [master, rest] : difference)
      if (std::abs(rest) > 1e-10)
        throw InputError(
            fmt::format("{} follows other nodes already: it hangs on a coarser cell, or belongs to a tied surface or "
                        "to other periodic sides; so it cannot move as its partner, {}, too",
                        node_in_words(mesh, node), node_in_words(mesh, partner)));
  }
}

}  // namespace ixos
