/// The tangent of a stage, applied matrix-free.
#pragma once
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "balance/balance.hpp"
#include "solve/assemblable_operator.hpp"
#include "solve/coarsenable_operator.hpp"

namespace ixos {

/// y = W x from the data that the terms keep at their quadrature points, consistent mass and damping included. The
/// model must outlive it.
class TangentOperator : public AssemblableOperator, public CoarsenableOperator {
 public:
  /// `assemble` fills matrix values (Pattern::create_matrix's layout, zero before) with the tangent at the last
  /// linearize(), constraints included. Throws InputError if a term cannot be applied matrix-free.
  TangentOperator(const Model& model, std::function<void(double*)> assemble);

  /// Takes the tangent at the point: mass M + damping C + K_el + K_c + shift I, and `constrained` times the identity
  /// for constrained degrees of freedom, which nothing couples to others. If matrix() is to be called, the point's
  /// arrays must stay until the next linearize().
  void linearize(const BalancePoint& at, const TangentWeights& weights, Tangent kind, double constrained);
  /// Sets result_f = K_fp x_p of constrained columns p and free rows f, 0 for constrained ones: x local, result the
  /// rows of owned nodes.
  void multiply_constrained_columns(const double* x, double* result) const;

  Teuchos::RCP<const Map> getDomainMap() const override { return model_.space().owned_map(); }
  Teuchos::RCP<const Map> getRangeMap() const override { return model_.space().owned_map(); }
  /// Sets y = alpha W x + beta y. W is symmetric.
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;
  bool hasTransposeApply() const override { return true; }
  Precision set_precision(Precision precision) const override { return std::exchange(precision_, precision); }
  Teuchos::RCP<CrsMatrix> matrix() const override;
  void diagonal(Vector& result) const override;
  void forget_values() const override { assembled_ = false; }
  const CoarseSpace& coarse_space() const override;
  /// A consistent mass that the elastic actions do not apply, because their quadrature is not its own, enters lumped.
  Teuchos::RCP<CrsMatrix> coarse_matrix() const override;

 private:
  /// Sets result_ = W x with free and constrained degrees of freedom coupled, x local.
  void multiply(const double* x) const;
  void add_mass(const double* x) const;

  const Model& model_;
  std::function<void(double*)> assemble_;
  std::vector<std::unique_ptr<TangentAction>> elastic_, interactions_;
  bool mass_in_elastic_;  ///< the elastic actions apply it
  double mass_ = 0, damping_ = 0, shift_ = 0, constrained_diagonal_ = 1;
  std::vector<double> rates_;                      ///< see TermSums::rate_diagonal
  mutable std::vector<double> x_, result_, part_;  ///< scratch, local
  mutable Teuchos::RCP<CrsMatrix> matrix_;
  mutable bool assembled_ = false;
  mutable Precision precision_ = Precision::Double;
  mutable std::unique_ptr<CoarseSpace> coarse_space_;  ///< made at the first use
};

}  // namespace ixos
