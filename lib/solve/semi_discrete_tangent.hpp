/// The derivatives of the semi-discrete model: mass, damping and stiffness.
#pragma once
#include <vector>

#include "solve/tangent_operator.hpp"

namespace ixos {

/// The factors of W = mass M + damping C + stiffness K: the derivatives of the balance by acceleration, velocity and
/// displacement.
struct TangentWeights {
  double mass = 0;
  double damping = 0;
  double stiffness = 0;

  /// Returns the factor of constrained degrees of freedom, whose equation is x - u_bar(t) = 0. If W has no stiffness it
  /// is the factor of M: then the equation is the one for accelerations.
  double constrained() const { return stiffness != 0 ? stiffness : mass; }
};

/// Adds W at the displacement u and velocity v, local arrays, and a time [T0], to matrix values in the layout of
/// Pattern::create_matrix: all rows and columns, also those of constrained degrees of freedom.
void add_semi_discrete_tangent(const Model& model, const TangentWeights& weights, const std::vector<double>& u,
                               const std::vector<double>& v, double time, double* values);

/// Sets a matrix of the model's sparsity to it. Throws std::logic_error if the matrix is of another version of the
/// discretization.
void set_semi_discrete_tangent(const Model& model, const TangentWeights& weights, const std::vector<double>& u,
                               const std::vector<double>& v, double time, CrsMatrix& matrix);

/// W applied without a matrix, constrained degrees of freedom eliminated. It keeps the displacement at which it was
/// taken, from which it assembles a matrix if somebody asks for one.
class SemiDiscreteOperator final : public TangentOperator {
 public:
  /// Throws InputError if a term cannot be applied matrix-free.
  explicit SemiDiscreteOperator(const Model& model);

  /// Takes W at the displacement u, a local array, and a time.
  void linearize(const TangentWeights& weights, const std::vector<double>& u, double time);
  /// Makes every product NaN, until the next linearize().
  void invalidate();

 private:
  TangentPoint point() const;

  TangentWeights weights_;
  std::vector<double> u_;
  double time_ = 0;
  Rule rule_;
};

}  // namespace ixos
