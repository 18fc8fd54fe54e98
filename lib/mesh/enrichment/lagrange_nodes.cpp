#include <map>
#include <set>

#include "mesh/cell_sides.hpp"
#include "mesh/enrichment/contact_nodes.hpp"

namespace ixos {
namespace {

class LagrangeNodes {
 public:
  LagrangeNodes(Mesh& mesh, const SideSet& set, int order) : mesh_(mesh), set_(set), inner_(order - 1) {}

  std::vector<ExtraNodes> add() {
    if (mesh_.dimension == 3) tied_ = tied_edges(mesh_, set_);
    std::vector<ExtraNodes> result;
    for (const Side& side : set_.sides) {
      const std::vector<int> corners = nodes_of_side(mesh_, side);
      const std::size_t edges = corners.size() == 2 ? 1 : corners.size();
      ExtraNodes extra;
      for (std::size_t k = 0; k < edges; ++k) add_edge(corners[k], corners[(k + 1) % corners.size()], k, extra);
      if (corners.size() == 4) add_interior(corners, extra);
      result.push_back(std::move(extra));
    }
    complete_node_sets(mesh_, added_);
    return result;
  }

 private:
  void add_edge(int first, int second, std::size_t number, ExtraNodes& extra) {
    if (tied_.count(edge_key(first, second)) != 0) {
      extra.tied |= 1U << number;
      extra.nodes.insert(extra.nodes.end(), static_cast<std::size_t>(inner_), first);
      return;
    }
    const auto [known, is_new] = edges_.try_emplace(edge_key(first, second));
    Between& edge = known->second;
    if (is_new) {
      edge.corners = {first, second};
      for (int k = 1; k <= inner_; ++k) {
        const double t = static_cast<double>(k) / (inner_ + 1);
        edge.nodes.push_back(add_point(edge.corners, {1 - t, t}));
      }
      added_.push_back(edge);
    }
    if (edge.corners[0] == first)
      extra.nodes.insert(extra.nodes.end(), edge.nodes.begin(), edge.nodes.end());
    else
      extra.nodes.insert(extra.nodes.end(), edge.nodes.rbegin(), edge.nodes.rend());
  }

  void add_interior(const std::vector<int>& corners, ExtraNodes& extra) {
    Between face{corners, {}};
    for (int j = 1; j <= inner_; ++j)
      for (int i = 1; i <= inner_; ++i) {
        const double s = static_cast<double>(i) / (inner_ + 1), t = static_cast<double>(j) / (inner_ + 1);
        face.nodes.push_back(add_point(corners, {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}));
      }
    extra.nodes.insert(extra.nodes.end(), face.nodes.begin(), face.nodes.end());
    added_.push_back(std::move(face));
  }

  int add_point(const std::vector<int>& corners, const std::vector<double>& weights) {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::vector<double> x(d, 0.0);
    for (std::size_t a = 0; a < corners.size(); ++a)
      for (std::size_t i = 0; i < d; ++i)
        x[i] += weights[a] * mesh_.coordinates[static_cast<std::size_t>(corners[a]) * d + i];
    return add_node(mesh_, x, -1);
  }

  Mesh& mesh_;
  const SideSet& set_;
  int inner_;                      ///< nodes inside an edge
  std::set<Edge> tied_;            ///< get no nodes
  std::map<Edge, Between> edges_;  ///< an edge's nodes, in the direction in which it was met first
  std::vector<Between> added_;
};

}  // namespace

std::vector<ExtraNodes> add_lagrange_nodes(Mesh& mesh, const SideSet& set, int order) {
  return LagrangeNodes(mesh, set, order).add();
}

}  // namespace ixos
