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
/// where C1 - C0 vanishes; ln det C, a function of one number, needs none: with D the mean cofactor of C along C0 to
/// C1, x = D:(C1 - C0)/det C0 and q = log_one_plus(x)/(x det C0), S = mu I + q c D, c = -mu + lambda/4 (ln det C0 + ln
/// det C1). It is written in A = C - I, so that small strains keep their digits.
template <std::size_t D, class T>
class DiscreteNeoHooke {
 public:
  DiscreteNeoHooke(const Lame& lame, const Small<T, D>& h0, const Small<T, D>& h1) : lame_(lame) {
    Small<T, D> mean, change;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        mean[i][j] = 0.5 * (h0[i][j] + h1[i][j]);
        change[i][j] = h1[i][j] - h0[i][j];
      }
    mean_ = deformation_gradient(mean);
    end_ = deformation_gradient(h1);
    const Small<T, D> a0 = green_strain_doubled(h0);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        T sum(0.0);  // C1 - C0 = dF^T F_m + F_m^T dF
        for (std::size_t k = 0; k < D; ++k) sum += change[k][i] * mean_[k][j] + mean_[k][i] * change[k][j];
        increment_[i][j] = sum;
        middle_[i][j] = a0[i][j] + 0.5 * sum;
      }
    cofactor_ = cofactor_of_identity_plus(middle_);
    if constexpr (D == 3) {
      const Small<T, 3> quadratic = cofactor(increment_);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) cofactor_[i][j] += quadratic[i][j] * (1.0 / 12);
    }
    T j0 = trace(a0) + higher_invariants(a0);
    T change_of_determinant(0.0);
    for (std::size_t i = 0; i < D; ++i) {
      change_of_determinant += increment_[i][i];
      for (std::size_t j = 0; j < D; ++j) change_of_determinant += cofactor_[i][j] * increment_[i][j];
    }
    determinant0_ = 1.0 + j0;
    x_ = change_of_determinant / determinant0_;
    log_ = log_one_plus(x_);
    const T sum_of_logs = 2.0 * log_one_plus(j0) + log_;
    // 1 - log1p(x)/x, and with it 1 - q, without cancellation.
    const T rest = minus_log1p_quotient(x_, log_);
    one_minus_q_ = (j0 + rest) / determinant0_;
    q_ = (1.0 - rest) / determinant0_;
    pressure_ = lame_.lambda / 4 * sum_of_logs;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        second_[i][j] = q_ * (pressure_ - lame_.mu) * cofactor_[i][j];
        if (i == j) second_[i][j] += lame_.mu * one_minus_q_ + q_ * pressure_;
      }
  }

  /// P_iJ [E0].
  Small<T, D> stress() const { return product(mean_, second_); }

  /// A[iJ][kL] = dP_iJ/dF1_kL [E0]; unsymmetric.
  void moduli(Small<T, D * D>& a) const {
    const T c = pressure_ - lame_.mu;
    const T jacobian = determinant(end_);
    const T square = jacobian * jacobian;
    const Small<T, D> g = inverse(end_, jacobian);
    const T rank_one =
        2.0 * (c * log1p_quotient_slope(x_, log_) / (determinant0_ * determinant0_) * square + q_ * (lame_.lambda / 4));
    Small<T, D> left = product(mean_, cofactor_);  // F_m D
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) left[i][j] += mean_[i][j];
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k)
          for (std::size_t m = 0; m < D; ++m) {
            T value = rank_one * (left[i][j] * g[m][k]);
            if (i == k) value += 0.5 * second_[j][m];
            a[i * D + j][k * D + m] = value;
          }
    add_cofactor_change(T(q_ * c), a);
  }

 private:
  static Small<T, D> product(const Small<T, D>& m, const Small<T, D>& n) {
    Small<T, D> result;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        T sum = m[i][0] * n[0][j];
        for (std::size_t k = 1; k < D; ++k) sum += m[i][k] * n[k][j];
        result[i][j] = sum;
      }
    return result;
  }
  /// Of a symmetric matrix.
  static Small<T, 3> cofactor(const Small<T, 3>& m) {
    Small<T, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        result[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
      }
    return result;
  }
  /// cof(I + A) - I of a symmetric A.
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
  Small<T, D> mean_, end_;  ///< F_m, F1
  Small<T, D> middle_;      ///< C_m - I
  Small<T, D> increment_;   ///< C1 - C0
  Small<T, D> cofactor_;    ///< D - I
  Small<T, D> second_;      ///< S
  T determinant0_, x_, log_, q_, one_minus_q_, pressure_;
};

}  // namespace ixos
