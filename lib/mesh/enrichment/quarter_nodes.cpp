#include <map>

#include "fem/cell_type.hpp"
#include "fem/quadratic_elements.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/enrichment/contact_nodes.hpp"

namespace ixos {
namespace {

/// The values of a quadratic side's functions at a point.
template <class Side, std::size_t D = Side::dimension>
std::vector<double> shares_at(const std::array<double, D>& xi) {
  std::array<double, Side::nodes> value;
  std::array<std::array<double, D>, Side::nodes> gradient;
  Side::evaluate(xi, value, gradient);
  return {value.begin(), value.end()};
}

class QuarterNodes {
 public:
  QuarterNodes(Mesh& mesh, const SideSet& set) : mesh_(mesh), set_(set) {}

  std::vector<ExtraNodes> add() {
    if (mesh_.dimension == 3) tied_ = tied_edges(mesh_, set_);
    std::vector<ExtraNodes> result;
    for (const Side& side : set_.sides) {
      const std::vector<int> nodes = nodes_of_side(mesh_, side);
      ExtraNodes extra;
      if (mesh_.dimension == 2) {
        add_edge({nodes[0], nodes[1], nodes[2]}, 0, extra);
      } else {
        for (std::size_t k = 0; k < 4; ++k) add_edge({nodes[k], nodes[(k + 1) % 4], nodes[4 + k]}, k, extra);
        add_interior(nodes, extra);
      }
      result.push_back(std::move(extra));
    }
    complete_node_sets(mesh_, added_);
    return result;
  }

 private:
  /// Adds the nodes of an edge, given by its ends and its middle.
  void add_edge(const std::vector<int>& quadratic, std::size_t number, ExtraNodes& extra) {
    const int first = quadratic[0];
    if (tied_.count(edge_key(first, quadratic[1])) != 0) {
      extra.tied |= 1U << number;
      extra.nodes.insert(extra.nodes.end(), 2, first);
      return;
    }
    const auto [known, is_new] = edges_.try_emplace(edge_key(first, quadratic[1]));
    Between& edge = known->second;
    if (is_new) {
      edge.corners = quadratic;
      for (const double xi : {-0.5, 0.5}) edge.nodes.push_back(add_point(quadratic, shares_at<LagrangeEdge<2>>({xi})));
      added_.push_back(edge);
    }
    if (edge.corners[0] == first)
      extra.nodes.insert(extra.nodes.end(), edge.nodes.begin(), edge.nodes.end());
    else
      extra.nodes.insert(extra.nodes.end(), edge.nodes.rbegin(), edge.nodes.rend());
  }

  void add_interior(const std::vector<int>& quadratic, ExtraNodes& extra) {
    Between face{quadratic, {}};
    for (const double eta : {-0.5, 0.0, 0.5})
      for (const double xi : {-0.5, 0.0, 0.5})
        if (xi != 0 || eta != 0) face.nodes.push_back(add_point(quadratic, shares_at<LagrangeFace<2>>({xi, eta})));
    extra.nodes.insert(extra.nodes.end(), face.nodes.begin(), face.nodes.end());
    added_.push_back(std::move(face));
  }

  int add_point(const std::vector<int>& nodes, const std::vector<double>& weights) {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::vector<double> x(d, 0.0);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t i = 0; i < d; ++i)
        x[i] += weights[a] * mesh_.coordinates[static_cast<std::size_t>(nodes[a]) * d + i];
    return add_node(mesh_, x, -1);
  }

  Mesh& mesh_;
  const SideSet& set_;
  std::set<Edge> tied_;            ///< get no nodes
  std::map<Edge, Between> edges_;  ///< an edge's nodes, in the direction in which it was met first
  std::vector<Between> added_;
};

}  // namespace

std::vector<ExtraNodes> add_quarter_nodes(Mesh& mesh, const SideSet& set) { return QuarterNodes(mesh, set).add(); }

}  // namespace ixos
