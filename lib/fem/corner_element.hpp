/// The linear element on the corners of a quadratic one.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "fem/cells/prisms.hpp"
#include "fem/cells/pyramids.hpp"
#include "fem/cells/tetrahedra.hpp"
#include "fem/cells/triangles.hpp"
#include "fem/quadratic_contact_elements.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

/// The type of the linear element whose nodes are the corners of a quadratic element; void for other elements.
template <class Element>
struct CornerElement {
  using type = void;
};
template <>
struct CornerElement<LagrangeEdge<2>> {
  using type = Line2;
};
template <>
struct CornerElement<Quad9> {
  using type = Quad4;
};
template <>
struct CornerElement<Hex27> {
  using type = Hex8;
};
template <>
struct CornerElement<LagrangeEdge<4>> {
  using type = Line2;
};
template <>
struct CornerElement<QuarticFace> {
  using type = Quad4;
};
template <>
struct CornerElement<Quad9C4> {
  using type = Quad4;
};
template <>
struct CornerElement<Hex27C4> {
  using type = Hex8;
};

template <>
struct CornerElement<Tri6> {
  using type = Tri3;
};
template <>
struct CornerElement<Tri7> {
  using type = Tri3;
};
template <>
struct CornerElement<Tet10> {
  using type = Tet4;
};
template <>
struct CornerElement<Tet15> {
  using type = Tet4;
};
template <>
struct CornerElement<Prism18> {
  using type = Prism6;
};
template <>
struct CornerElement<Prism21> {
  using type = Prism6;
};
template <>
struct CornerElement<Pyr14> {
  using type = Pyr5;
};
template <>
struct CornerElement<Pyr19> {
  using type = Pyr5;
};

/// Whether an element is linear, and so may have coarse cells (see Refinement).
template <class Element>
constexpr bool is_linear_element = Element::nodes == std::size_t{1} << Element::dimension;

/// Whether coarser elements may stand for an element: the coarse cells for a linear one, or those of CornerElement.
template <class Element>
constexpr bool has_coarser_element =
    is_linear_element<Element> || !std::is_void_v<typename CornerElement<Element>::type>;

/// Whether the element tells the place() of its nodes.
template <class Element, class = void>
struct HasPlace : std::false_type {};
template <class Element>
struct HasPlace<Element, std::void_t<decltype(Element::place(0))>> : std::true_type {};

/// Returns the linear element's shape functions at the nodes of the quadratic one, by node and corner: 1 for a corner
/// itself; 1/2, 1/4 or 1/8 for the corners of the edge, face or cell in whose middle a node is; else 0, but for the
/// nodes that an enriched side adds. The linear function c is the sum of the quadratic ones times their entries of
/// column c.
template <class Element>
std::array<std::array<double, CornerElement<Element>::type::nodes>, Element::nodes> corner_shares() {
  using Corners = typename CornerElement<Element>::type;
  constexpr std::size_t D = Element::dimension;
  std::array<std::array<double, Corners::nodes>, Element::nodes> shares;
  std::array<std::array<double, D>, Corners::nodes> gradient;
  for (std::size_t a = 0; a < shares.size(); ++a) {
    std::array<double, D> xi;
    if constexpr (HasPlace<Element>::value)
      xi = Element::place(a);
    else if constexpr (D == 1)
      xi[0] = Element::node(a);
    else
      for (std::size_t d = 0; d < D; ++d) xi[d] = Element::Edge::node(Element::factors(a)[d]);
    Corners::evaluate(xi, shares[a], gradient);
  }
  return shares;
}

/// Returns, by node of a quadratic element, the corners of the edge, face or cell in whose middle it is, in ascending
/// order; a corner has itself.
template <class Element>
std::vector<std::vector<int>> corners_of_nodes() {
  std::vector<std::vector<int>> result;
  for (const auto& shares : corner_shares<Element>()) {
    result.emplace_back();
    for (std::size_t c = 0; c < shares.size(); ++c)
      if (shares[c] != 0) result.back().push_back(static_cast<int>(c));
  }
  return result;
}
/// Returns those of Quad9 or of Hex27, whichever has that dimension.
inline const std::vector<std::vector<int>>& corners_of_nodes(int dimension) {
  static const auto quad = corners_of_nodes<Quad9>(), hex = corners_of_nodes<Hex27>();
  return dimension == 2 ? quad : hex;
}

}  // namespace ixos
