/// Edges of enriched elements kept straight, so that neighbours which are not enriched conform.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>

namespace ixos {

/// A node that only bends its enriched edge, and its value if the field is linear along the edge, or quadratic.
struct InnerNode {
  std::size_t edge;  ///< the element's edge, from 0
  std::size_t node;
  std::size_t first, second;         ///< the edge's ends
  double first_share, second_share;  ///< the node's value is the sum of the ends' times these
  std::size_t middle = 0;            ///< the edge's middle, if it stays a node
  double middle_share = 0;           ///< and its share; 0: the field is linear along the edge
};

/// Returns a node at a point of the edge, `place` from 0 at the first end to 1 at the second.
constexpr InnerNode inner_point(std::size_t edge, std::size_t node, std::size_t first, std::size_t second,
                                double place) {
  return {edge, node, first, second, 1 - place, place};
}

/// Returns the derivative along an edge whose coordinate goes from -1 at the first end to 1 at the second.
constexpr InnerNode inner_derivative(std::size_t edge, std::size_t node, std::size_t first, std::size_t second) {
  return {edge, node, first, second, -0.5, 0.5};
}

/// Whether the element lists inner_nodes() of its edges.
template <class Element, class = void>
struct HasInnerNodes : std::false_type {};
template <class Element>
struct HasInnerNodes<Element, std::void_t<decltype(Element::inner_nodes())>> : std::true_type {};

/// Evaluates the shape functions of an element with tied edges: bit k of `tied` stands for the k-th edge. The field is
/// linear along a tied edge, in quadratic cells quadratic. The functions of the edge's inner nodes are added to those
/// of its ends (and middle) in proportion, then set to zero: whatever number stands for such a node in a cell, its
/// field does not count, and it gets no force, mass or stiffness. This is T^T K T for the relation T between tied and
/// free nodes, done once, in the shape functions.
template <class Element>
void evaluate_tied(unsigned tied, const std::array<double, Element::dimension>& xi,
                   std::array<double, Element::nodes>& value,
                   std::array<std::array<double, Element::dimension>, Element::nodes>& gradient) {
  Element::evaluate(xi, value, gradient);
  if constexpr (HasInnerNodes<Element>::value) {
    if (tied == 0) return;
    for (const InnerNode& inner : Element::inner_nodes()) {
      if ((tied >> inner.edge & 1U) == 0) continue;
      const auto move = [&](std::size_t end, double share) {
        value[end] += share * value[inner.node];
        for (std::size_t d = 0; d < gradient[end].size(); ++d) gradient[end][d] += share * gradient[inner.node][d];
      };
      move(inner.first, inner.first_share);
      move(inner.second, inner.second_share);
      if (inner.middle_share != 0) move(inner.middle, inner.middle_share);
      value[inner.node] = 0;
      gradient[inner.node] = {};
    }
  }
}

}  // namespace ixos
