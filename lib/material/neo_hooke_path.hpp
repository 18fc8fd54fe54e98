/// Sums of neo-Hookean stresses and moduli over points of a straight path.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "material/lame.hpp"
#include "material/log_series.hpp"
#include "material/strain.hpp"

namespace ixos {

/// The cofactors of H0 + t dH, det(H) H^-T, by their degree in t. In two dimensions, where they are linear in H, none.
template <std::size_t D, class T>
using QuadraticCofactors = std::array<Small<T, D>, D == 3 ? 3 : 0>;
template <class T>
QuadraticCofactors<2, T> quadratic_cofactors(const Small<T, 2>& /*h*/, const Small<T, 2>& /*d*/) {
  return {};
}
template <class T>
[[gnu::always_inline]] inline QuadraticCofactors<3, T> quadratic_cofactors(const Small<T, 3>& h, const Small<T, 3>& d) {
  QuadraticCofactors<3, T> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, e = (j + 2) % 3;
      result[0][i][j] = h[a][c] * h[b][e] - h[a][e] * h[b][c];
      result[1][i][j] = h[a][c] * d[b][e] + d[a][c] * h[b][e] - h[a][e] * d[b][c] - d[a][e] * h[b][c];
      result[2][i][j] = d[a][c] * d[b][e] - d[a][e] * d[b][c];
    }
  return result;
}

/// Stresses and moduli of NeoHooke, summed over points t of the path H0 + t (H1 - H0) with weights. With the cofactors
/// C = J F^-T of F, P = mu F + q C, q = (lambda ln J - mu)/J. F is linear in t, C quadratic and J cubic, so that a
/// point needs J, ln J and a few scalar sums; the tensors are put together once. J - 1 and P are written in the
/// invariants of H: small strains keep their digits. ln J and 1/J follow from those in the middle by series. If J
/// differs by more than a hundredth from there, or by three tenths from 1, is_near() is false: the caller evaluates the
/// law point by point. Padding is a small part of an object.
template <std::size_t D, class T>
class NeoHookePath {                         // NOLINT(clang-analyzer-optin.performance.Padding)
  static constexpr std::size_t degrees = D;  // the cofactors are of degree D - 1

 public:
  /// The sums that moduli() needs, and the path. The cofactors follow from the path.
  struct Sums {                           // NOLINT(clang-analyzer-optin.performance.Padding)
    Small<T, D> start, change;            ///< H0, H1 - H0
    double weight = 0;                    ///< sum of the weights of the moduli
    std::array<T, D == 3 ? 2 : 1> q{};    ///< sums of q t^k
    std::array<T, 2 * degrees - 1> dq{};  ///< sums of dq/dJ t^k
    bool is_near = true;
  };

