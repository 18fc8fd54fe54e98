/// Stress and moduli of several Maxwell branches at a point.
#pragma once
#include <array>
#include <cstddef>

#include "element/maxwell_point.hpp"

namespace ixos {

/// Stress and moduli of several branches at a point, added up.
template <class Components, class T>
class BranchSum {
 public:
  using Strain = IsochoricStrain<Components, T>;
  using Branch = FrozenBranch<Components, T>;
  using Algebra = TensorAlgebra<Components, T>;
  using Tensor = Small<T, 3>;

  /// The strain must outlive the object.
  explicit BranchSum(const Strain& strain) : strain_(strain), modulus_(0.0) {
    inverse_change_ = Algebra::make([](std::size_t, std::size_t) { return T(0.0); });
  }

  void add(double modulus, const Branch& branch) {
    modulus_ += modulus;
    const Tensor y = branch.inverse_change();
    for (const auto& [i, j] : Components::all) inverse_change_[i][j] += modulus * y[i][j];
  }

  /// Returns the first Piola-Kirchhoff stress F^-T mu J^(-2/3) dev(C X) [E0]. dev(C X) = dev(A + Y + A Y) with A = C -
  /// I and Y = X - I keeps the digits of small strains.
  Tensor stress() const {
    Tensor s = Algebra::product(strain_.a, inverse_change_);
    for (const auto& [i, j] : Components::all) s[i][j] += modulus_ * strain_.a[i][j] + inverse_change_[i][j];
    s = Algebra::shifted(s, T(Algebra::trace(s) * (-1.0 / 3)));
    const Tensor p = Algebra::product(strain_.inverse, s);
    return Algebra::make([&](std::size_t i, std::size_t j) { return T(strain_.scale * p[i][j]); });
  }

 private:
  const Strain& strain_;
  double modulus_;
  Tensor inverse_change_;  ///< sum of mu (X - I)
};

/// The derivative of that stress, symmetric. The branches are added up in the deformed body, before the sum
/// is brought to the undeformed one, so that a further branch costs little. With (A o A)_ijkl = (A_ik A_jl + A_il
/// A_jk)/2, k = J^(-2/3) F X F^T of a branch and the sums over the branches K = sum mu k, N = sum mu r (k o k - k (x)
/// k/3),
///   c = v (x) I + I (x) v + tr K/3 I o I - N,   v = (N:I - K)/3 + (tr K - I:N:I)/18 I,   S = F^-1 (K - tr K/3 I) F^-T,
///   A_iJkL = 2 c_ijkl (F^-T)_jJ (F^-T)_lL + delta_ik S_JL.
/// (Derived here from the second derivative of E.)
template <class Components, class T>
class BranchModuli {
 public:
  using Strain = IsochoricStrain<Components, T>;
  using Branch = FrozenBranch<Components, T>;
  using Algebra = TensorAlgebra<Components, T>;
  using Tensor = Small<T, 3>;

  BranchModuli() {
    for (auto& row : second_) row.fill(T(0.0));
    first_.fill(T(0.0));
  }

  /// Adds a branch; the strain is the same for all.
  [[gnu::always_inline]] void add(double modulus, const Strain& strain, const Branch& branch) {
    const Tensor x = Algebra::shifted(branch.inverse_change(), T(1.0)), fx = Algebra::product(strain.f, x);
    Tensor k;
    each_pair([&](auto, auto i, auto j) __attribute__((always_inline)) {
      k[i][j] = k[j][i] = strain.scale * Algebra::sum(i, j, [&](std::size_t n) { return fx[i][n] * strain.f[j][n]; });
    });
    const T factor = modulus * branch.softening();
    each_pair([&](auto p, auto i, auto j) __attribute__((always_inline)) {
      first_[p] += modulus * k[i][j];
      each_pair([&](auto q, auto m, auto l) __attribute__((always_inline)) {
        if constexpr (q <= p) second_[p][q] += factor * less_a_third<i, j, m, l>(k);
      });
    });
  }

