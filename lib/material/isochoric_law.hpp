/// Elastic laws whose energy is a function of the isochoric invariants plus one of the volume.
#pragma once
#include <cstddef>

#include "material/exp_series.hpp"
#include "material/lame.hpp"
#include "material/strain_state.hpp"
#include "material/symmetric_moduli.hpp"
#include "material/volumetric_energy.hpp"

namespace ixos {

/// The first and second derivatives of an energy W(x, y) [E0].
template <class T>
struct Slopes {
  T x, y;
};
template <class T>
struct Curvatures {
  T xx, xy, yy;
};

/// W(x, y) + U(J) with x = I1(Cb) - 3, y = I2(Cb) - 3, Cb = J^(-2/3) C (Holzapfel 2000, section 6.4). With A = C - I,
/// its invariants, L = ln det C, z = L/3, m(z) = exp(z) - 1 - z and q = I1(A) - L,
///
///   x = exp(-z) (q - 3 m(z)),   y = exp(-2 z) (2 q + I2(A) - 3 m(2 z)),
///   C S = 2 W_x exp(-z) dev A + 2 W_y exp(-2 z) dev(A - cof A) + p I,   p = dU/d ln J,
///
/// in which small strains keep their digits. At a uniform stretch s, x and y lose digits by a factor s^-4. `Energy` has
/// energy(x, y), slopes(x, y), curvatures(x, y) and has_limit. If the latter is true, the energy has a limit, and a
/// fourth function room(x, y) is greater than 0 within it. StrainLaw makes an elastic law of it.
template <class Energy>
struct IsochoricLaw {
  static constexpr bool has_limit = Energy::has_limit;
  Energy isochoric;
  VolumetricEnergy volumetric;
  Lame lame;  ///< at small strains

  template <std::size_t D, class T>
  T energy(const StrainState<D, T>& s) const {
    const Invariants<T> at(s);
    return isochoric.energy(at.x, at.y) + volumetric.energy(s.change, s.l);
  }

  /// Returns a number that is greater than 0 where the energy is defined. Only if has_limit.
  template <std::size_t D, class T>
  T room(const StrainState<D, T>& s) const {
    const Invariants<T> at(s);
    return isochoric.room(at.x, at.y);
  }

  /// Returns C S.
  template <std::size_t D, class T>
  Small<T, D> mixed_stress(const StrainState<D, T>& s) const {
    return mixed_stress(s, Point<D, T>(*this, s));
  }

  /// Returns dS/dC, given C^-1 = g. With G1 = dx/dC, G2 = dy/dC and (g o g)_IJKL = (g_IK g_JL + g_IL g_JK)/2,
  ///   dS/dC = 2 W_xx G1 (x) G1 + 2 W_xy (G1 (x) G2 + G2 (x) G1) + 2 W_yy G2 (x) G2 + 2 W_x dG1/dC + 2 W_y dG2/dC
  ///           + dp/d(ln J)/2 g (x) g - p g o g,
  ///   dG1/dC = -(G1 (x) g + g (x) G1)/3 + (x + 3) (g o g/3 - g (x) g/9),
  ///   dG2/dC = -2 (G2 (x) g + g (x) G2)/3 + (y + 3) (2 g o g/3 - 4 g (x) g/9) + exp(-2 z) (I (x) I - I o I).
  template <std::size_t D, class T>
  SymmetricModuli<D, T> moduli(const StrainState<D, T>& s, const Small<T, D>& g) const {
    return moduli(s, g, Point<D, T>(*this, s));
  }

  /// Returns the moduli and sets `mixed` to mixed_stress(s).
  template <std::size_t D, class T>
  SymmetricModuli<D, T> mixed_stress_and_moduli(const StrainState<D, T>& s, const Small<T, D>& g,
                                                Small<T, D>& mixed) const {
    const Point<D, T> at(*this, s);
    mixed = mixed_stress(s, at);
    return moduli(s, g, at);
  }

 private:
  template <class T>
  struct Invariants {
    template <std::size_t D>
    explicit Invariants(const StrainState<D, T>& s) {
      const T z = s.l * (1.0 / 3), m = exp_remainder(z), growth = 1.0 + z + m, q = s.stretch();
      shrink = 1.0 / growth;
      // m(2 z) = (1 + z + m)^2 - 1 - 2 z
      const T twice = z * z + m * (2.0 + 2.0 * z + m);
      x = shrink * (q - 3.0 * m);
      y = (shrink * shrink) * (2.0 * q + s.second - 3.0 * twice);
    }
    T shrink;  ///< exp(-z) = J^(-2/3)
    T x, y;
  };

