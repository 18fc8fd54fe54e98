#include "mesh/mortar/mortar_weights.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "mesh/mortar/mortar_sums.hpp"

namespace ixos {
namespace {

using NodeWeights = std::map<int, std::map<int, double>>;

/// Returns the corners that both curves have, and the nodes of the primary curve there, the nearest within reach.
NodeWeights common_ends(const MortarSurfaces& curves) {
  std::map<int, double> reach;  // by node
  for (const Facet& curve : curves.secondary)
    for (std::size_t a = 0; a < 2; ++a) {
      double& own = reach[curve.nodes()[a]];
      own = own > 0 ? std::min(own, curves.reach(curve)) : curves.reach(curve);
    }
  NodeWeights found;
  const std::vector<FacetEnd> primary = curve_ends(curves.primary);
  for (const FacetEnd& end : curve_ends(curves.secondary)) {
    double nearest = reach.at(end.node);
    for (const FacetEnd& other : primary)
      if (const double distance = length(other.place - end.place); distance <= nearest) {
        nearest = distance;
        found[end.node] = {{other.node, 1.0}};
      }
  }
  return found;
}

/// Returns the weights of the nodes on the part of the boundary that both surfaces share.
NodeWeights common_boundary(const MortarSurfaces& surfaces) {
  if (surfaces.secondary.front().dimension() == 1) return common_ends(surfaces);
  MortarSurfaces edges{boundary_edges(surfaces.secondary), boundary_edges(surfaces.primary), false, surfaces.reach};
  const std::vector<FacingParts> all = all_facing_parts(edges);
  std::vector<Facet> shared;
  std::vector<FacingParts> parts;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (is_covered(all[k], false)) {
      shared.push_back(edges.secondary[k]);
      parts.push_back(all[k]);
    }
  if (shared.empty()) return {};
  edges.secondary = shared;
  const MortarWeights weights = mortar_weights(edges, parts);
  return weights.failed == nullptr ? weights.of_node : NodeWeights();  // else the boundary follows the surface
}

/// Returns, by node of the boundary, its nearest neighbours inside; empty if one of them has none.
std::map<int, std::set<int>> heirs_of(const std::vector<Facet>& facets, const NodeWeights& boundary) {
  std::map<int, std::set<int>> heirs;
  for (const auto& entry : boundary) heirs[entry.first];
  for (const Facet& facet : facets)
    for (const int node : facet.nodes()) {
      const auto found = heirs.find(node);
      if (found == heirs.end()) continue;
      for (const int other : facet.nodes())
        if (heirs.count(other) == 0) found->second.insert(other);
    }
  // A triangle in a corner of the surface has all its nodes on the boundary: their neighbours' heirs are theirs.
  for (bool grows = true; grows;) {
    grows = false;
    for (const Facet& facet : facets)
      for (const int node : facet.nodes()) {
        const auto found = heirs.find(node);
        if (found == heirs.end() || !found->second.empty()) continue;
        for (const int other : facet.nodes())
          if (const auto neighbour = heirs.find(other); neighbour != heirs.end())
            found->second.insert(neighbour->second.begin(), neighbour->second.end());
        grows = grows || !found->second.empty();
      }
  }
  for (const auto& entry : heirs)
    if (entry.second.empty()) return {};
  return heirs;
}

void add(double factor, const std::map<int, double>& from, std::map<int, double>& to) {
  for (const auto& [node, value] : from) to[node] += factor * value;
}

}  // namespace

std::vector<FacingParts> all_facing_parts(const MortarSurfaces& surfaces) {
  const FacingFacets facing(surfaces.primary);
  std::vector<FacingParts> parts;
  parts.reserve(surfaces.secondary.size());
  for (const Facet& facet : surfaces.secondary) parts.push_back(facing.parts_of(facet, surfaces.reach(facet)));
  return parts;
}

bool is_covered(const FacingParts& parts, bool at_rim) {
  constexpr double rounding = 1e-5, chords = 0.1;
  return parts.covered <= 1 + rounding && parts.covered >= 1 - (at_rim ? chords : rounding);
}

std::vector<bool> facets_at_rim(const std::vector<Facet>& facets) {
  std::vector<bool> at_rim(facets.size(), false);
  if (facets.front().dimension() == 1) return at_rim;
  std::set<std::pair<int, int>> rim;
  for (const Facet& edge : boundary_edges(facets)) rim.insert(std::minmax(edge.nodes()[0], edge.nodes()[1]));
  for (std::size_t k = 0; k < facets.size(); ++k)
    for (const Facet& edge : facets[k].edges())
      if (rim.count(std::minmax(edge.nodes()[0], edge.nodes()[1])) > 0) at_rim[k] = true;
  return at_rim;
}

MortarWeights mortar_weights(const MortarSurfaces& surfaces, const std::vector<FacingParts>& parts) {
  MortarSums sums(surfaces.axisymmetric);
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (!sums.add(surfaces.secondary[k], parts[k].parts)) return {{}, &surfaces.secondary[k]};
  const NodeWeights boundary = common_boundary(surfaces);
  const std::map<int, std::set<int>> heirs = heirs_of(surfaces.secondary, boundary);

  MortarWeights result;
  for (const auto& [node, area] : sums.areas())
    if (heirs.count(node) == 0) add(1 / area, sums.products().at(node), result.of_node[node]);
  for (const auto& [node, own] : heirs) {
    const std::map<int, double>& weights = boundary.at(node);
    for (const int heir : own) {
      const double share = 1 / (static_cast<double>(own.size()) * sums.areas().at(heir));
      add(share, sums.products().at(node), result.of_node[heir]);
      add(-share * sums.areas().at(node), weights, result.of_node[heir]);
    }
    result.of_node[node] = weights;
  }
  return result;
}

}  // namespace ixos