  /// Adds weight times dP/dF to the lower triangle of the moduli between the first C of `Components::all`.
  template <std::size_t C>
  [[gnu::always_inline]] void add_to(const T& weight, const Strain& strain, Small<T, C>& moduli) const {
    constexpr std::size_t pairs = C == 4 ? 3 : size;  // in plane strain nothing changes across the plane
    const Small<T, pairs> c = spatial<pairs>(T(2.0 * weight));
    const Tensor& g = strain.inverse;
    const Tensor s = stress(weight, g);
    unroll<C>([&](auto row) __attribute__((always_inline)) {
      constexpr std::size_t i = Components::all[row][0], j = Components::all[row][1];
      std::array<T, pairs> half;  // c_injl (F^-T)_nJ
      unroll<pairs>([&](auto q) __attribute__((always_inline)) {
        half[q] = Algebra::sum(i, j, [&](std::size_t n) { return c[place(i, n)][q] * g[n][j]; });
      });
      unroll<row + 1>([&](auto column) __attribute__((always_inline)) {
        constexpr std::size_t k = Components::all[column][0], l = Components::all[column][1];
        T entry = Algebra::sum(k, l, [&](std::size_t n) { return half[place(k, n)] * g[n][l]; });
        if constexpr (i == k && Components::has(j, l)) entry += s[j][l];
        moduli[row][column] += entry;
      });
    });
  }

 private:
  static constexpr std::size_t size = Components::symmetric.size();

  /// Returns the place of a component in Components::symmetric; one beyond its end if the component is zero.
  static constexpr std::size_t place(std::size_t i, std::size_t j) {
    std::size_t p = 0;
    while (p < size &&
           !(Components::symmetric[p][0] == (i < j ? i : j) && Components::symmetric[p][1] == (i < j ? j : i)))
      ++p;
    return p;
  }
  static constexpr bool on_diagonal(std::size_t pair) {
    return Components::symmetric[pair][0] == Components::symmetric[pair][1];
  }
  /// Calls visit(place, i, j) for the components of a symmetric tensor.
  template <class Visit>
  [[gnu::always_inline]] static void each_pair(const Visit& visit) {
    unroll<size>([&](auto p) __attribute__((always_inline)) {
      visit(p, std::integral_constant<std::size_t, Components::symmetric[p][0]>{},
            std::integral_constant<std::size_t, Components::symmetric[p][1]>{});
    });
  }
  /// Returns (A o A - A (x) A/3)_ijkl.
  template <std::size_t i, std::size_t j, std::size_t k, std::size_t l>
  [[gnu::always_inline]] static T less_a_third(const Tensor& a) {
    T result = (-1.0 / 3) * a[i][j] * a[k][l];
    if constexpr (Components::has(i, k) && Components::has(j, l)) result += 0.5 * a[i][k] * a[j][l];
    if constexpr (Components::has(i, l) && Components::has(j, k)) result += 0.5 * a[i][l] * a[j][k];
    return result;
  }

  T trace(const std::array<T, size>& a) const { return a[place(0, 0)] + a[place(1, 1)] + a[place(2, 2)]; }

  /// Returns weight S, given F^-T.
  [[gnu::always_inline]] Tensor stress(const T& weight, const Tensor& g) const {
    const T third = trace(first_) * (1.0 / 3);
    Tensor k;
    each_pair([&](auto p, auto i, auto j) __attribute__((always_inline)) {
      k[i][j] = k[j][i] = weight * (i == j ? T(first_[p] - third) : first_[p]);
    });
    const Tensor half = Algebra::product(k, g);
    return Algebra::make([&](std::size_t i, std::size_t j) {
      return Algebra::sum(i, j, [&](std::size_t n) { return g[n][i] * half[n][j]; });
    });
  }

  /// Returns weight c between the first components.
  template <std::size_t pairs>
  [[gnu::always_inline]] Small<T, pairs> spatial(const T& weight) const {
    std::array<T, size> v;  // N:I, then v
    unroll<size>([&](auto p) __attribute__((always_inline)) {
      const auto entry = [&](std::size_t q) { return q <= p ? second_[p][q] : second_[q][p]; };
      v[p] = entry(place(0, 0)) + entry(place(1, 1)) + entry(place(2, 2));
    });
    const T volume = trace(first_), along = (volume - trace(v)) * (1.0 / 18);
    unroll<size>([&](auto p) __attribute__((always_inline)) {
      v[p] = (1.0 / 3) * (v[p] - first_[p]);
      if constexpr (on_diagonal(p)) v[p] += along;
    });
    Small<T, pairs> c;
    unroll<pairs>([&](auto p) __attribute__((always_inline)) {
      unroll<p + 1>([&](auto q) __attribute__((always_inline)) {
        T entry = -second_[p][q];
        if constexpr (on_diagonal(q)) entry += v[p];
        if constexpr (on_diagonal(p)) entry += v[q];
        if constexpr (p == q) entry += volume * (on_diagonal(p) ? 1.0 / 3 : 1.0 / 6);
        c[p][q] = c[q][p] = weight * entry;
      });
    });
    return c;
  }

  std::array<T, size> first_;  ///< K
  Small<T, size> second_;      ///< N, lower triangle
};

}  // namespace ixos
