#include <map>
#include <utility>

#include "mesh/cell_sides.hpp"
#include "mesh/enrichment/contact_nodes.hpp"

namespace ixos {
namespace {

/// Edges of this file are pairs of nodes counter-clockwise seen from outside.
class HermiteNodes {
 public:
  HermiteNodes(Mesh& mesh, const SideSet& set) : mesh_(mesh), set_(set) {}

  std::vector<ExtraNodes> add() {
    std::vector<Edge> edges;
    for (const Side& side : set_.sides) {
      const std::vector<int> ends = nodes_of_side(mesh_, side);
      edges.emplace_back(ends[0], ends[1]);
      previous_[ends[1]] = ends[0];
      next_[ends[0]] = ends[1];
    }
    std::vector<ExtraNodes> result;
    std::vector<Between> added;
    for (const Edge& edge : edges) {
      ExtraNodes extra;
      for (int node : {edge.first, edge.second}) {
        extra.nodes.push_back(derivative_node(node));
        extra.derivative_scale.push_back(length(mesh_, edge) / nodal_length(node));
      }
      added.push_back({{edge.first, edge.second}, extra.nodes});
      result.push_back(std::move(extra));
    }
    complete_node_sets(mesh_, added);
    return result;
  }

 private:
  /// Returns the node's neighbours along the set; at an end of the set, the node itself.
  Edge neighbours(int node) const {
    const auto before = previous_.find(node), after = next_.find(node);
    return {before == previous_.end() ? node : before->second, after == next_.end() ? node : after->second};
  }

  /// Returns the length that scales a node's derivative: the mean of its two sides' lengths.
  double nodal_length(int node) const {
    const auto [before, after] = neighbours(node);
    const double lengths = length(mesh_, {before, node}) + length(mesh_, {node, after});
    return before == node || after == node ? lengths : lengths / 2;
  }

  int derivative_node(int node) {
    const auto known = derivative_nodes_.find(node);
    if (known != derivative_nodes_.end()) return known->second;
    const auto [before, after] = neighbours(node);
    const double spans = before == node || after == node ? 1 : 2;
    std::vector<double> tangent(2);  // dX/dxi of a side of the nodal length
    for (std::size_t i = 0; i < 2; ++i)
      tangent[i] = (mesh_.coordinates[2 * static_cast<std::size_t>(after) + i] -
                    mesh_.coordinates[2 * static_cast<std::size_t>(before) + i]) /
                   (2 * spans);
    return derivative_nodes_[node] = add_node(mesh_, tangent, node);
  }

  Mesh& mesh_;
  const SideSet& set_;
  std::map<int, int> previous_, next_;  ///< along the set
  std::map<int, int> derivative_nodes_;
};

}  // namespace

std::vector<ExtraNodes> add_hermite_nodes(Mesh& mesh, const SideSet& set) { return HermiteNodes(mesh, set).add(); }

}  // namespace ixos
