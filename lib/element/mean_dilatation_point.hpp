/// The deformation at one quadrature point under a mean dilatation.
#pragma once
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "element/displacement_gradient.hpp"
#include "material/cube_root.hpp"
#include "material/exp_series.hpp"
#include "material/log_series.hpp"
#include "material/strain.hpp"

namespace ixos {

/// One point's part of the energy W(F~), F~ = (Jm/J)^(1/D) F (see MeanDilatationKernel), and its derivatives by F and
/// by theta = ln Jm. For a linear law it is the limit of small strains.
/// `finite`: false for a law of small strains, which accepts any F; its J is 1.
template <std::size_t D>
struct MeanDilatationPoint {
  template <class T>
  static T trace(const Small<T, D>& m) {
    T sum = m[0][0];
    for (std::size_t i = 1; i < D; ++i) sum += m[i][i];
    return sum;
  }

  /// Returns J - 1; for a linear law its linear part.
  template <class T>
  static T dilatation(bool finite, const Small<T, D>& h) {
    return finite ? determinant_minus_one(h) : trace(h);
  }

  /// Returns ln J, 0 if J <= 0; for a linear law the trace of H.
  template <class T>
  static T log_ratio(bool finite, const Small<T, D>& h) {
    using std::abs;
    using std::log;
    if (!finite) return trace(h);
    const T change = determinant_minus_one(h);
    const auto small = abs(change) < 0.2;
    const T close = log_one_plus(T(select(small, change, T(0.0))));
    if (everywhere(small)) return close;
    // Far from 1, J has more correct digits than J - 1.
    const T ratio = determinant(deformation_gradient(h));
    return select(small, close, T(log(T(select(ratio > 0.0, ratio, T(1.0))))));
  }

  /// H~ at a point and the quantities that its variation needs; for a linear law all except H~ are those at rest.
  template <class T>
  struct State {
    State() {}  // NOLINT(modernize-use-equals-default): leaves arrays of states as they are
    /// The volume ratio of F~ is 1 + mean_dilatation.
    State(bool finite, const Small<T, D>& h, const T& mean_dilatation) : State(finite, h) {
      const T change = mean_dilatation - dilatation(finite, h);
      stretch(finite ? root_minus_one(T(change / jacobian)) : T(change * (1.0 / D)));
    }

    /// Returns the state F~ = exp(exponent) F; for a linear law H~ = H + exponent I.
    static State stretched(bool finite, const Small<T, D>& h, const T& exponent) {
      State s(finite, h);
      s.stretch(finite ? T(exponent * exp_quotient(exponent)) : exponent);
      return s;
    }

    /// Returns m:F~; for a linear law the trace.
    T product(const Small<T, D>& m) const {
      T sum = trace(m);
      if (of_finite)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) sum += m[i][j] * scaled[i][j];
      return sum;
    }

    /// Returns dJ/dF = J F^-T.
    Small<T, D> cofactors() const {
      Small<T, D> result;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) result[i][j] = jacobian * inverse[j][i];
      return result;
    }

    Small<T, D> scaled;   ///< H~ = F~ - I
    T scale;              ///< of F~ = scale F, such as (Jm/J)^(1/D)
    T jacobian;           ///< J
    Small<T, D> inverse;  ///< F^-1
    bool of_finite;       ///< `finite` of its law

   private:
    /// F~ = F.
    [[gnu::always_inline]] State(bool finite, const Small<T, D>& h)
        : scaled(h), scale(1.0), jacobian(1.0), inverse{}, of_finite(finite) {
      if (finite) {
        Small<T, D> f = h;
        for (std::size_t i = 0; i < D; ++i) f[i][i] += 1.0;
        jacobian = determinant(f);
        inverse = ixos::inverse(f, jacobian);
      } else {
        for (std::size_t i = 0; i < D; ++i) inverse[i][i] = T(1.0);
      }
    }

    /// Multiplies F~ by 1 + change; for a linear law adds change I.
    [[gnu::always_inline]] void stretch(const T& change) {
      if (of_finite) {
        scale = 1.0 + change;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) scaled[i][j] *= scale;
      }
      for (std::size_t i = 0; i < D; ++i) scaled[i][i] += change;
    }

    /// Returns (1 + x)^(1/D) - 1 without cancellation.
    static T root_minus_one(const T& x) {
      using std::sqrt;
      if constexpr (D == 2)
        return x / (1.0 + sqrt(T(1.0 + x)));
      else
        return cube_root_minus_one(x);
    }
  };

  /// Second derivatives at a point, with the law's moduli A, P = P~, B = A:F~, t = P:F~, G = F^-T, c = scale:
  ///   phi_FF = c^2 A - (Q (x) G + G (x) Q)/D + z/D G (x) G + t/D G x G,  phi_Ft = (Q - z G)/D,  phi_tt = z/D,
  /// Q = c (P + B), z = (F~:B + t)/D, (G x G)_iJkL = G_iL G_kJ; for a linear law without the terms in P. The second
  /// derivative of theta adds along G (x) G - across G x G to phi_FF. With Jm it is that of Jm: along = across =
  /// J S/(V Jm). With ln J, along is 0.
  template <class T>
  struct Moduli {
    /// `p` and `a`: the law's stress and moduli at s.scaled. It is inlined: a call for each point, through memory,
    /// would cost a tenth of a tangent's speed.
    [[gnu::always_inline]] Moduli(const State<T>& s, const Small<T, D>& p, const Small<T, D * D>& a, const T& along,
                                  const T& across) {
      Small<T, D> q;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) {
          const auto& row = a[i * D + j];
          T sum = row[0];
          for (std::size_t m = 1; m < D; ++m) sum += row[m * D + m];
          if (s.of_finite)
            for (std::size_t m = 0; m < D * D; ++m) sum += row[m] * s.scaled[m / D][m % D];
          q[i][j] = sum;
        }
      T t(0.0);
      T z = s.product(q) * (1.0 / D);
      if (s.of_finite) {
        t = s.product(p) * (1.0 / D);
        z += t;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) q[i][j] = s.scale * (p[i][j] + q[i][j]);
      }
      second = z * (1.0 / D);
      const T parallel = second + along, square = s.scale * s.scale;
      const T crossed = t - across;  // 0 for a linear law
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) coupling[i][j] = (q[i][j] - z * s.inverse[j][i]) * (1.0 / D);
      // -(Q (x) G + G (x) Q)/D + parallel G (x) G = G (x) R + R (x) G
      Small<T, D> r;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) r[i][j] = 0.5 * parallel * s.inverse[j][i] - (1.0 / D) * q[i][j];
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t m = 0; m < D; ++m)
            for (std::size_t n = 0; n < D; ++n) {
              local[i * D + j][m * D + n] = square * a[i * D + j][m * D + n] + s.inverse[j][i] * r[m][n] +
                                            r[i][j] * s.inverse[n][m] + crossed * (s.inverse[n][i] * s.inverse[j][m]);
            }
    }

    Small<T, D * D> local;
    Small<T, D> coupling;
    T second;
  };
};

}  // namespace ixos
