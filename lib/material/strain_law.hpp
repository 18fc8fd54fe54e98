/// Laws of Green's strain as elastic laws.
#pragma once
#include <cstddef>
#include <utility>

#include "material/gonzalez_gradient.hpp"
#include "material/lame.hpp"
#include "material/strain_state.hpp"
#include "material/symmetric_moduli.hpp"

namespace ixos {

/// An isotropic law written in StrainState, with the functions of an elastic law (see NeoHooke) over any scalar type.
/// Law has energy(s), mixed_stress(s) = C S, moduli(s, C^-1) = dS/dC, both of them at once, and has_limit, with which
/// it has room(s), too; see IsochoricLaw. Its discrete gradient is GonzalezGradient.
template <class Law>
struct StrainLaw {
  static constexpr bool has_discrete_gradient = true;
  static constexpr bool has_limit = Law::has_limit;
  Law law;
  Lame lame;

  explicit StrainLaw(Law own) : law(std::move(own)), lame(law.lame) {}

  /// Returns the energy per reference volume [E0]; NaN where the law does not define it.
  template <std::size_t D, class T>
  T energy(const Small<T, D>& h) const {
    return law.energy(state(h));
  }

  /// Returns J, or -1 where the law does not define an energy.
  template <std::size_t D, class T>
  T admissibility(const Small<T, D>& h) const {
    return admissible(state(h), determinant(deformation_gradient(h)));
  }

  /// Computes the first Piola-Kirchhoff stress P = F^-T (C S) [E0]. Returns J, or -1 as above.
  template <std::size_t D, class T>
  T stress(const Small<T, D>& h, Small<T, D>& p) const {
    const Small<T, D> f = deformation_gradient(h);
    const T jacobian = determinant(f);
    const StrainState<D, T> s(green_strain_doubled(h), jacobian);
    stress_from(law.mixed_stress(s), inverse(f, jacobian), p);
    return admissible(s, jacobian);
  }

  /// Does the same, and computes the moduli A_iJkL = dP_iJ/dF_kL, row i D + J, column k D + L.
  template <std::size_t D, class T>
  T stress_and_moduli(const Small<T, D>& h, Small<T, D>& p, Small<T, D * D>& moduli) const {
    const Small<T, D> f = deformation_gradient(h);
    const T jacobian = determinant(f);
    const StrainState<D, T> s(green_strain_doubled(h), jacobian);
    const Small<T, D> g = inverse(f, jacobian);
    Small<T, D> mixed, right;  // C S and C^-1
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = i; j < D; ++j) {
        T sum = g[i][0] * g[j][0];
        for (std::size_t k = 1; k < D; ++k) sum += g[i][k] * g[j][k];
        right[i][j] = right[j][i] = sum;
      }
    const SymmetricModuli<D, T> own = law.mixed_stress_and_moduli(s, right, mixed);
    stress_from(mixed, g, p);
    push_forward(own, product(right, mixed), f, f, 1.0, moduli);
    return admissible(s, jacobian);
  }

  template <std::size_t D, class T>
  void discrete_gradient(const Small<T, D>& h0, const Small<T, D>& h1, Small<T, D>& p) const {
    p = GonzalezGradient<Law, D, T>(law, h0, h1).stress();
  }
  template <std::size_t D, class T>
  void discrete_gradient_moduli(const Small<T, D>& h0, const Small<T, D>& h1, Small<T, D * D>& moduli) const {
    GonzalezGradient<Law, D, T>(law, h0, h1).moduli(moduli);
  }

  /// Returns sigma_33 in plane strain [E0].
  template <class T>
  T out_of_plane_stress(const Small<T, 2>& h) const {
    Small<T, 3> whole{}, p;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) whole[i][j] = h[i][j];
    stress(whole, p);
    return p[2][2] / determinant(deformation_gradient(h));
  }

 private:
  template <std::size_t D, class T>
  static StrainState<D, T> state(const Small<T, D>& h) {
    return StrainState<D, T>(green_strain_doubled(h), determinant(deformation_gradient(h)));
  }
  template <std::size_t D, class T>
  T admissible([[maybe_unused]] const StrainState<D, T>& s, const T& jacobian) const {
    if constexpr (has_limit)
      return select(law.room(s) > 0.0, jacobian, T(-1.0));
    else
      return jacobian;
  }
  template <std::size_t D, class T>
  static void stress_from(const Small<T, D>& mixed, const Small<T, D>& inverse, Small<T, D>& p) {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        p[i][j] = inverse[0][i] * mixed[0][j];
        for (std::size_t k = 1; k < D; ++k) p[i][j] += inverse[k][i] * mixed[k][j];
      }
  }
};

}  // namespace ixos
