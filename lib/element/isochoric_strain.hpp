/// A deformation as laws of the isochoric strain with a history need it.
#pragma once
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "material/components.hpp"
#include "material/cube_root.hpp"
#include "material/log_series.hpp"

namespace ixos {

/// The deformation at a point, from which all branches start, see MaxwellBranch; over any scalar type. It is computed
/// from H without cancellation at small strains.
template <class Components, class T>
struct IsochoricStrain {
  using Algebra = TensorAlgebra<Components, T>;
  using Tensor = Small<T, 3>;

  /// H, 3 x 3.
  [[gnu::always_inline]] explicit IsochoricStrain(const Tensor& h) : f(Algebra::shifted(h, T(1.0))) {
    a = Algebra::make([&](std::size_t i, std::size_t j) {
      return T(h[i][j] + h[j][i] + Algebra::sum(i, j, [&](std::size_t k) { return h[k][i] * h[k][j]; }));
    });
    const Tensor cofactors = Algebra::cofactors(f), minors = Algebra::cofactors(a);
    jacobian = Algebra::determinant(f, cofactors);
    const T over = 1.0 / jacobian;
    inverse = Algebra::make([&](std::size_t i, std::size_t j) { return T(cofactors[i][j] * over); });
    // z = J^(2/3) - 1 solves z (3 + z (3 + z)) = tr A + higher = det C - 1.
    const T first = Algebra::trace(a), higher = Algebra::trace(minors) + Algebra::determinant(a, minors);
    const T excess = first + higher;
    const auto near = near_undeformed(first, excess);
    T z = cube_root_minus_one(T(select(near, excess, T(0.0))));
    T rest = z * z * (3.0 + z) - higher;  // tr A - 3 z
    T root = 1.0 + z;
    if (!everywhere(near)) {
      using std::cbrt;
      root = select(near, root, T(cbrt(T(jacobian * jacobian))));
      z = select(near, z, T(root - 1.0));
      rest = select(near, rest, T(first - 3.0 * z));
    }
    scale = 1.0 / root;
    first_change = rest * scale;
    change =
        Algebra::make([&](std::size_t i, std::size_t j) { return T(scale * (i == j ? T(a[i][j] - z) : a[i][j])); });
  }

  Tensor f;        ///< F
  Tensor inverse;  ///< F^-T
  Tensor a;        ///< C - I
  Tensor change;   ///< Cb - I
  T first_change;  ///< its trace
  T scale;         ///< J^(-2/3)
  T jacobian;      ///< J
};

}  // namespace ixos
