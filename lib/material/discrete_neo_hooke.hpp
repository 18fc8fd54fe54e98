/// The neo-Hookean discrete gradient: a stress whose work over a step is the change of the stored energy, exactly.
#pragma once
#include <cmath>

#include "base/small_matrix.hpp"
#include "material/lame.hpp"
#include "material/log_series.hpp"
#include "material/strain.hpp"

namespace ixos {

/// Neo-Hooke (see NeoHooke) between the displacement gradients H0 and H1 (J > 0 at both), objective: P = F_m S with F_m
/// the mean of F0 and F1, and S symmetric with S:(C1 - C0)/2 = W1 - W0. Gonzalez' (2000) construction needs a switch
/// when C1 - C0 vanishes; ln det C, a function of one number, needs none: with D the mean cofactor of C along C0 to C1,
/// x = D:(C1 - C0)/det C0 and q = log_one_plus(x)/(x det C0), S = mu I + q c D, c = -mu + lambda/4 (ln det C0 + ln det
/// C1). Near the undeformed body it is written in A = C - I, so that small strains keep their digits. Otherwise it is
/// written in F, because C loses the digits of a squeezed body: a stretch of 1e-8 is 1e-16 in C, beside 1.
template <std::size_t D, class T>
class DiscreteNeoHooke {
 public:
  DiscreteNeoHooke(const Lame& lame, const Small<T, D>& h0, const Small<T, D>& h1) : lame_(lame) {
    start_ = deformation_gradient(h0);
    end_ = deformation_gradient(h1);
    Small<T, D> change;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        mean_[i][j] = 0.5 * (start_[i][j] + end_[i][j]);
        change[i][j] = h1[i][j] - h0[i][j];
      }
    const Small<T, D> a0 = green_strain_doubled(h0);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        T sum(0.0);  // C1 - C0 = dF^T F_m + F_m^T dF
        for (std::size_t k = 0; k < D; ++k) sum += change[k][i] * mean_[k][j] + mean_[k][i] * change[k][j];
        increment_[i][j] = sum;
        middle_[i][j] = a0[i][j] + 0.5 * sum;
      }
    if constexpr (D == 3) quadratic_ = cofactor(increment_);
    const T first = trace(a0), j0 = first + higher_invariants(a0);
    const Path near = near_path(j0);
    const T first1 = first + trace(increment_), j1 = j0 + near.x * near.determinant0;
    path_ = select_path(near_undeformed(first, j0) && near_undeformed(first1, j1), near);
  }

  /// Returns P_iJ [E0].
  Small<T, D> stress() const { return product(mean_, path_.second); }

  /// Computes A[iJ][kL] = dP_iJ/dF1_kL [E0]; unsymmetric.
  void moduli(Small<T, D * D>& a) const {
    const T c = path_.pressure - lame_.mu;
    const Small<T, D> g = inverse(end_, determinant(end_));
    const T rank_one =
        2.0 * (c * scaled_log1p_quotient_slope(path_.x, path_.log) / path_.determinant0 + path_.q * (lame_.lambda / 4));
    const Small<T, D> left = product(mean_, path_.cofactor);  // F_m D
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k)
          for (std::size_t m = 0; m < D; ++m) {
            T value = rank_one * (left[i][j] * g[m][k]);
            if (i == k) value += 0.5 * path_.second[j][m];
            a[i * D + j][k * D + m] = value;
          }
    add_cofactor_change(T(path_.q * c), a);
  }

 private:
  /// The path from C0 to C1: its mean cofactor D, the stress S and their scalars.
  struct Path {
    Small<T, D> cofactor;       ///< D
    Small<T, D> second;         ///< S
    T determinant0, x, log, q;  ///< log = ln(det C1/det C0)
    T pressure;                 ///< lambda/4 (ln det C0 + ln det C1)
  };

  Path near_path(const T& j0) const {
    Path path;
    Small<T, D> d = cofactor_of_identity_plus(middle_);  // D - I
    if constexpr (D == 3)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) d[i][j] += quadratic_[i][j] * (1.0 / 12);
    path.determinant0 = 1.0 + j0;
    const T change = trace(increment_) + contraction(d, increment_);
    // Series in place of divisions and logarithms where all strains are small.
    using std::abs;
    T log0, inverse0;
    if (everywhere(abs(j0) < log_and_inverse_limit)) {
      log_and_inverse(j0, log0, inverse0);
    } else {
      log0 = log_one_plus(j0);
      inverse0 = 1.0 / path.determinant0;
    }
    path.x = change * inverse0;
    T rest;  // 1 - log1p(x)/x, and with it 1 - q, without cancellation
    if (everywhere(abs(path.x) < log_and_inverse_limit)) {
      rest = minus_log1p_series(path.x) * path.x;
      path.log = path.x - path.x * rest;
    } else {
      path.log = log_one_plus(path.x);
      rest = minus_log1p_quotient(path.x, path.log);
    }
    path.pressure = lame_.lambda / 4 * (2.0 * log0 + path.log);
    path.q = (1.0 - rest) * inverse0;
    const T one_minus_q = (j0 + rest) * inverse0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        path.second[i][j] = path.q * (path.pressure - lame_.mu) * d[i][j];
        if (i == j) path.second[i][j] += lame_.mu * one_minus_q + path.q * path.pressure;
        path.cofactor[i][j] = d[i][j] + (i == j ? 1.0 : 0.0);
      }
    return path;
  }

  Path far_path() const {
    using std::log;
    Path path;
    const Small<T, D> cofactor0 = right_cofactor(start_), cofactor1 = right_cofactor(end_);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        path.cofactor[i][j] = 0.5 * (cofactor0[i][j] + cofactor1[i][j]);
        if constexpr (D == 3) path.cofactor[i][j] -= quadratic_[i][j] * (1.0 / 6);
      }
    const T jacobian0 = determinant(start_), ratio = determinant(end_) / jacobian0;
    path.determinant0 = jacobian0 * jacobian0;
    path.x = contraction(path.cofactor, increment_) / path.determinant0;
    path.log = log_one_plus(path.x, ratio);
    path.pressure = lame_.lambda / 4 * (2.0 * log(path.determinant0) + path.log);
    path.q = log1p_quotient(path.x, path.log) / path.determinant0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        path.second[i][j] = path.q * (path.pressure - lame_.mu) * path.cofactor[i][j] + (i == j ? lame_.mu : 0.0);
    return path;
  }

  template <class Mask>
  Path select_path(const Mask& near, const Path& close) const {
    if (everywhere(near)) return close;
    Path path = far_path();
    const auto choose = [&](const T& x, T& y) { y = select(near, x, y); };
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        choose(close.cofactor[i][j], path.cofactor[i][j]);
        choose(close.second[i][j], path.second[i][j]);
      }
    choose(close.determinant0, path.determinant0);
    choose(close.x, path.x);
    choose(close.log, path.log);
    choose(close.q, path.q);
    choose(close.pressure, path.pressure);
    return path;
  }

  /// Returns cof(F^T F), computed from F.
  static Small<T, D> right_cofactor(const Small<T, D>& f) {
    Small<T, D> result;
    if constexpr (D == 2) {
      result = {{{f[0][1] * f[0][1] + f[1][1] * f[1][1], -(f[0][0] * f[0][1] + f[1][0] * f[1][1])}, {}}};
      result[1][0] = result[0][1];
      result[1][1] = f[0][0] * f[0][0] + f[1][0] * f[1][0];
    } else {
      const Small<T, D> rows = cofactor(f);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          result[i][j] = rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j] + rows[2][i] * rows[2][j];
    }
    return result;
  }
  static Small<T, 3> cofactor(const Small<T, 3>& m) {
    Small<T, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        result[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
      }
    return result;
  }
  /// Returns cof(I + A) - I of a symmetric A.
  static Small<T, D> cofactor_of_identity_plus(const Small<T, D>& a) {
    Small<T, D> result;
    if constexpr (D == 3)
      result = cofactor(a);
    else
      result = {};
    const T sum = trace(a);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result[i][j] += (i == j ? sum : T(0.0)) - a[i][j];
    return result;
  }

  /// Adds factor F_m dD/dF1. D = cof(C_m) + cof(C1 - C0)/12 is quadratic: its change is the cofactor's polar form of
  /// Z = C_m/2 + (C1 - C0)/12 and dC1; in two dimensions the cofactor is linear.
  void add_cofactor_change(const T& factor, Small<T, D * D>& a) const {
    const Small<T, D> cross = times_transposed(mean_, end_);  // F_m F1^T
    if constexpr (D == 2) {
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t k = 0; k < D; ++k)
            for (std::size_t m = 0; m < D; ++m) {
              T value = mean_[i][j] * end_[k][m] - 0.5 * (mean_[i][m] * end_[k][j]);
              if (j == m) value -= 0.5 * cross[i][k];
              a[i * D + j][k * D + m] += factor * value;
            }
    } else {
      Small<T, D> z;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          z[i][j] = 0.5 * middle_[i][j] + increment_[i][j] * (1.0 / 12) + (i == j ? 0.5 : 0.0);
      const T t = trace(z);
      const Small<T, D> mean_z = product(mean_, z), end_z = product(end_, z);
      const Small<T, D> cross_z = times_transposed(mean_z, end_);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t k = 0; k < D; ++k)
            for (std::size_t m = 0; m < D; ++m) {
              T value = mean_z[i][m] * end_[k][j] + mean_[i][m] * end_z[k][j] + cross[i][k] * z[m][j] -
                        t * (mean_[i][m] * end_[k][j]) - 2.0 * (end_[k][m] * mean_z[i][j]) +
                        2.0 * (mean_[i][j] * (t * end_[k][m] - end_z[k][m]));
              if (j == m) value += cross_z[i][k] - t * cross[i][k];
              a[i * D + j][k * D + m] += factor * value;
            }
    }
  }
  static Small<T, D> times_transposed(const Small<T, D>& m, const Small<T, D>& n) {
    Small<T, D> result;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        T sum = m[i][0] * n[j][0];
        for (std::size_t k = 1; k < D; ++k) sum += m[i][k] * n[j][k];
        result[i][j] = sum;
      }
    return result;
  }

  Lame lame_;
  Small<T, D> start_, mean_, end_;  ///< F0, F_m, F1
  Small<T, D> middle_;              ///< C_m - I
  Small<T, D> increment_;           ///< C1 - C0
  Small<T, D> quadratic_;           ///< cof(C1 - C0), in three dimensions
  Path path_;
};

}  // namespace ixos
