/// A discrete gradient of any law of Green's strain: a stress whose work over a step is the change of the stored
/// energy.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "material/strain_state.hpp"
#include "material/symmetric_moduli.hpp"

namespace ixos {

/// P = F_m S between the displacement gradients H0 and H1 (admissible at both), with F_m the mean of F0 and F1. S is
/// symmetric, so angular momentum is kept, and S:(C1 - C0)/2 = W1 - W0 (Gonzalez 2000):
///
///   S = S_q + 2 d/|C1 - C0|^2 (C1 - C0),   d = W1 - W0 - S_q:(C1 - C0)/2.
///
/// Gonzalez takes the stress in the middle as S_q. The mean of two Gauss points on the line from C0 to C1 has a defect
/// d of the fifth order in place of the third: d is then below the rounding errors of the energy, and left out, before
/// the quotient loses its digits. The class leaves it out if it is less than 16 roundings of the energies, and in
/// steps of less than 1e-5 of the strain. If C0 and C1 are admissible, so is the line between them, for the laws of
/// this folder: det C > 0 and tr C < k det(C)^(1/3) are convex sets, as det(C)^(1/3) is concave.
template <class Law, std::size_t D, class T>
class GonzalezGradient {
  using Pairs = SymmetricPairs<D>;

 public:
  GonzalezGradient(const Law& law, const Small<T, D>& h0, const Small<T, D>& h1) : law_(law) {
    start_ = green_strain_doubled(h0);
    Small<T, D> change;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        mean_[i][j] = 0.5 * (h0[i][j] + h1[i][j]) + (i == j ? 1.0 : 0.0);
        change[i][j] = h1[i][j] - h0[i][j];
      }
    increment_ = symmetric_product(mean_, change);
    for (auto& row : increment_)
      for (T& value : row) value *= 2.0;
    end_ = deformation_gradient(h1);
    end_strain_ = green_strain_doubled(h1);
    end_jacobian_ = determinant(end_);
    second_ = {};
    for (const double place : places) {
      const StrainState<D, T> s(between(place));
      const Small<T, D> at = product(inverse_of(s), law_.mixed_stress(s));
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) second_[i][j] += 0.25 * (at[i][j] + at[j][i]);
    }
    correct(h0);
  }

  /// Returns P_iJ [E0].
  Small<T, D> stress() const { return product(mean_, corrected()); }

  /// Computes A[iJ][kL] = dP_iJ/dF1_kL [E0]; unsymmetric.
  void moduli(Small<T, D * D>& a) const {
    SymmetricModuli<D, T> m{};
    for (const double place : places) {
      const StrainState<D, T> s(between(place));
      const SymmetricModuli<D, T> at = law_.moduli(s, inverse_of(s));
      for (std::size_t p = 0; p < Pairs::size; ++p)
        for (std::size_t q = 0; q < Pairs::size; ++q) m[p][q] += (0.5 * place) * at[p][q];
    }
    add_correction(m);
    push_forward(m, corrected(), mean_, end_, 0.5, a);
  }

 private:
  static constexpr std::array<double, 2> places{0.21132486540518711775, 0.78867513459481288225};

  /// Returns A on the line from A0 to A1.
  Small<T, D> between(double place) const {
    Small<T, D> result = start_;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) result[i][j] += place * increment_[i][j];
    return result;
  }
  static Small<T, D> inverse_of(const StrainState<D, T>& s) {
    return inverse(deformation_gradient(s.a), T(1.0 + s.change));  // C = I + A
  }

  void correct(const Small<T, D>& h0) {
    using std::abs;
    using std::sqrt;
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    const StrainState<D, T> s0(start_, determinant(deformation_gradient(h0)));
    const StrainState<D, T> s1(end_strain_, end_jacobian_);
    const T w0 = law_.energy(s0), w1 = law_.energy(s1);
    square_ = contraction(increment_, increment_);
    const T defect = w1 - w0 - 0.5 * contraction(second_, increment_);
    const T scale = abs(w0) + abs(w1) + sqrt(T(contraction(second_, second_) * square_));
    const T strain = contraction(start_, start_) + contraction(s1.a, s1.a);
    const auto counts = abs(defect) > rounding * scale && square_ > 1e-10 * strain;
    factor_ = select(counts, T(2.0 * defect / select(counts, square_, T(1.0))), T(0.0));
  }

  Small<T, D> corrected() const {
    Small<T, D> s = second_;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) s[i][j] += factor_ * increment_[i][j];
    return s;
  }

  /// Adds the derivative of r (C1 - C0), r = 2 d/|C1 - C0|^2: r I o I + (C1 - C0) (x) dr/dC1.
  void add_correction(SymmetricModuli<D, T>& m) const {
    using std::abs;
    const auto counts = abs(factor_) > 0.0;
    const T square = select(counts, square_, T(1.0));
    const Small<T, D> g = inverse(end_, end_jacobian_);
    const StrainState<D, T> s1(end_strain_, end_jacobian_);
    const Small<T, D> mixed = law_.mixed_stress(s1);
    std::array<T, Pairs::size> slope;
    for (std::size_t q = 0; q < Pairs::size; ++q) {
      const auto [k, l] = Pairs::list[q];
      T end(0.0);  // S1 = F1^-1 (F1^-T (C1 S1))
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) end += g[k][i] * g[j][i] * mixed[j][l];
      T turned(0.0);  // (C1 - C0) : dS_q/dC1
      for (std::size_t p = 0; p < Pairs::size; ++p)
        turned += Pairs::count(p) * (increment_[Pairs::list[p][0]][Pairs::list[p][1]] * m[p][q]);
      const T value = (end - second_[k][l] - turned - 2.0 * factor_ * increment_[k][l]) / square;
      slope[q] = select(counts, value, T(0.0));
    }
    for (std::size_t p = 0; p < Pairs::size; ++p) {
      const auto [i, j] = Pairs::list[p];
      for (std::size_t q = 0; q < Pairs::size; ++q) m[p][q] += increment_[i][j] * slope[q];
      m[p][p] += factor_ * (1.0 / Pairs::count(p));
    }
  }

  const Law& law_;
  Small<T, D> mean_, end_;  ///< F_m, F1
  T end_jacobian_;
  Small<T, D> start_, end_strain_, increment_;  ///< C0 - I, C1 - I, C1 - C0
  Small<T, D> second_;                          ///< S_q
  T square_, factor_;                           ///< |C1 - C0|^2, r; r = 0 where the correction is left out
};

}  // namespace ixos
