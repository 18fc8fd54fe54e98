/// Linear forms in the unknown displacement and the known states, from which a scheme's formulas are built.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

/// s u_s + sum_j (p_j u_j + q_j dt v_j + r_j dt^2 a_j) over known states j: 0 is the step's start, k the end of stage
/// k. dt is the whole step. Rows are dimensionless, so no table holds a power of dt.
struct Row {
  struct Known {
    double u = 0;  ///< p_j
    double v = 0;  ///< q_j
    double a = 0;  ///< r_j
  };
  double unknown = 0;        ///< s
  std::vector<Known> known;  ///< by state; missing states count nothing

  /// Returns the value for a polynomial: u(t) sampled at the stage (time c) and at the known states (times c_j), in
  /// steps. `degree` 0, 1, 2 stands for u = 1, t, t^2 (dt = 1). A consistent row reproduces u's derivatives.
  double on_monomial(int degree, double c, const std::vector<double>& known_times) const;
  /// Returns the largest magnitude of a coefficient, the scale of the rounding errors of on_monomial().
  double magnitude() const;
};

Row unknown_displacement();
Row displacement(std::size_t state);  ///< u_j
Row velocity(std::size_t state);      ///< dt v_j
Row acceleration(std::size_t state);  ///< dt^2 a_j

Row operator+(Row left, const Row& right);
Row operator-(Row left, const Row& right);
Row operator*(double factor, Row row);
Row operator/(Row row, double divisor);

}  // namespace ixos
