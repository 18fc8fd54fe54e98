/// Rayleigh damping.
#pragma once
#include <vector>

#include "model/pattern.hpp"

namespace ixos {

/// The constant matrix C = sum over blocks of alpha_1 M + alpha_2 K_el(0), in the layout of Pattern::create_matrix,
/// rows of owned nodes. alpha_1 in 1/T0, alpha_2 in T0. It exists only where a material asks for damping. The stiffness
/// part is not objective: it damps finite rigid rotations.
class Damping {
 public:
  Damping(const Pattern& pattern, int dimension);

  double* values() { return values_.data(); }  ///< C, to be filled in
  /// y += factor C x: x local, y the rows of owned nodes.
  void multiply_add(double factor, const double* x, double* y) const;
  /// sums_r = sum over columns of |C_rc|, rows of owned nodes.
  void row_sums(double* sums) const;
  /// values += factor C.
  void add_to(double factor, double* values) const;

 private:
  const Pattern& pattern_;
  int dimension_;
  std::vector<double> values_;
};

}  // namespace ixos
