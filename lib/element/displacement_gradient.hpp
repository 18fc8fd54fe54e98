/// From nodal displacements to displacement gradients, and back from stresses to nodal forces.
///
/// Kernels use these functions alone, so that plane and solid bodies and bodies of revolution differ here only:
///   Kernel::gradient(u, dn)        H, G x G
///   add_nodal_forces(p, dn, f)     f += the transpose of it applied to P
///   add_contraction(...)           see node_pairs.hpp
/// `dn` is what the shape functions contribute at a point: dN_a/dX_J, [node][J], or RevolvedGradients.
#pragma once
#include <array>
#include <cstddef>

#include "base/small_matrix.hpp"
#include "fem/revolved.hpp"

namespace ixos {

/// Shape gradients at a point of a meridian plane: H_iJ = sum_a u_ai dN_a/dX_J in the plane, H_33 = u_r/R = sum_a u_ar
/// N_a/R. (Zienkiewicz and Taylor 2005, section 2.4)
template <class T, std::size_t N>
struct RevolvedGradients {
  Small<T, N, 2> plane;
  std::array<T, N> hoop;  ///< N_a/R [1/L0]
};

/// Data at one quadrature point: dxi_d/dX_J, and quadrature weight times reference volume [L0^D].
template <class T, std::size_t D>
struct SpacePoint {
  Small<T, D> inverse_jacobian;
  T weight;
};

/// The volume is that of the ring [L0^3].
template <class T>
struct RingPoint : SpacePoint<T, 2> {
  T inverse_radius;  ///< 1/R [1/L0]
};

/// Sizes and types of an element's displacement gradients.
template <class Element, bool revolved = IsRevolved<Element>::value>
struct GradientTraits {
  /// Displacement gradients are G x G.
  static constexpr std::size_t G = Element::dimension;
  template <class T, std::size_t N>
  using Gradients = Small<T, N, G>;
  template <class T>
  using Point = SpacePoint<T, G>;
};
template <class Element>
struct GradientTraits<Element, true> {
  static constexpr std::size_t G = 3;
  template <class T, std::size_t N>
  using Gradients = RevolvedGradients<T, N>;
  template <class T>
  using Point = RingPoint<T>;
};

/// Returns the displacement gradient in a body of revolution, 3 x 3.
template <class T, std::size_t N>
Small<T, 3> displacement_gradient(const Small<T, N, 2>& u, const RevolvedGradients<T, N>& dn) {
  Small<T, 3> h{};
  for (std::size_t a = 0; a < N; ++a) {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) h[i][j] += u[a][i] * dn.plane[a][j];
    h[2][2] += u[a][0] * dn.hoop[a];
  }
  return h;
}

/// Adds P_iJ dN_a/dX_J, and in a body of revolution P_33 N_a/R to the radial force.
template <class T, std::size_t N, std::size_t D>
[[gnu::always_inline]] inline void add_nodal_forces(const Small<T, D>& p, const Small<T, N, D>& dn, Small<T, N, D>& f) {
  for (std::size_t a = 0; a < N; ++a)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) f[a][i] += p[i][j] * dn[a][j];
}
template <class T, std::size_t N>
[[gnu::always_inline]] inline void add_nodal_forces(const Small<T, 3>& p, const RevolvedGradients<T, N>& dn,
                                                    Small<T, N, 2>& f) {
  for (std::size_t a = 0; a < N; ++a) {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) f[a][i] += p[i][j] * dn.plane[a][j];
    f[a][0] += p[2][2] * dn.hoop[a];
  }
}

}  // namespace ixos
