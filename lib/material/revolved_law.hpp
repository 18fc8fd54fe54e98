/// Elastic laws in bodies of revolution.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/small_matrix.hpp"
#include "material/log_series.hpp"
#include "material/meridian_moduli.hpp"
#include "material/neo_hooke.hpp"
#include "material/strain.hpp"

namespace ixos {

/// A law in three dimensions whose moduli are also available between the meridian components alone. Displacement
/// gradients are 3 x 3, with H_33 = u_r/R and without shear out of the meridian plane.
template <class Law>
struct RevolvedLaw : Law {
  static constexpr bool has_spatial_tangent = false;
  static constexpr bool keeps_state = false;
  explicit RevolvedLaw(const Law& own) : Law(own) {}
  using Law::stress_and_moduli;

  /// See NeoHooke::stress_and_moduli().
  template <class T>
  T stress_and_moduli(const Small<T, 3>& h, Small<T, 3>& p, Small<T, meridian_size>& moduli) const {
    Small<T, 9> all;
    const T jacobian = Law::stress_and_moduli(h, p, all);
    copy_meridian(all, moduli);
    return jacobian;
  }

  /// See NeoHooke::discrete_gradient_moduli().
  template <class T>
  void discrete_gradient_moduli(const Small<T, 3>& h0, const Small<T, 3>& h1, Small<T, meridian_size>& moduli) const {
    Small<T, 9> all;
    Law::discrete_gradient_moduli(h0, h1, all);
    copy_meridian(all, moduli);
  }
};

/// The neo-Hookean law without the operations on components that are zero: F consists of a block in the meridian plane
/// and of the hoop stretch, and so do A = F^T F - I, F^-1 and P.
template <>
struct RevolvedLaw<NeoHooke> : NeoHooke {
  static constexpr bool has_spatial_tangent = false;
  static constexpr bool keeps_state = true;
  explicit RevolvedLaw(const NeoHooke& law) : NeoHooke(law) {}
  using NeoHooke::add_moduli;
  using NeoHooke::discrete_gradient_moduli;
  using NeoHooke::stress_and_moduli;

  template <class T>
  T energy(const Small<T, 3>& h) const {
    const Split<T> s(h);
    using std::abs;
    const T stretch = select(abs(s.change) < 0.02, T(minus_log1p_series(s.change) * (s.change * s.change) - s.higher),
                             T(s.first - s.l));
    return lame.mu / 2 * stretch + lame.lambda / 8 * (s.l * s.l);
  }

  template <class T>
  T stress(const Small<T, 3>& h, Small<T, 3>& p) const {
    const Split<T> s(h);
    stress_from(s, p);
    return s.jacobian;
  }
  template <class T>
  T stress(const Small<T, 3>& h, Small<T, 3>& p, Kept<3, T>& kept) const {
    const Split<T> s(h);
    stress_from(s, p);
    kept = s.kept();
    return s.jacobian;
  }

  template <class T>
  T stress_and_moduli(const Small<T, 3>& h, Small<T, 3>& p, Small<T, meridian_size>& moduli) const {
    const Split<T> s(h);
    stress_from(s, p);
    moduli = {};
    add_moduli(s.kept(), T(1.0), moduli);
    return s.jacobian;
  }

  /// See NeoHooke::add_moduli(), between the meridian components.
  template <class T>
  void add_moduli(const Kept<3, T>& s, const T& factor, Small<T, meridian_size>& moduli) const {
    const T mu = factor * lame.mu, c = factor * (lame.mu - lame.lambda / 2 * s.l), lambda = factor * lame.lambda;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        for (std::size_t k = 0; k < 2; ++k)
          for (std::size_t m = 0; m < 2; ++m)
            moduli[2 * i + j][2 * k + m] += c * (s.g[m][i] * s.g[j][k]) + lambda * (s.g[j][i] * s.g[m][k]);
        moduli[2 * i + j][2 * i + j] += mu;
        const T both = lambda * (s.g[j][i] * s.g[2][2]);
        moduli[2 * i + j][4] += both;
        moduli[4][2 * i + j] += both;
      }
    moduli[4][4] += mu + (c + lambda) * (s.g[2][2] * s.g[2][2]);
  }

  template <class T>
  void discrete_gradient_moduli(const Small<T, 3>& h0, const Small<T, 3>& h1, Small<T, meridian_size>& moduli) const {
    Small<T, 9> all;
    NeoHooke::discrete_gradient_moduli(h0, h1, all);
    copy_meridian(all, moduli);
  }

 private:
  /// The quantities that energy, stress and moduli share; see NeoHooke.
  template <class T>
  struct Split {
    explicit Split(const Small<T, 3>& h) {
      const Small<T, 2> plane{{{h[0][0], h[0][1]}, {h[1][0], h[1][1]}}};
      a = green_strain_doubled(plane);
      hoop = h[2][2] * (2.0 + h[2][2]);
      const Small<T, 2> f = deformation_gradient(plane);
      const T det = determinant(f), stretch = 1.0 + h[2][2];
      jacobian = det * stretch;
      inverse_plane = inverse(f, det);
      inverse_hoop = 1.0 / stretch;
      const T in_plane = trace(a), determinant_in_plane = higher_invariants(a);
      first = in_plane + hoop;
      higher = determinant_in_plane + (in_plane + determinant_in_plane) * hoop;
      change = first + higher;
      l = log_determinant(first, change, jacobian);
    }
    Kept<3, T> kept() const {
      Kept<3, T> result{};
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) result.g[i][j] = inverse_plane[i][j];
      result.g[2][2] = inverse_hoop;
      result.l = l;
      return result;
    }
    Small<T, 2> a, inverse_plane;
    T hoop, inverse_hoop;  ///< A_33 and 1/F_33
    T jacobian;
    T first, higher;  ///< tr A and the sum of A's other invariants
    T change;         ///< det C - 1
    T l;              ///< ln det C
  };

  template <class T>
  void stress_from(const Split<T>& s, Small<T, 3>& p) const {
    const T pressure = (lame.lambda / 2) * s.l;
    p = {};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        p[i][j] = pressure * s.inverse_plane[j][i] +
                  lame.mu * (s.inverse_plane[0][i] * s.a[0][j] + s.inverse_plane[1][i] * s.a[1][j]);
    p[2][2] = s.inverse_hoop * (pressure + lame.mu * s.hoop);
  }
};

/// The law in rings of any law.
template <class Law>
struct RingLaw {
  using type = RevolvedLaw<Law>;
};
template <class Law>
struct RingLaw<RevolvedLaw<Law>> {
  using type = RevolvedLaw<Law>;
};

}  // namespace ixos