  /// The quantities that stress and moduli have in common.
  template <std::size_t D, class T>
  struct Point : Invariants<T> {
    Point(const IsochoricLaw& law, const StrainState<D, T>& s)
        : Invariants<T>(s), w(law.isochoric.slopes(this->x, this->y)) {
      set_directions(s, one, two);
    }
    Slopes<T> w;
    Small<T, D> one, two;  ///< see set_directions()
  };

  template <std::size_t D, class T>
  Small<T, D> mixed_stress(const StrainState<D, T>& s, const Point<D, T>& at) const {
    const T first = 2.0 * (at.w.x * at.shrink), second = 2.0 * (at.w.y * (at.shrink * at.shrink));
    const T pressure = volumetric.pressure(s.change, s.l);
    Small<T, D> result;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        result[i][j] = first * at.one[i][j] + second * at.two[i][j];
        if (i == j) result[i][j] += pressure;
      }
    return result;
  }

  template <std::size_t D, class T>
  SymmetricModuli<D, T> moduli(const StrainState<D, T>& s, const Small<T, D>& g, const Point<D, T>& at) const {
    using Pairs = SymmetricPairs<D>;
    const T shrink2 = at.shrink * at.shrink;
    const Slopes<T>& w = at.w;
    const Curvatures<T> c = isochoric.curvatures(at.x, at.y);
    const Small<T, D> one = product(g, at.one), two = product(g, at.two);
    const T third = (2.0 / 3) * w.x, thirds = (4.0 / 3) * w.y, plain = 2.0 * (w.y * shrink2);
    const T crossed = third * (at.x + 3.0) + thirds * (at.y + 3.0) - volumetric.pressure(s.change, s.l);
    const T parallel = 0.5 * volumetric.stiffness(s.change, s.l) - (1.0 / 3) * (third * (at.x + 3.0)) -
                       (2.0 / 3) * (thirds * (at.y + 3.0));
    std::array<T, Pairs::size> v, g1, g2, b1, b2, bg;
    for (std::size_t p = 0; p < Pairs::size; ++p) {
      const auto [i, j] = Pairs::list[p];
      v[p] = g[i][j];
      g1[p] = at.shrink * one[i][j];
      g2[p] = shrink2 * two[i][j];
      b1[p] = 2.0 * (c.xx * g1[p] + c.xy * g2[p]) - third * v[p];
      b2[p] = 2.0 * (c.xy * g1[p] + c.yy * g2[p]) - thirds * v[p];
      bg[p] = parallel * v[p] - third * g1[p] - thirds * g2[p];
    }
    SymmetricModuli<D, T> m;
    for (std::size_t p = 0; p < Pairs::size; ++p)
      for (std::size_t q = p; q < Pairs::size; ++q) {
        const auto [i, j] = Pairs::list[p];
        const auto [k, l] = Pairs::list[q];
        m[p][q] =
            b1[p] * g1[q] + b2[p] * g2[q] + bg[p] * v[q] + 0.5 * (crossed * (g[i][k] * g[j][l] + g[i][l] * g[j][k]));
        if (p < D && q < D && p != q) m[p][q] += plain;
        if (p >= D && p == q) m[p][q] -= 0.5 * plain;
        m[q][p] = m[p][q];
      }
    return m;
  }

  /// Sets dev A and dev(A - cof A), the directions of C dx/dC and C dy/dC.
  template <std::size_t D, class T>
  static void set_directions(const StrainState<D, T>& s, Small<T, D>& one, Small<T, D>& two) {
    one = s.a;
    two = s.a;
    if constexpr (D == 3) {  // cof A = A^2 - I1 A + I2 I, which is 0 in the plane of plane strain
      const Small<T, D> square = product(s.a, s.a);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) two[i][j] += s.first * s.a[i][j] - square[i][j];
    }
    const T mean = s.first * (1.0 / 3), mean_cofactor = s.second * (1.0 / 3);
    for (std::size_t i = 0; i < D; ++i) {
      one[i][i] -= mean;
      two[i][i] -= mean - mean_cofactor;
      if constexpr (D == 3) two[i][i] -= s.second;
    }
  }
};

}  // namespace ixos
