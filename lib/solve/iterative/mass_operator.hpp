/// The mass as an operator.
#pragma once
#include <Tpetra_Operator.hpp>
#include <vector>

#include "base/tpetra.hpp"
#include "model/model.hpp"

namespace ixos {

/// M on all degrees of freedom, also constrained ones, consistent or lumped; zero without inertia. No matrix is made.
/// The model must outlive it.
class MassOperator final : public Operator {
 public:
  explicit MassOperator(const Model& model);

  Teuchos::RCP<const Map> getDomainMap() const override { return model_.space().owned_map(); }
  Teuchos::RCP<const Map> getRangeMap() const override { return model_.space().owned_map(); }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;
  bool hasTransposeApply() const override { return true; }

 private:
  const Model& model_;
  mutable std::vector<double> x_, product_;  ///< scratch
};

/// S M S of the consistent mass with S = diag(M)^-1/2, constrained degrees of freedom decoupled with 1 on the diagonal.
/// Its condition number is independent of the mesh (Wathen 1987), so CG needs neither a preconditioner nor a matrix.
/// The model must outlive it.
class ScaledMass final : public Operator {
 public:
  explicit ScaledMass(const Model& model);

  /// Returns S, rows of owned nodes; 1 at constrained degrees of freedom.
  const std::vector<double>& scale() const { return scale_; }

  Teuchos::RCP<const Map> getDomainMap() const override { return model_.space().owned_map(); }
  Teuchos::RCP<const Map> getRangeMap() const override { return model_.space().owned_map(); }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;
  bool hasTransposeApply() const override { return true; }

 private:
  const Model& model_;
  std::vector<double> scale_;
  mutable std::vector<double> x_, product_;  ///< scratch
};

}  // namespace ixos
