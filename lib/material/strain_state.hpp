/// A deformation as laws of Green's strain need it.
#pragma once
#include <cmath>
#include <cstddef>

#include "material/log_series.hpp"
#include "material/strain.hpp"

namespace ixos {

/// A = C - I, its invariants, and the volume ratio; plane strain (A_33 = 0) for D = 2. T is double, Pack, or an AD
/// type.
template <std::size_t D, class T>
struct StrainState {
  /// From a strain alone, det C > 0.
  explicit StrainState(const Small<T, D>& strain) : a(strain) {
    set_invariants();
    l = log_one_plus(change);
  }
  /// From A and J. ln det C keeps its digits in squeezed bodies, which C does not.
  StrainState(const Small<T, D>& strain, const T& jacobian) : a(strain) {
    set_invariants();
    l = log_determinant(first, change, jacobian);
  }

  /// Returns I1(A) - ln det C >= 0 without cancellation.
  T stretch() const {
    using std::abs;
    return select(abs(change) < 0.02, T(minus_log1p_series(change) * (change * change) - higher), T(first - l));
  }

  Small<T, D> a;
  T first, second;  ///< I1 and I2 of A
  T higher;         ///< I2 + I3
  T change;         ///< det C - 1
  T l;              ///< ln det C

 private:
  void set_invariants() {
    first = trace(a);
    second = second_invariant(a);
    higher = higher_invariants(a);
    change = first + higher;
  }
};

}  // namespace ixos