  /// `law` has the constants as its member `lame`.
  template <class Law>
  NeoHookePath(const Law& law, const Small<T, D>& h0, const Small<T, D>& h1) : lame_(law.lame) {
    sums_.start = h0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) sums_.change[i][j] = h1[i][j] - h0[i][j];
    const auto& start = sums_.start;
    const auto& change = sums_.change;
    cofactors_ = quadratic_cofactors(start, change);
    trace_ = {trace(start), trace(change)};
    // J - 1 - tr H: the second invariant of H, the trace of the cofactors, and the determinant.
    if constexpr (D == 2) {
      higher_ = {determinant(start),
                 start[0][0] * change[1][1] + change[0][0] * start[1][1] - start[0][1] * change[1][0] -
                     change[0][1] * start[1][0],
                 determinant(change), T(0.0)};
    } else {
      higher_ = {trace(cofactors_[0]) + first_row(start, cofactors_[0]),
                 trace(cofactors_[1]) + contraction(cofactors_[0], change),
                 trace(cofactors_[2]) + contraction(cofactors_[2], start), first_row(change, cofactors_[2])};
    }
    middle_ = change_of_volume(0.5);
    sums_.is_near = is_below(middle_, 0.3);
    middle_log_ = log_one_plus(middle_);
    middle_inverse_ = 1.0 / (1.0 + middle_);
  }

  /// Adds a point to the sum of stresses; with_moduli also weight times `to` to that of moduli. Returns J.
  template <bool with_moduli = false>
  [[gnu::always_inline]] T add_stress(double weight, double t) {
    const T first = trace_[0] + t * trace_[1], higher = higher_at(t);
    const Point p = at(T(first + higher));
    const T r = weight * p.inverse, pressure = lame_.lambda * (r * p.log), q = pressure - lame_.mu * r;
    mean_ += lame_.mu * (r * higher) + pressure * (1.0 + first);
    add_moments<degrees>(q, t, coefficient_);
    weight_ += weight;
    weighted_t_ += weight * t;
    if constexpr (with_moduli) add_to_moduli(weight * t, t, p, T(t * q));
    return p.jacobian;
  }

  /// Adds a point to the sum of moduli.
  void add_moduli(double weight, double t) {
    const Point p = at(change_of_volume(t));
    const T r = weight * p.inverse;
    add_to_moduli(weight, t, p, T(r * (lame_.lambda * p.log - lame_.mu)));
  }

  /// Returns whether J was near that in the middle at all points, and that near 1: if not, the sums are unusable.
  bool is_near() const { return sums_.is_near; }
  const Sums& sums() const { return sums_; }

  /// Returns the sum of the weighted stresses P_iJ [E0], times a factor.
  Small<T, D> stress(const T& factor) const {
    Small<T, D> p;
    const T mu0 = factor * (lame_.mu * weight_), mu1 = factor * (lame_.mu * weighted_t_);
    std::array<T, degrees> q;
    for (std::size_t k = 0; k < degrees; ++k) q[k] = factor * coefficient_[k];
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        p[i][j] =
            mu0 * sums_.start[i][j] + mu1 * sums_.change[i][j] - q[0] * sums_.start[j][i] - q[1] * sums_.change[j][i];
        if constexpr (D == 3)
          for (std::size_t k = 0; k < degrees; ++k) p[i][j] += q[k] * cofactors_[k][i][j];
      }
    for (std::size_t i = 0; i < D; ++i) p[i][i] += factor * mean_;
    return p;
  }

  /// Computes the sum of the weighted moduli A[iJ][kL] = dP_iJ/dF_kL [E0], times a factor.
  void moduli(const T& factor, Small<T, D * D>& a) const { moduli(lame_, sums_, cofactors_, factor, a); }
  template <class Law>
  static void moduli(const Law& law, const Sums& sums, const T& factor, Small<T, D * D>& a) {
    moduli(law.lame, sums, quadratic_cofactors(sums.start, sums.change), factor, a);
  }

 private:
  struct Point {
    T jacobian, inverse, log;  ///< J, 1/J, ln J
  };

  T higher_at(double t) const {
    if constexpr (D == 2) return higher_[0] + t * (higher_[1] + t * higher_[2]);
    return higher_[0] + t * (higher_[1] + t * (higher_[2] + t * higher_[3]));
  }
  T change_of_volume(double t) const { return trace_[0] + t * trace_[1] + higher_at(t); }

  static bool is_below(const T& x, double limit) {
    using std::abs;
    return everywhere(abs(x) < limit);
  }

  [[gnu::always_inline]] Point at(const T& change) {
    Point p;
    const T relative = (change - middle_) * middle_inverse_;
    sums_.is_near = sums_.is_near && is_below(relative, log_and_inverse_limit);
    p.jacobian = 1.0 + change;
    log_and_inverse(relative, p.log, p.inverse);
    p.log += middle_log_;
    p.inverse *= middle_inverse_;
    return p;
  }

  void add_to_moduli(double weight, double t, const Point& p, const T& q) {
    // dq/dJ = (lambda - q J)/J^2
    add_moments<D == 3 ? 2 : 1>(q, t, sums_.q);
    add_moments<2 * degrees - 1>(T(p.inverse * (weight * lame_.lambda * p.inverse - q)), t, sums_.dq);
    sums_.weight += weight;
  }

  /// Adds value t^k for k < count.
  template <std::size_t count, std::size_t size>
  static void add_moments(T value, double t, std::array<T, size>& sums) {
    for (std::size_t k = 0; k < count; ++k) {
      sums[k] += value;
      value *= t;
    }
  }

  /// Returns the determinant of a matrix, given its cofactors.
  static T first_row(const Small<T, 3>& m, const Small<T, 3>& cofactors) {
    return m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
  }

  [[gnu::noinline]] static void moduli(const Lame& lame, const Sums& sums, const QuadraticCofactors<D, T>& cofactors,
                                       const T& factor, Small<T, D * D>& a) {
    std::array<std::array<T, D * D>, degrees> c, weighted;  // the cofactors of F, and their sums with dq/dJ
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        c[0][i * D + j] = -sums.start[j][i];
        c[1][i * D + j] = -sums.change[j][i];
        if constexpr (D == 3) {
          c[0][i * D + j] += cofactors[0][i][j];
          c[1][i * D + j] += cofactors[1][i][j];
          c[2][i * D + j] = cofactors[2][i][j];
        }
      }
    const T first = 1.0 + trace(sums.start), second = trace(sums.change);
    for (std::size_t i = 0; i < D; ++i) {
      c[0][i * D + i] += first;
      c[1][i * D + i] += second;
    }
    std::array<T, 2 * degrees - 1> s;
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = factor * sums.dq[k];
    for (std::size_t k = 0; k < degrees; ++k)
      for (std::size_t r = 0; r < D * D; ++r) {
        weighted[k][r] = s[k] * c[0][r];
        for (std::size_t m = 1; m < degrees; ++m) weighted[k][r] += s[k + m] * c[m][r];
      }
    const T mu = factor * (lame.mu * sums.weight);
    std::array<T, D == 3 ? 2 : 1> q;
    for (std::size_t k = 0; k < q.size(); ++k) q[k] = factor * sums.q[k];
    for (std::size_t r = 0; r < D * D; ++r)
      for (std::size_t k = r; k < D * D; ++k) {
        T sum = c[0][r] * weighted[0][k];
        for (std::size_t m = 1; m < degrees; ++m) sum += c[m][r] * weighted[m][k];
        if (r == k) sum += mu;
        add_change_of_cofactors(sums, q, r / D, r % D, k / D, k % D, sum);
        a[r][k] = a[k][r] = sum;
      }
  }

  /// Adds q dC_iJ/dF_kL, with dC_iJ/dF_kL = e_ikm e_JLN F_mN, in the plane e_ik e_JL.
  template <class Q>
  [[gnu::always_inline]] static void add_change_of_cofactors(const Sums& sums, const Q& q, std::size_t i, std::size_t j,
                                                             std::size_t k, std::size_t l, T& sum) {
    if (i == k || j == l) return;
    T value = q[0];
    if constexpr (D == 3) {
      const std::size_t m = 3 - i - k, n = 3 - j - l;
      value = q[0] * sums.start[m][n] + q[1] * sums.change[m][n];
      if (m == n) value += q[0];
    }
    const bool even = D == 2 ? i == j : (k == (i + 1) % 3) == (l == (j + 1) % 3);
    if (even)
      sum += value;
    else
      sum -= value;
  }

  Lame lame_;
  Sums sums_;
  QuadraticCofactors<D, T> cofactors_;  ///< of H
  std::array<T, 2> trace_;
  std::array<T, 4> higher_;
  T middle_, middle_log_, middle_inverse_;  ///< J - 1, ln J and 1/J at t = 1/2
  double weight_ = 0, weighted_t_ = 0;
  T mean_ = T(0.0);
  std::array<T, degrees> coefficient_{};  ///< sums of q t^k
};

}  // namespace ixos
