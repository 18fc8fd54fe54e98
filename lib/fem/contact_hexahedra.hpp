/// Hexahedra whose contact face is richer than bilinear (Sauer 2011, Int. J. Numer. Methods Eng. 87).
#pragma once
#include <array>
#include <cstddef>

#include "fem/contact_elements.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

/// Evaluates shape functions that are products of those of a face's two edges, along xi and along eta: Face::factors().
template <class Face>
void evaluate_products(const std::array<double, 2>& xi, std::array<double, Face::nodes>& value,
                       std::array<std::array<double, 2>, Face::nodes>& gradient) {
  using Edge = typename Face::Edge;
  std::array<std::array<double, Edge::nodes>, 2> on_edge;
  std::array<std::array<std::array<double, 1>, Edge::nodes>, 2> slope;
  for (std::size_t d = 0; d < 2; ++d) Edge::evaluate({xi[d]}, on_edge[d], slope[d]);
  for (std::size_t a = 0; a < Face::nodes; ++a) {
    const auto [i, j] = Face::factors(a);
    value[a] = on_edge[0][i] * on_edge[1][j];
    gradient[a] = {slope[0][i][0] * on_edge[1][j], on_edge[0][i] * slope[1][j][0]};
  }
}

/// Quadrilateral of order q in both directions, equally spaced nodes: the four corners, the inner nodes of the edges
/// 0-1, 1-2, 2-3 and 3-0, each in that direction, then the interior's row by row, xi fastest. The product of two
/// LagrangeEdge.
template <int Order>
struct LagrangeFace {
  using Edge = LagrangeEdge<Order>;
  static constexpr int dimension = 2;
  static constexpr int nodes = (Order + 1) * (Order + 1);
  static constexpr std::array<int, 2> default_points{Order + 1, Order + 1};
  static constexpr std::size_t inner = Order - 1;  ///< nodes inside an edge

  /// Returns the nodes of the two edges, along xi and along eta, whose functions' product is node `a`'s.
  static constexpr std::array<std::size_t, 2> factors(std::size_t a) {
    if (a < 4) return {a == 1 || a == 2 ? 1U : 0U, a / 2};
    const std::size_t edge = (a - 4) / inner, k = (a - 4) % inner;
    if (edge == 0) return {2 + k, 0};
    if (edge == 1) return {1, 2 + k};
    if (edge == 2) return {1 + inner - k, 1};
    if (edge == 3) return {0, 1 + inner - k};
    const std::size_t i = a - 4 - 4 * inner;
    return {2 + i % inner, 2 + i / inner};
  }

  static void evaluate(const std::array<double, 2>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 2>, nodes>& gradient) {
    evaluate_products<LagrangeFace>(xi, value, gradient);
  }

  static constexpr std::array<InnerNode, 4 * inner> inner_nodes() {
    std::array<InnerNode, 4 * inner> result{};
    for (std::size_t k = 0; k < result.size(); ++k) {
      const std::size_t edge = k / inner, step = k % inner + 1;
      result[k] = inner_point(edge, k + 4, edge, (edge + 1) % 4, static_cast<double>(step) / Order);
    }
    return result;
  }
};

/// Bicubic Hermite quadrilateral: values at the four corners, then at each corner the derivatives d/dxi, d/deta and
/// d2/dxi deta. The product of two HermiteEdge. The map of uneven faces is bicubic too: with five points a direction
/// constant stress is integrated exactly, of degree 8.
struct HermiteFace {
  using Edge = HermiteEdge;
  static constexpr int dimension = 2;
  static constexpr int nodes = 16;
  static constexpr std::array<int, 2> default_points{5, 5};

  /// Returns the nodes of the two edges, see LagrangeFace::factors().
  static constexpr std::array<std::size_t, 2> factors(std::size_t a) {
    const std::size_t corner = a < 4 ? a : (a - 4) / 3, kind = a < 4 ? 3 : (a - 4) % 3;
    const std::size_t i = corner == 1 || corner == 2 ? 1 : 0, j = corner / 2;
    return {kind == 0 || kind == 2 ? i + 2 : i, kind == 1 || kind == 2 ? j + 2 : j};
  }

  static void evaluate(const std::array<double, 2>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 2>, nodes>& gradient) {
    evaluate_products<HermiteFace>(xi, value, gradient);
  }

  /// Returns the derivatives along each edge at its ends. The derivatives across it and the mixed ones do not bend it.
  static constexpr std::array<InnerNode, 8> inner_nodes() {
    return {inner_derivative(0, 4, 0, 1),  inner_derivative(0, 7, 0, 1),   //
            inner_derivative(1, 8, 1, 2),  inner_derivative(1, 11, 1, 2),  //
            inner_derivative(2, 10, 3, 2), inner_derivative(2, 13, 3, 2),  //
            inner_derivative(3, 5, 0, 3),  inner_derivative(3, 14, 0, 3)};
  }
};

/// A hexahedron with the face at zeta = -1: N = (1 - zeta)/2 face for the face's nodes, (1 + zeta)/2 times the bilinear
/// functions for the four nodes opposite. The face is seen from outside: its coordinates are (eta, xi). Node order:
/// those of the trilinear hexahedron, then the face's other nodes in the face's order. A side that shares an edge with
/// the face is a ContactQuad (bilinear if that edge is tied), the far face bilinear.
template <class Face>
struct ContactHex {
  static constexpr int dimension = 3;
  static constexpr int nodes = Face::nodes + 4;
  static constexpr std::array<int, 3> default_points{Face::default_points[1], Face::default_points[0], 2};

  /// Returns the element's node that is node `a` of the face.
  static constexpr std::size_t face_node(std::size_t a) { return a >= 4 ? a + 4 : a == 1 ? 3 : a == 3 ? 1 : a; }

  static void evaluate(const std::array<double, 3>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 3>, nodes>& gradient) {
    const double near = (1 - xi[2]) / 2, far = (1 + xi[2]) / 2;
    std::array<double, Face::nodes> on_face;
    std::array<std::array<double, 2>, Face::nodes> slope;
    Face::evaluate({xi[1], xi[0]}, on_face, slope);
    for (std::size_t a = 0; a < Face::nodes; ++a) {
      value[face_node(a)] = near * on_face[a];
      gradient[face_node(a)] = {near * slope[a][1], near * slope[a][0], -on_face[a] / 2};
    }
    std::array<double, 4> opposite;
    std::array<std::array<double, 2>, 4> incline;
    Quad4::evaluate({xi[0], xi[1]}, opposite, incline);
    for (std::size_t a = 0; a < 4; ++a) {
      value[a + 4] = far * opposite[a];
      gradient[a + 4] = {far * incline[a][0], far * incline[a][1], opposite[a] / 2};
    }
  }

  static constexpr auto inner_nodes() {
    auto inner = Face::inner_nodes();
    for (InnerNode& node : inner)
      node = {node.edge,
              face_node(node.node),
              face_node(node.first),
              face_node(node.second),
              node.first_share,
              node.second_share,
              0,
              0};
    return inner;
  }
};

using Hex8C2 = ContactHex<LagrangeFace<2>>;
using Hex8C3 = ContactHex<LagrangeFace<3>>;
using Hex8C4 = ContactHex<LagrangeFace<4>>;
using Hex8CH = ContactHex<HermiteFace>;

template <>
struct IsHermite<HermiteFace> : std::true_type {};
template <>
struct IsHermite<Hex8CH> : std::true_type {};

}  // namespace ixos
