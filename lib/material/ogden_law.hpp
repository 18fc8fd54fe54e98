/// Ogden's elastic law in the principal stretches.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "base/eigenpairs.hpp"
#include "material/exp_series.hpp"
#include "material/lame.hpp"
#include "material/log_series.hpp"
#include "material/strain_state.hpp"
#include "material/symmetric_moduli.hpp"
#include "material/volumetric_energy.hpp"

namespace ixos {

/// W = sum_p mu_p/a_p sum_i (lb_i^a_p - 1) + U(J) with the isochoric stretches lb_i = exp(e_i) (Ogden 1972; Holzapfel
/// 2000, section 6.5). The eigenpairs (a_i, N_i) of A = C - I give l_i = log1p(a_i)/2 and e_i = l_i - (l_1 + l_2 +
/// l_3)/3; as the e_i have the sum 0, sum_i (exp(a_p e_i) - 1) = sum_i m(a_p e_i), m(x) = exp(x) - 1 - x. StrainLaw
/// makes an elastic law of it; see IsochoricLaw for what the functions compute.
struct OgdenLaw {
  struct Term {
    double modulus, exponent;  ///< mu_p [E0], a_p [-]
  };
  static constexpr bool has_limit = false;
  std::vector<Term> terms;
  VolumetricEnergy volumetric;
  Lame lame;  ///< mu = sum_p mu_p a_p/2

  template <std::size_t D, class T>
  T energy(const StrainState<D, T>& s) const {
    const Principal<D, T> at(s);
    T sum = volumetric.energy(s.change, s.l);
    for (const Term& term : terms)
      for (const T& e : at.strain) sum += term.modulus / term.exponent * exp_remainder(T(term.exponent * e));
    return sum;
  }

  template <std::size_t D, class T>
  Small<T, D> mixed_stress(const StrainState<D, T>& s) const {
    const Principal<D, T> at(s);
    return mixed_stress(at, stresses(s, at));
  }

  /// With the eigenvalues c_i = 1 + a_i of C and S_i = tau_i/c_i, dS/dC is the sum of dS_i/dc_j N_ii (x) N_jj and of 2
  /// (S_i - S_j)/(c_i - c_j) N_ij (x) N_ij over i < j, N_ij = (N_i N_j^T + N_j N_i^T)/2. The quotient is written in
  /// functions that are regular at c_i = c_j.
  template <std::size_t D, class T>
  SymmetricModuli<D, T> moduli(const StrainState<D, T>& s, const Small<T, D>& /*inverse*/) const {
    const Principal<D, T> at(s);
    return moduli(s, at, stresses(s, at));
  }

  /// Returns the moduli and sets `mixed` to mixed_stress(s).
  template <std::size_t D, class T>
  SymmetricModuli<D, T> mixed_stress_and_moduli(const StrainState<D, T>& s, const Small<T, D>& /*inverse*/,
                                                Small<T, D>& mixed) const {
    const Principal<D, T> at(s);
    const std::array<T, 3> tau = stresses(s, at);
    mixed = mixed_stress(at, tau);
    return moduli(s, at, tau);
  }

 private:
  /// Eigenpairs of A in the space of the body, and logarithms of all stretches.
  template <std::size_t D, class T>
  struct Principal {
    explicit Principal(const StrainState<D, T>& s) : pairs(eigenpairs(s.a)) {
      T mean(0.0);
      strain[2] = T(0.0);  // plane strain
      for (std::size_t i = 0; i < D; ++i) {
        strain[i] = 0.5 * log_one_plus(pairs.value[i]);
        mean += strain[i] * (1.0 / 3);
      }
      for (T& e : strain) e -= mean;
    }
    Eigenpairs<T, D> pairs;
    std::array<T, 3> strain;  ///< e_i
  };
  template <std::size_t D, class T>
  static Small<T, D> mixed_stress(const Principal<D, T>& at, const std::array<T, 3>& tau) {
    Small<T, D> result{};
    for (std::size_t n = 0; n < D; ++n)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) result[i][j] += tau[n] * (at.pairs.vector[n][i] * at.pairs.vector[n][j]);
    return result;
  }

