/// Quadrilaterals and hexahedra of second order whose contact side is of fourth order.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>

#include "fem/quadratic_elements.hpp"

namespace ixos {

/// Returns the node at the first or the second quarter of an edge. Its value on a quadratic edge is the sum of those of
/// `quadratic`, the first end, the second and the middle, times 3/8, -1/8 and 3/4 at the first quarter.
constexpr InnerNode quarter_point(std::size_t edge, std::size_t node, std::array<std::size_t, 3> quadratic,
                                  bool second) {
  return {edge, node, quadratic[0], quadratic[1], second ? -0.125 : 0.375, second ? 0.375 : -0.125, quadratic[2], 0.75};
}

/// The face of fourth order of a quadratic hexahedron: nodes and functions of LagrangeFace<4>. Along a tied edge the
/// field is quadratic: the nodes at the quarters follow the ends and the middle.
struct QuarticFace : LagrangeFace<4> {
  static constexpr std::array<InnerNode, 8> inner_nodes() {
    std::array<InnerNode, 8> result{};
    for (std::size_t edge = 0; edge < 4; ++edge)
      for (std::size_t k = 0; k < 2; ++k)
        result[2 * edge + k] = quarter_point(edge, 4 + 3 * edge + 2 * k, {edge, (edge + 1) % 4, 5 + 3 * edge}, k == 1);
    return result;
  }
};

/// A quadratic quadrilateral whose side at eta = -1 is of fourth order: N = h_0(eta) L_a(xi) for the five nodes of that
/// side, h_j(eta) q_i(xi) for the others, with q and h the quadratic edge's functions and L those of LagrangeEdge<4>.
/// Its functions contain those of Quad9, and the other sides are quadratic, so it conforms with such neighbours. Node
/// order: those of Quad9, then the two at xi = -1/2 and 1/2 of the side.
struct Quad9C4 {
  using Rich = LagrangeEdge<4>;
  static constexpr int dimension = 2;
  static constexpr int nodes = 11;
  static constexpr std::array<int, 2> default_points{5, 3};

  /// Returns the element's node that is node `a` of the side.
  static constexpr std::size_t edge_node(std::size_t a) {
    constexpr std::array<std::size_t, 5> table{0, 1, 9, 4, 10};
    return table[a];
  }

  /// Returns the reference coordinates of a node.
  static std::array<double, 2> place(std::size_t a) {
    if (a >= 9) return {a == 9 ? -0.5 : 0.5, -1};
    const auto [i, j] = Quad9::factors(a);
    return {Quad9::Edge::node(i), Quad9::Edge::node(j)};
  }

  static void evaluate(const std::array<double, 2>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 2>, nodes>& gradient) {
    std::array<double, 9> plain;
    std::array<std::array<double, 2>, 9> plain_gradient;
    Quad9::evaluate(xi, plain, plain_gradient);
    for (std::size_t a = 0; a < 9; ++a) {
      value[a] = plain[a];
      gradient[a] = plain_gradient[a];
    }
    std::array<double, 5> on_edge;
    std::array<std::array<double, 1>, 5> slope;
    Rich::evaluate({xi[0]}, on_edge, slope);
    const double near = xi[1] * (xi[1] - 1) / 2;
    for (std::size_t a = 0; a < 5; ++a) {
      value[edge_node(a)] = near * on_edge[a];
      gradient[edge_node(a)] = {near * slope[a][0], (xi[1] - 0.5) * on_edge[a]};
    }
  }

  static constexpr std::array<InnerNode, 2> inner_nodes() {
    return {quarter_point(0, 9, {0, 1, 4}, false), quarter_point(0, 10, {0, 1, 4}, true)};
  }
};

/// A quadratic hexahedron whose face at zeta = -1 is of fourth order: N = h_0(zeta) times the functions of QuarticFace
/// for its 25 nodes, those of Hex27 for the others. The face is seen from outside: its coordinates are (eta, xi). Node
/// order: those of Hex27, then the face's other nodes in the face's order. A side that shares an edge with the face is
/// a Quad9C4 (Quad9 if that edge is tied), the far face a LagrangeFace<2>.
struct Hex27C4 {
  using Face = QuarticFace;
  static constexpr int dimension = 3;
  static constexpr int nodes = 43;
  static constexpr std::array<int, 3> default_points{5, 5, 3};

  /// Returns the element's node that is node `a` of the face.
  static constexpr std::size_t face_node(std::size_t a) {
    if (a < 4) return a == 1 ? 3 : a == 3 ? 1 : a;
    if (a < 16) {
      const std::size_t edge = (a - 4) / 3, k = (a - 4) % 3;
      return k == 1 ? 11 - edge : 27 + 2 * edge + k / 2;
    }
    return a == 20 ? 21 : a < 20 ? a + 19 : a + 18;
  }

  /// Returns the reference coordinates of a node.
  static std::array<double, 3> place(std::size_t a) {
    for (std::size_t b = 0; b < 25; ++b)
      if (face_node(b) == a) {
        const auto [j, i] = Face::factors(b);
        return {Face::Edge::node(i), Face::Edge::node(j), -1};
      }
    const auto [i, j, k] = Hex27::factors(a);
    return {Hex27::Edge::node(i), Hex27::Edge::node(j), Hex27::Edge::node(k)};
  }

  static void evaluate(const std::array<double, 3>& xi, std::array<double, nodes>& value,
                       std::array<std::array<double, 3>, nodes>& gradient) {
    std::array<double, 27> plain;
    std::array<std::array<double, 3>, 27> plain_gradient;
    Hex27::evaluate(xi, plain, plain_gradient);
    for (std::size_t a = 0; a < 27; ++a) {
      value[a] = plain[a];
      gradient[a] = plain_gradient[a];
    }
    std::array<double, 25> on_face;
    std::array<std::array<double, 2>, 25> slope;
    Face::evaluate({xi[1], xi[0]}, on_face, slope);
    const double near = xi[2] * (xi[2] - 1) / 2;
    for (std::size_t a = 0; a < 25; ++a) {
      value[face_node(a)] = near * on_face[a];
      gradient[face_node(a)] = {near * slope[a][1], near * slope[a][0], (xi[2] - 0.5) * on_face[a]};
    }
  }

  static constexpr std::array<InnerNode, 8> inner_nodes() {
    auto inner = Face::inner_nodes();
    for (InnerNode& node : inner) {
      node.node = face_node(node.node);
      node.first = face_node(node.first);
      node.second = face_node(node.second);
      node.middle = face_node(node.middle);
    }
    return inner;
  }
};

}  // namespace ixos
