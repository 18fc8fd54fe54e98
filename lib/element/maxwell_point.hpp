/// A Maxwell branch at a quadrature point: the potential of a step, and the history after it.
#pragma once
#include <cstddef>

#include "element/isochoric_strain.hpp"
#include "material/components.hpp"
#include "material/cube_root.hpp"

namespace ixos {

/// The length h of a step of backward Euler over a branch's relaxation time, as the weights of new and old in Ci =
/// unimod(Ci_n + (h/tau) Cb). (Shutov, Landgraf and Ihlemann 2013)
template <class T>
struct BranchStep {
  /// h at least 0; 0 freezes Ci.
  BranchStep(double h, double time) : fresh(h / (h + time)), old(time / (h + time)) {}
  /// From h/tau, at least 0.
  explicit BranchStep(const T& ratio) : fresh(ratio / (1.0 + ratio)), old(1.0 / (1.0 + ratio)) {}
  T fresh;  ///< w = (h/tau)/(1 + h/tau), 0 to 1
  T old;    ///< 1 - w, without cancellation
};

/// The history of a branch at a point, Ci = I + B with det Ci = 1, and what all time points of a step need of it.
template <class Components, class T>
struct BranchHistory {
  using Algebra = TensorAlgebra<Components, T>;
  using Tensor = Small<T, 3>;

  [[gnu::always_inline]] BranchHistory(const Tensor& b) : change(b) {  // NOLINT(google-explicit-constructor): it is B
    const Tensor minors = Algebra::cofactors(b);
    // tr B from the other invariants: det(I + B) = 1.
    first = -(Algebra::determinant(b, minors) + Algebra::trace(minors));
    // Ci^-1 = adj(I + B) = (1 + tr B) I - B + adj B, B symmetric.
    inverse_change = Algebra::make(
        [&](std::size_t i, std::size_t j) { return T((i == j ? T(first - b[i][j]) : T(-b[i][j])) + minors[i][j]); });
  }

  Tensor change;          ///< B
  Tensor inverse_change;  ///< Ci^-1 - I
  T first;                ///< tr B
};

/// A branch over a step whose history is frozen. With the history at the step's start, Ci = I + B, and a length h, its
/// energy is the incremental potential
///   E(F) = min over det X = 1 of mu/2 [tr(Cb X) - 3] + mu tau/(2 h) [tr(Ci X) - 3]
///        = 3/2 (mu/w) [det(I + Z)^(1/3) - 1],  Z = w (Cb - I) + (1 - w) B,  w = (h/tau)/(1 + h/tau),
/// whose minimiser is X = unimod(I + Z)^-1: backward Euler. With h = 0 it is the energy stored at fixed history.
template <class Components, class T>
class FrozenBranch {
 public:
  using Strain = IsochoricStrain<Components, T>;
  using Algebra = TensorAlgebra<Components, T>;
  using Tensor = Small<T, 3>;

  [[gnu::always_inline]] FrozenBranch(const Strain& strain, const BranchHistory<Components, T>& history,
                                      const BranchStep<T>& step)
      : fresh_(step.fresh) {
    const Tensor lag =  // Cb - Ci
        Algebra::make([&](std::size_t i, std::size_t j) { return T(strain.change[i][j] - history.change[i][j]); });
    stretch_ = (strain.first_change - history.first) + Algebra::contraction(history.inverse_change, lag);
    const T third = Algebra::determinant(lag, Algebra::cofactors(lag));
    z_ = Algebra::make([&](std::size_t i, std::size_t j) { return T(history.change[i][j] + step.fresh * lag[i][j]); });
    root_ = cube_root_minus_one(T((step.fresh * step.old) * (stretch_ - step.fresh * third)));
    inverse_root_ = 1.0 / (1.0 + root_);
  }

  /// Returns the energy stored at the frozen history over mu, [tr(Cb Ci^-1) - 3]/2.
  T stored() const { return 0.5 * stretch_; }
  /// Returns E/mu. h must be greater than 0: a quotient by w.
  T potential() const { return (1.5 / fresh_) * root_; }

  /// Returns the Ci - I that follows after a step of that length, unimod(I + Z) - I.
  Tensor updated() const {
    return Algebra::make(
        [&](std::size_t i, std::size_t j) { return T(inverse_root_ * (i == j ? T(z_[i][j] - root_) : z_[i][j])); });
  }
  /// Returns det(I + Z)^(1/3) - 1.
  const T& root() const { return root_; }

  /// Returns r = w/det(I + Z)^(1/3): a change of Cb changes X by r [tr(X dCb)/3 X - X dCb X].
  T softening() const { return fresh_ * inverse_root_; }

  /// Returns X - I.
  Tensor inverse_change() const {
    const Tensor minors = Algebra::cofactors(z_);
    const T square = root_ * (2.0 + root_), factor = inverse_root_ * inverse_root_, first = Algebra::trace(z_) - square;
    return Algebra::make([&](std::size_t i, std::size_t j) {
      return T(factor * ((i == j ? T(first - z_[i][j]) : T(-z_[i][j])) + minors[i][j]));
    });
  }

 private:
  T fresh_;  ///< w
  Tensor z_;
  T stretch_;  ///< tr(Cb Ci^-1) - 3
  T root_;     ///< det(I + Z)^(1/3) - 1
  T inverse_root_;
};

/// Returns the step whose updated() is of second order, from the strain in the middle of a step of length dt: Ci =
/// unimod(Ci_n + s Cb), s = (dt/tau) det(Ci_n + dt/(2 tau) Cb)^(1/3). The dissipation is positive in short steps
/// only, about tau/3. (Derived here.)
template <class Components, class T>
BranchStep<T> midpoint_step(const IsochoricStrain<Components, T>& middle, const Small<T, 3>& history, double dt,
                            double time) {
  const FrozenBranch<Components, T> half(middle, history, {dt / 2, time});
  return BranchStep<T>(T((dt / time * (1 + dt / (2 * time))) * (1.0 + half.root())));
}

/// Returns over mu what a step dissipates,
///   D/mu = [E(F) - psi(F, Ci)] - [E(F_n) - psi(F_n, Ci_n)],
/// psi the stored energy: the work of the mean of dE/dF over the step, less the change of psi. `step` is that of the
/// force, `updated` the Ci - I after the step.
template <class Components, class T>
T step_dissipation(const IsochoricStrain<Components, T>& from, const IsochoricStrain<Components, T>& to,
                   const Small<T, 3>& history, const Small<T, 3>& updated, const BranchStep<T>& step) {
  using Branch = FrozenBranch<Components, T>;
  const Branch start(from, history, step), end(to, history, step), after(to, updated, step);
  return (end.potential() - after.stored()) - (start.potential() - start.stored());
}

}  // namespace ixos