  template <std::size_t D, class T>
  SymmetricModuli<D, T> moduli(const StrainState<D, T>& s, const Principal<D, T>& at,
                               const std::array<T, 3>& tau) const {
    const Small<T, 3> slope = slopes(s, at);  // dtau_i/dl_j
    SymmetricModuli<D, T> result{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        const T ci = 1.0 + at.pairs.value[i], cj = 1.0 + at.pairs.value[j];
        if (j < i) {
          add_product(T(2.0 * quotient(at, tau, i, j)), tensor(at, i, j), tensor(at, i, j), result);
        }
        T value = 0.5 * slope[i][j] / (ci * cj);
        if (i == j) value -= tau[i] / (ci * ci);
        add_product(value, tensor(at, i, i), tensor(at, j, j), result);
      }
    return result;
  }

  template <class T, std::size_t D>
  using Components = std::array<T, SymmetricPairs<D>::size>;

  /// Returns tau_i.
  template <std::size_t D, class T>
  std::array<T, 3> stresses(const StrainState<D, T>& s, const Principal<D, T>& at) const {
    std::array<T, 3> tau;
    tau.fill(volumetric.pressure(s.change, s.l));
    for (const Term& term : terms) {
      std::array<T, 3> growth;
      T mean(0.0);
      for (std::size_t i = 0; i < 3; ++i) {
        const T x = term.exponent * at.strain[i];
        growth[i] = x + exp_remainder(x);
        mean += growth[i] * (1.0 / 3);
      }
      for (std::size_t i = 0; i < 3; ++i) tau[i] += term.modulus * (growth[i] - mean);
    }
    return tau;
  }

  /// Returns dtau_i/dl_j.
  template <std::size_t D, class T>
  Small<T, 3> slopes(const StrainState<D, T>& s, const Principal<D, T>& at) const {
    Small<T, 3> result;
    for (auto& row : result) row.fill(volumetric.stiffness(s.change, s.l));
    for (const Term& term : terms) {
      const double factor = term.modulus * term.exponent;
      std::array<T, 3> power;
      T mean(0.0);
      for (std::size_t i = 0; i < 3; ++i) {
        const T x = term.exponent * at.strain[i];
        power[i] = 1.0 + x + exp_remainder(x);
        mean += power[i] * (1.0 / 3);
      }
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          result[i][j] -= (factor / 3) * (power[i] + power[j] - mean);
          if (i == j) result[i][j] += factor * power[i];
        }
    }
    return result;
  }

  /// Returns (S_i - S_j)/(c_i - c_j) = (tau_i - tau_j)/(c_i (c_i - c_j)) - tau_j/(c_i c_j), with tau_i - tau_j = sum_p
  /// mu_p exp(a_p e_j) (exp(a_p d) - 1) and d = ln(c_i/c_j)/2.
  template <std::size_t D, class T>
  T quotient(const Principal<D, T>& at, const std::array<T, 3>& tau, std::size_t i, std::size_t j) const {
    const T ci = 1.0 + at.pairs.value[i], cj = 1.0 + at.pairs.value[j];
    const T ratio = (at.pairs.value[i] - at.pairs.value[j]) / cj, l = log_one_plus(ratio);
    T sum(0.0);
    for (const Term& term : terms) {
      const T x = term.exponent * at.strain[j];
      sum += (term.modulus * term.exponent) * ((1.0 + x + exp_remainder(x)) * exp_quotient(T(0.5 * term.exponent * l)));
    }
    return (0.5 * log1p_quotient(ratio, l) * sum - tau[j]) / (ci * cj);
  }

  /// Returns the components of N_ij.
  template <std::size_t D, class T>
  static Components<T, D> tensor(const Principal<D, T>& at, std::size_t i, std::size_t j) {
    Components<T, D> result;
    const auto& m = at.pairs.vector[i];
    const auto& n = at.pairs.vector[j];
    for (std::size_t p = 0; p < result.size(); ++p) {
      const auto [k, l] = SymmetricPairs<D>::list[p];
      result[p] = 0.5 * (m[k] * n[l] + m[l] * n[k]);
    }
    return result;
  }
  template <class T, std::size_t Size>
  static void add_product(const T& factor, const std::array<T, Size>& left, const std::array<T, Size>& right,
                          Small<T, Size>& result) {
    for (std::size_t p = 0; p < Size; ++p)
      for (std::size_t q = 0; q < Size; ++q) result[p][q] += factor * (left[p] * right[q]);
  }
};

}  // namespace ixos
