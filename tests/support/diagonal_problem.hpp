/// Nonlinear problems whose solutions have closed forms.
#pragma once
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>

#include "solve/newton/nonlinear_problem.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {

/// One equation for each of seven unknowns, which are spread over the ranks. |f| must come below the tolerance itself.
class DiagonalProblem : public NonlinearProblem {
 public:
  static constexpr int unknowns = 7;

  Teuchos::RCP<const Map> map() const override { return map_; }
  Teuchos::RCP<Operator> create_operator() override {
    const auto matrix = Teuchos::rcp(new CrsMatrix(map_, 1));
    for (GlobalId id = 0; id < unknowns; ++id)
      if (map_->isNodeGlobalElement(id))
        matrix->insertGlobalValues(id, Teuchos::tuple<GlobalId>(id), Teuchos::tuple<double>(1.0));
    matrix->fillComplete();
    return matrix;
  }
  bool residual(const Vector& x, Vector& f) override {
    int inadmissible = 0, anywhere = 0;
    {
      const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
      const auto to = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < to.extent(0); ++i) {
        to(i, 0) = value(id(i), from(i, 0));
        if (std::isnan(to(i, 0))) inadmissible = 1;
      }
    }
    Teuchos::reduceAll(*world(), Teuchos::REDUCE_MAX, 1, &inadmissible, &anywhere);
    return anywhere == 0;
  }
  void tangent(const Vector& x, Operator& w) override {
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto values = dynamic_cast<CrsMatrix&>(w).getLocalMatrixHost().values;
    for (std::size_t i = 0; i < values.extent(0); ++i) values(i) = slope(id(i), from(i, 0));
  }
  double admissible_step(const Vector&, const Vector&) override { return 1; }
  double convergence_bound(double tolerance) const override { return tolerance; }

  /// Returns the global number of this rank's i-th unknown.
  double id(std::size_t i) const { return static_cast<double>(map_->getGlobalElement(static_cast<LocalId>(i))); }

 private:
  /// Returns the left-hand side of the equation of unknown `id` at x; NaN if x is inadmissible.
  virtual double value(double id, double x) const = 0;
  /// Returns its derivative.
  virtual double slope(double id, double x) const = 0;

  Teuchos::RCP<const Map> map_ = Teuchos::rcp(new Map(Tpetra::global_size_t{unknowns}, 0, world()));
};

}  // namespace ixos::test
