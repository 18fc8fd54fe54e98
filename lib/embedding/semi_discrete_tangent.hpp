/// The derivatives of the semi-discrete model: mass, damping and stiffness.
#pragma once
#include <vector>

#include "balance/tangent_operator.hpp"

namespace ixos {

/// Sets a matrix of the model's sparsity to W in a state with its velocity, in all rows and columns, also those of
/// constrained degrees of freedom. Throws std::logic_error if the matrix is of another version of the discretization.
void set_semi_discrete_tangent(const Model& model, const TangentWeights& weights, const Place& at, CrsMatrix& matrix);

/// W applied without a matrix, constrained degrees of freedom eliminated. It keeps the displacement at which it was
/// taken, from which it assembles a matrix if somebody asks for one.
class SemiDiscreteOperator final : public TangentOperator {
 public:
  /// Throws InputError if a term cannot be applied matrix-free.
  explicit SemiDiscreteOperator(const Model& model);

  /// Takes W in a state.
  void linearize(const TangentWeights& weights, const Place& at);
  /// Makes every product NaN, until the next linearize().
  void invalidate();

 private:
  BalancePoint point() const;

  TangentWeights weights_;
  std::vector<double> u_;
  double time_ = 0;
  TermHistories histories_;
  Rule rule_;
};

}  // namespace ixos
