#include "geometry/lagrange_patches.hpp"

#include <stdexcept>

#include "fem/contact_elements.hpp"
#include "fem/contact_hexahedra.hpp"
#include "fem/enriched_cell.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Returns, by node of the edge, the coefficients of its polynomial on [0, 1] by power.
template <int Order>
std::vector<std::vector<double>> edge_polynomials() {
  using Edge = LagrangeEdge<Order>;
  std::vector<double> places;
  for (std::size_t a = 0; a < Edge::nodes; ++a) places.push_back((1 + Edge::node(a)) / 2);
  return lagrange_polynomials(places);
}

/// Returns the coefficients of a node's function, by power.
template <std::size_t D, int Order>
std::vector<double> function_of(std::size_t node) {
  static const std::vector<std::vector<double>> polynomials = edge_polynomials<Order>();
  if constexpr (D == 2) {
    return polynomials[node];
  } else {
    std::vector<double> result;
    const auto [i, j] = LagrangeFace<Order>::factors(node);
    for (const double by_second : polynomials[j])
      for (const double by_first : polynomials[i]) result.push_back(by_first * by_second);
    return result;
  }
}

template <std::size_t D, int Order>
SurfacePatch<D> patch_of(const std::vector<int>& nodes, const std::vector<InnerNode>& tied) {
  std::vector<std::vector<double>> functions;
  for (std::size_t a = 0; a < nodes.size(); ++a) functions.push_back(function_of<D, Order>(a));
  for (const InnerNode& inner : tied) {
    const auto move = [&](std::size_t end, double share) {
      for (std::size_t k = 0; k < functions[end].size(); ++k) functions[end][k] += share * functions[inner.node][k];
    };
    move(inner.first, inner.first_share);
    move(inner.second, inner.second_share);
    if (inner.middle_share != 0) move(inner.middle, inner.middle_share);
    functions[inner.node].clear();
  }
  SurfacePatch<D> patch;
  patch.degree = Order;
  std::vector<double> by_node;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    if (functions[a].empty()) continue;
    patch.nodes[patch.count++] = nodes[a];
    by_node.insert(by_node.end(), functions[a].begin(), functions[a].end());
  }
  patch.set_functions(by_node);
  return patch;
}

}  // namespace

std::vector<std::vector<double>> lagrange_polynomials(const std::vector<double>& places) {
  std::vector<std::vector<double>> result;
  for (std::size_t a = 0; a < places.size(); ++a) {
    std::vector<double> polynomial{1};  // the product of (t - t_b)/(t_a - t_b)
    for (std::size_t b = 0; b < places.size(); ++b) {
      if (b == a) continue;
      const double span = places[a] - places[b];
      std::vector<double> next(polynomial.size() + 1, 0.0);
      for (std::size_t k = 0; k < polynomial.size(); ++k) {
        next[k] -= polynomial[k] * places[b] / span;
        next[k + 1] += polynomial[k] / span;
      }
      polynomial = std::move(next);
    }
    result.push_back(polynomial);
  }
  return result;
}

template <std::size_t D>
SurfacePatch<D> lagrange_patch(const std::vector<int>& nodes, const std::vector<InnerNode>& tied) {
  for (const int order : {2, 3, 4}) {
    const auto along = static_cast<std::size_t>(order) + 1;
    if (nodes.size() != (D == 2 ? along : along * along)) continue;
    if (order == 2) return patch_of<D, 2>(nodes, tied);
    if (order == 3) return patch_of<D, 3>(nodes, tied);
    return patch_of<D, 4>(nodes, tied);
  }
  throw std::logic_error("no side has that number of nodes");
}

std::vector<InnerNode> tied_nodes(const LocalBlock& block, int side) {
  std::vector<InnerNode> result;
  const unsigned ties = side_ties(block, side);
  if (ties == 0) return result;
  with_side_element(block.type, side, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    if constexpr (HasInnerNodes<Element>::value)
      for (const InnerNode& inner : Element::inner_nodes())
        if ((ties >> inner.edge & 1U) != 0) result.push_back(inner);
  });
  return result;
}

template SurfacePatch<2> lagrange_patch<2>(const std::vector<int>&, const std::vector<InnerNode>&);
template SurfacePatch<3> lagrange_patch<3>(const std::vector<int>&, const std::vector<InnerNode>&);

}  // namespace ixos
