/// Quadrilaterals whose contact side is richer than linear (Sauer 2011, Int. J. Numer. Methods Eng. 87).
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>

#include "fem/ties.hpp"

namespace ixos {

/// Edge of order q with equally spaced nodes: the two ends first, then the inner nodes from xi = -1 to 1.
template <int Order>
struct LagrangeEdge {
  static constexpr int dimension = 1;
  static constexpr int nodes = Order + 1;
  static constexpr std::array<int, 1> default_points{Order + 1};

  static constexpr double node(std::size_t a) {
    return a == 0 ? -1.0 : a == 1 ? 1.0 : -1.0 + 2.0 * static_cast<double>(a - 1) / Order;
  }

  static void evaluate(const std::array<double, 1>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 1>, nodes>& gradient) {
    for (std::size_t a = 0; a < nodes; ++a) {
      value[a] = 1;
      gradient[a][0] = 0;
      for (std::size_t b = 0; b < nodes; ++b) {
        if (b == a) continue;
        const double span = node(a) - node(b);
        gradient[a][0] = (gradient[a][0] * (xi[0] - node(b)) + value[a]) / span;
        value[a] *= (xi[0] - node(b)) / span;
      }
    }
  }

  static constexpr std::array<InnerNode, Order - 1> inner_nodes() {
    std::array<InnerNode, Order - 1> inner{};
    for (std::size_t k = 0; k < inner.size(); ++k) inner[k] = inner_point(0, k + 2, 0, 1, (1 + node(k + 2)) / 2);
    return inner;
  }
};

/// Cubic Hermite edge: values at the two ends, then derivatives d/dxi at the two ends.
struct HermiteEdge {
  static constexpr int dimension = 1;
  static constexpr int nodes = 4;
  static constexpr std::array<int, 1> default_points{4};

  static void evaluate(const std::array<double, 1>& xi, std::array<double, 4>& value,
                       std::array<std::array<double, 1>, 4>& gradient) {
    const double x = xi[0];
    value = {(2 - 3 * x + x * x * x) / 4, (2 + 3 * x - x * x * x) / 4, (1 - x - x * x + x * x * x) / 4,
             (-1 - x + x * x + x * x * x) / 4};
    gradient = {
        {{3 * (x * x - 1) / 4}, {3 * (1 - x * x) / 4}, {(3 * x * x - 2 * x - 1) / 4}, {(3 * x * x + 2 * x - 1) / 4}}};
  }

  static constexpr std::array<InnerNode, 2> inner_nodes() {
    return {inner_derivative(0, 2, 0, 1), inner_derivative(0, 3, 0, 1)};
  }
};

/// A quadrilateral with the edge at eta = -1: N = (1 - eta)/2 edge(xi) for the edge's nodes, (1 + eta)/2 (1 +- xi)/2
/// for the two nodes opposite. Node order: edge ends, opposite nodes, the edge's other nodes; the first four are those
/// of the bilinear quadrilateral. Side edges stay linear, so it conforms with bilinear neighbours.
template <class Edge>
struct ContactQuad {
  static constexpr int dimension = 2;
  static constexpr int nodes = Edge::nodes + 2;
  static constexpr std::array<int, 2> default_points{Edge::default_points[0], 2};

  /// Returns the element's node that is node `a` of the edge.
  static constexpr std::size_t edge_node(std::size_t a) { return a < 2 ? a : a + 2; }

  static void evaluate(const std::array<double, 2>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 2>, nodes>& gradient) {
    std::array<double, Edge::nodes> on_edge;
    std::array<std::array<double, 1>, Edge::nodes> slope;
    Edge::evaluate({xi[0]}, on_edge, slope);
    const double near = (1 - xi[1]) / 2, far = (1 + xi[1]) / 2;
    for (std::size_t a = 0; a < Edge::nodes; ++a) {
      value[edge_node(a)] = near * on_edge[a];
      gradient[edge_node(a)] = {near * slope[a][0], -on_edge[a] / 2};
    }
    const double right = (1 + xi[0]) / 2, left = (1 - xi[0]) / 2;
    value[2] = far * right;
    value[3] = far * left;
    gradient[2] = {far / 2, right / 2};
    gradient[3] = {-far / 2, left / 2};
  }

  static constexpr auto inner_nodes() {
    auto inner = Edge::inner_nodes();
    for (InnerNode& node : inner) node.node = edge_node(node.node);
    return inner;
  }
};

using Quad4C2 = ContactQuad<LagrangeEdge<2>>;
using Quad4C3 = ContactQuad<LagrangeEdge<3>>;
using Quad4C4 = ContactQuad<LagrangeEdge<4>>;
using Quad4CH = ContactQuad<HermiteEdge>;

/// Whether the element's nodes beyond its corners are derivatives.
template <class Element>
struct IsHermite : std::bool_constant<std::is_same_v<Element, HermiteEdge> || std::is_same_v<Element, Quad4CH>> {};

}  // namespace ixos
