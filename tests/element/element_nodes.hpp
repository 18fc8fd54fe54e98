/// Nodal values of one element for tests of its kernels.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "base/small_matrix.hpp"
#include "fem/cells/hexahedra.hpp"
#include "fem/cells/prisms.hpp"
#include "fem/cells/pyramids.hpp"
#include "fem/cells/quadrilaterals.hpp"
#include "fem/cells/tetrahedra.hpp"
#include "fem/cells/triangles.hpp"
#include "fem/contact_elements.hpp"
#include "fem/contact_hexahedra.hpp"
#include "fem/quadratic_contact_elements.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos::test {

/// Over any scalar type: Nodal<T> is [node][component].
template <class Element>
struct ElementNodes {
  static constexpr std::size_t N = Element::nodes;
  static constexpr std::size_t D = Element::dimension;
  static constexpr int dofs = static_cast<int>(N * D);
  /// A triangle, tetrahedron, prism or pyramid.
  static constexpr bool simplex = HasRule<Element>::value;
  static constexpr bool quadratic = is_quadratic_element<Element> || (simplex && N > 2 * D);
  /// Quadratic, and enriched.
  static constexpr bool enriched = std::is_same_v<Element, Quad9C4> || std::is_same_v<Element, Hex27C4>;
  using Variable = Dual<dofs>;
  template <class T>
  using Nodal = Small<T, N, D>;

  /// A block with these edges about the origin; derivative nodes of a Hermite side hold dX/dxi, of a Hermite face, seen
  /// from outside, those of y and x and the mixed one.
  static Nodal<double> block(const std::array<double, D>& edges) {
    Nodal<double> x{};
    if constexpr (simplex) {  // the reference element, its nodes between their corners
      const auto all = Element::node_corners();
      for (std::size_t a = 0; a < N; ++a)
        for (const int c : all[a])
          for (std::size_t d = 0; d < D; ++d)
            x[a][d] += edges[d] * Element::corners[static_cast<std::size_t>(c)][d] / static_cast<double>(all[a].size());
      return x;
    } else {
      return cube(edges);
    }
  }
  static Nodal<double> cube(const std::array<double, D>& edges) {
    const auto corner = corners<static_cast<int>(D)>();
    Nodal<double> x{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) {
        if (a < corner.size())
          x[a][d] = 0.5 * corner[a][d] * edges[d];
        else if constexpr (enriched)
          x[a][d] = 0.5 * Element::place(a)[d] * edges[d];
        else if constexpr (quadratic)
          x[a][d] = 0.5 * LagrangeEdge<2>::node(Element::factors(a)[d]) * edges[d];
        else if (std::is_same_v<Element, Quad4CH>)
          x[a][d] = d == 0 ? 0.5 * edges[0] : 0.0;
        else if (std::is_same_v<Element, Hex8CH>)
          x[a][d] = (a - 8) % 3 + d == 1 ? 0.5 * edges[d] : 0.0;
        else if (D == 3)  // the face of Hex8C2, seen from outside: y first
          x[a][d] = edges[d] * (d == 2 ? -0.5 : 0.5 * LagrangeEdge<2>::node(LagrangeFace<2>::factors(a - 4)[1 - d]));
        else
          x[a][d] = edges[d] * (d == 0 ? -0.5 + static_cast<double>(a - 3) / static_cast<double>(N - 3) : -0.5);
      }
    return x;
  }

  /// Numbers without order; smaller ones in quadratic elements, whose gradients they make steeper.
  static Nodal<double> wave(double amplitude, double phase) {
    Nodal<double> values{};
    if (quadratic) amplitude *= enriched ? 0.1 : 0.25;
    for (auto& node : values)
      for (double& value : node) value = amplitude * std::sin(phase += 1.7);
    return values;
  }

  /// A unit square or cube; the phase varies its shape.
  static Nodal<double> distorted(double phase) {
    std::array<double, D> edges;
    edges.fill(1.0);
    Nodal<double> x = block(edges);
    const Nodal<double> change = wave(0.1, phase);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) x[a][d] += change[a][d];
    return x;
  }

  /// H x: the displacement with a constant gradient.
  static Nodal<double> affine(const Small<double, D>& h, const Nodal<double>& x) {
    Nodal<double> u{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) u[a][i] += h[i][j] * x[a][j];
    return u;
  }

  template <class T>
  static Nodal<T> constant(const Nodal<double>& values) {
    Nodal<T> result{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = T(values[a][d]);
    return result;
  }

  /// The values as independent variables.
  static Nodal<Variable> seeded(const Nodal<double>& values) {
    Nodal<Variable> result{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = variable<dofs>(static_cast<int>(a * D + d), values[a][d]);
    return result;
  }
};

}  // namespace ixos::test
