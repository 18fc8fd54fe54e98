/// Shape functions at quadrature points.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "fem/quadrature.hpp"
#include "fem/ties.hpp"

namespace ixos {

/// Whether an element type lists its quadrature: it is then no product of lines.
template <class Element, class = void>
struct HasRule : std::false_type {};
template <class Element>
struct HasRule<Element, std::void_t<decltype(Element::rule(1))>> : std::true_type {};

/// Returns the rule of an element type: `along` points along each direction of a product of lines, the rule of as high
/// a degree on other shapes, which list theirs in Element::rule().
template <class Element>
auto element_rule(int along) {
  if constexpr (HasRule<Element>::value) {
    return Element::rule(along);
  } else {
    std::array<int, Element::dimension> counts;
    counts.fill(along);
    return product_rule(counts);
  }
}
/// Returns the element's own rule. `high`: that of simplices which are curved, or the sections of rings.
template <class Element>
auto own_rule(bool high = true) {
  if constexpr (HasRule<Element>::value)
    return Element::own_rule(high);
  else
    return product_rule(Element::default_points);
}

/// Returns the rule for products of two shape functions: the element's own, if that is a product of lines.
template <class Element>
auto mass_rule() {
  if constexpr (HasRule<Element>::value)
    return Element::mass_rule();
  else
    return own_rule<Element>();
}

/// Values of an element's shape functions at the points of a rule.
template <class Element>
struct ShapeTable {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;

  /// `tied`: edges kept straight, see evaluate_tied().
  explicit ShapeTable(const QuadratureRule<D>& rule = own_rule<Element>(), unsigned tied = 0)
      : two_points(std::all_of(rule.along.begin(), rule.along.end(), [](int count) { return count == 2; })),
        weight(rule.weights),
        point(rule.points),
        value(rule.size()),
        gradient(rule.size()) {
    for (std::size_t q = 0; q < size(); ++q) evaluate_tied<Element>(tied, point[q], value[q], gradient[q]);
  }

  /// Makes the table at the points of another element's.
  template <class Other>
  explicit ShapeTable(const ShapeTable<Other>& other)
      : two_points(other.two_points),
        weight(other.weight),
        point(other.point),
        value(other.size()),
        gradient(other.size()) {
    for (std::size_t q = 0; q < size(); ++q) Element::evaluate(point[q], value[q], gradient[q]);
  }

  std::size_t size() const { return weight.size(); }

  bool two_points;                                             ///< whether the rule is a product of two along each line
  std::vector<double> weight;                                  ///< quadrature weights
  std::vector<std::array<double, D>> point;                    ///< xi_q
  std::vector<std::array<double, N>> value;                    ///< N_a(xi_q)
  std::vector<std::array<std::array<double, D>, N>> gradient;  ///< dN_a/dxi_d (xi_q)
};

}  // namespace ixos
