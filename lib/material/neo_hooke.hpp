/// Compressible neo-Hookean law.
#pragma once
#include <cmath>

#include "material/discrete_neo_hooke.hpp"
#include "material/lame.hpp"
#include "material/log_series.hpp"
#include "material/neo_hooke_path.hpp"
#include "material/spatial_tangent.hpp"
#include "material/strain.hpp"

namespace ixos {

/// W = mu/2 (tr B - 3) - mu ln J + lambda/2 (ln J)^2 (Zienkiewicz and Taylor 2005; Gautam and Sauer 2014, eq. 36), in
/// plane strain (D = 2, B_33 = 1) and in three dimensions. It is written in A = F^T F - I with j = det C - 1 and L = ln
/// det C: W = mu/2 (j - L - I2 - I3) + lambda/8 L^2, or mu/2 (tr A - L) + lambda/8 L^2 if j is not small, and P = F^-T
/// (mu A + lambda/2 L I). These forms keep their digits at strains down to roundoff, and up to a J of roundoff. Moduli
/// are stored A[iJ][kL], row iJ = i D + J.
struct NeoHooke {
  /// J <= 0 is inadmissible.
  static constexpr bool can_invert = true;
  /// All states with J > 0 are admissible; a law with a further limit has admissibility(h), see StrainLaw.
  static constexpr bool has_limit = false;
  static constexpr bool has_discrete_gradient = true;
  static constexpr bool has_spatial_tangent = true;
  static constexpr bool keeps_state = true;
  /// Sums stresses and moduli over points of a straight path.
  template <std::size_t D, class T>
  using Path = NeoHookePath<D, T>;
  Lame lame;

  /// The part of a state that moduli need, F^-1 and L. With it, stress and tangent at one place compute it once.
  template <std::size_t D, class T>
  struct Kept {
    Small<T, D> g;
    T l;
  };

  /// Returns the energy per reference volume [E0] for the displacement gradient H [-]; defined for J > 0.
  template <std::size_t D, class T>
  T energy(const Small<T, D>& h) const {
    const Small<T, D> a = green_strain_doubled(h);
    const T first = trace(a), higher = higher_invariants(a);
    const T j = first + higher;
    const T l = log_determinant(first, j, determinant(deformation_gradient(h)));
    using std::abs;
    const T stretch = select(abs(j) < 0.02, T(minus_log1p_series(j) * (j * j) - higher), T(first - l));
    return lame.mu / 2 * stretch + lame.lambda / 8 * (l * l);
  }

  /// Computes the first Piola-Kirchhoff stress P_iJ [E0]. Returns J = det F.
  template <std::size_t D, class T>
  T stress(const Small<T, D>& h, Small<T, D>& p) const {
    State<D, T> s(h);
    stress_from(s, p);
    return s.jacobian;
  }

  /// Does the same, and keeps what moduli() needs.
  template <std::size_t D, class T>
  T stress(const Small<T, D>& h, Small<T, D>& p, Kept<D, T>& kept) const {
    State<D, T> s(h);
    stress_from(s, p);
    kept = {s.g, s.l};
    return s.jacobian;
  }

  /// Computes the stress whose work from H0 to H1 is the change of the energy, P:(H1 - H0) = W1 - W0, and its
  /// derivative in H1 (unsymmetric). J > 0 at both ends.
  template <std::size_t D, class T>
  void discrete_gradient(const Small<T, D>& h0, const Small<T, D>& h1, Small<T, D>& p) const {
    p = DiscreteNeoHooke<D, T>(lame, h0, h1).stress();
  }
  template <std::size_t D, class T>
  void discrete_gradient_moduli(const Small<T, D>& h0, const Small<T, D>& h1, Small<T, D * D>& moduli) const {
    DiscreteNeoHooke<D, T>(lame, h0, h1).moduli(moduli);
  }

  /// Returns the stress out of the plane in plane strain, sigma_33 = lambda ln J/J [E0].
  template <class T>
  T out_of_plane_stress(const Small<T, 2>& h) const {
    const State<2, T> s(h);
    return lame.lambda / 2 * s.l / s.jacobian;
  }

  /// Computes the stress and its derivative A[iJ][kL] = dP_iJ/dF_kL [E0]; the derivative is symmetric. Returns J.
  template <std::size_t D, class T>
  T stress_and_moduli(const Small<T, D>& h, Small<T, D>& p, Small<T, D * D>& moduli) const {
    State<D, T> s(h);
    stress_from(s, p);
    moduli = {};
    add_moduli(Kept<D, T>{s.g, s.l}, T(1.0), moduli);
    return s.jacobian;
  }

  /// Adds factor times the derivative of the stress at a kept state.
  template <std::size_t D, class T>
  void add_moduli(const Kept<D, T>& s, const T& factor, Small<T, D * D>& moduli) const {
    const T mu = factor * lame.mu, c = factor * (lame.mu - lame.lambda / 2 * s.l), lambda = factor * lame.lambda;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t jj = 0; jj < D; ++jj) {
        for (std::size_t k = 0; k < D; ++k)
          for (std::size_t m = 0; m < D; ++m)
            moduli[i * D + jj][k * D + m] += c * (s.g[m][i] * s.g[jj][k]) + lambda * (s.g[jj][i] * s.g[m][k]);
        moduli[i * D + jj][i * D + jj] += mu;
      }
  }

  /// Computes the moduli in the deformed body, and F^-1.
  template <std::size_t D, class T>
  SpatialTangent<T> spatial_tangent(const Small<T, D>& h, Small<T, D>& inverse_deformation) const {
    const State<D, T> s(h);
    inverse_deformation = s.g;
    return spatial_tangent(Kept<D, T>{s.g, s.l});
  }
  template <std::size_t D, class T>
  SpatialTangent<T> spatial_tangent(const Kept<D, T>& s) const {
    return {T(lame.mu), lame.mu - lame.lambda / 2 * s.l, T(lame.lambda)};
  }

 private:
  /// The quantities that stress and moduli share: A, g = F^-1, J and L = ln det C.
  template <std::size_t D, class T>
  struct State {
    explicit State(const Small<T, D>& h) : a(green_strain_doubled(h)) {
      const Small<T, D> f = deformation_gradient(h);
      jacobian = determinant(f);
      g = inverse(f, jacobian);
      const T first = trace(a);
      l = log_determinant(first, T(first + higher_invariants(a)), jacobian);
    }
    Small<T, D> a;
    Small<T, D> g;
    T jacobian;
    T l;
  };

  template <std::size_t D, class T>
  void stress_from(const State<D, T>& s, Small<T, D>& p) const {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t jj = 0; jj < D; ++jj) {
        T sum = (lame.lambda / 2) * (s.l * s.g[jj][i]);
        for (std::size_t k = 0; k < D; ++k) sum += lame.mu * (s.g[k][i] * s.a[k][jj]);
        p[i][jj] = sum;
      }
  }
};

}  // namespace ixos
