#include "solve/bordered/bordered_solver.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/dense_solve.hpp"
#include "solve/bordered/bordered_operator.hpp"
#include "solve/direct/direct_solver.hpp"

namespace ixos {
namespace {

using Status = Thyra::SolveStatus<double>;
using Criteria = Teuchos::Ptr<const Thyra::SolveCriteria<double>>;

Teuchos::RCP<const BorderedOperator> bordered(const Thyra::LinearOpSourceBase<double>& source) {
  return Teuchos::rcp_dynamic_cast<const BorderedOperator>(Extract::getConstTpetraOperator(source.getOp()));
}

class BorderedSolve final : public Thyra::LinearOpWithSolveBase<double> {
 public:
  /// `at_once`: the nodal solver takes the right-hand side with the columns, and does not fail.
  BorderedSolve(Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> nodal, bool at_once)
      : nodal_(std::move(nodal)), at_once_(at_once) {}

  VectorSpace range() const override { return op_->range(); }
  VectorSpace domain() const override { return op_->domain(); }

  /// Takes a tangent, whose nodal part the nodal solver gets from `factory`.
  void take(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
            const Thyra::LinearOpWithSolveFactoryBase<double>& factory, Thyra::ESupportSolveUse support) {
    source_ = source;
    op_ = source->getOp();
    const Teuchos::RCP<const BorderedOperator> given = bordered(*source);
    if (given != border_) {
      border_ = given;
      space_ = vector_space(border_->nodal()->getRangeMap());
      nodal_source_ = Thyra::defaultLinearOpSource<double>(linear_op(border_->nodal(), space_));
      solved_ = Teuchos::rcp(new MultiVector(*border_->columns(), Teuchos::Copy));
      all_ = {wrapped(border_->columns()), wrapped(solved_)};
      const auto last = [this](MultiVector& x) { return wrapped(x.getVectorNonConst(border_->size())); };
      const auto others = [this](MultiVector& x) {
        return wrapped(x.subViewNonConst(Teuchos::Range1D(0, static_cast<Teuchos::Ordinal>(border_->size()) - 1)));
      };
      if (border_->size() > 0) columns_ = {others(*border_->columns()), others(*solved_)};
      rhs_ = {last(*border_->columns()), last(*solved_)};
    }
    columns_are_solved_ = false;
    factory.initializeOp(nodal_source_, nodal_.get(), support);
  }
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> release() { return std::exchange(source_, Teuchos::null); }

 private:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  void applyImpl(const Thyra::EOpTransp transpose, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    Thyra::apply(*op_, transpose, x, y, alpha, beta);
  }
  bool solveSupportsImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp, const Thyra::SolveMeasureType&) const override {
    return true;
  }

  /// Right-hand sides, and K^-1 times them.
  struct System {
    Teuchos::RCP<Thyra::MultiVectorBase<double>> given, solution;
  };
  Teuchos::RCP<Thyra::MultiVectorBase<double>> wrapped(const Teuchos::RCP<MultiVector>& x) const {
    return Thyra::createMultiVector<double, LocalId, GlobalId, Node>(x, space_);
  }

  Status solve_nodal(const System& system, const Criteria& criteria) const {
    Thyra::assign(system.solution.ptr(), 0.0);
    return Thyra::solve<double>(*nodal_, Thyra::NOTRANS, *system.given, system.solution.ptr(), criteria);
  }

  /// Solves for the right-hand side, and for the columns if that has not been done. Returns the status of the one, or
  /// of a solve that does not converge.
  Status solve_systems(const Criteria& criteria) const {
    if (!columns_are_solved_ && border_->has_columns() && at_once_) return solve_nodal(all_, criteria);
    Status status = solve_nodal(rhs_, criteria);
    if (columns_are_solved_ || columns_.given.is_null()) return status;
    if (!border_->has_columns()) {
      Thyra::assign(columns_.solution.ptr(), 0.0);
    } else if (solve_nodal(columns_, criteria).solveStatus == Thyra::SOLVE_STATUS_UNCONVERGED) {
      status.solveStatus = Thyra::SOLVE_STATUS_UNCONVERGED;
    }
    return status;
  }

  Status solveImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& b,
                   const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x, const Criteria criteria) const override {
    const auto from = Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(b));
    const auto to = Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(x));
    Status status;
    for (std::size_t column = 0; column < from->getNumVectors(); ++column) {
      status = solve(*from->getVector(column), *to->getVectorNonConst(column), criteria);
      if (status.solveStatus == Thyra::SOLVE_STATUS_UNCONVERGED) break;
    }
    return status;
  }

  Status solve(const Vector& b, Vector& x, const Criteria& criteria) const {
    const std::size_t count = border_->size();
    const auto nodes = static_cast<std::size_t>(solved_->getLocalLength());
    if (nodes > 0) {
      const auto rhs = b.getLocalViewHost(Tpetra::Access::ReadOnly);
      const auto room = border_->columns()->getLocalViewHost(Tpetra::Access::ReadWrite);
      std::copy_n(rhs.data(), nodes, &room(0, count));
    }
    // Newton's method may use a solution that has not converged.
    Status status = solve_systems(criteria);
    const bool converged = status.solveStatus != Thyra::SOLVE_STATUS_UNCONVERGED;
    // The small matrix block - rows^T K^-1 columns, and rows^T K^-1 b.
    const std::vector<double> products = border_->rows_times(*solved_);
    small_ = border_->block();
    std::vector<double> globals = border_->globals_of(b);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < count; ++k) small_[i * count + k] -= products[i * (count + 1) + k];
      globals[i] -= products[i * (count + 1) + count];
    }
    columns_are_solved_ = columns_are_solved_ || converged;
    for (const std::vector<double>* const numbers : {&small_, &globals})
      if (!std::all_of(numbers->begin(), numbers->end(), [](double value) { return std::isfinite(value); }))
        throw std::runtime_error("a number of the iteration is not finite");
    globals = dense_solve(small_, globals);
    if (globals.size() != count && !converged) return status;
    if (globals.size() != count)
      throw std::runtime_error("nothing resists some motion of a rigid body: hold it, or add springs");
    if (nodes > 0) {
      const auto solved = solved_->getLocalViewHost(Tpetra::Access::ReadOnly);
      const auto result = x.getLocalViewHost(Tpetra::Access::ReadWrite);
      std::copy_n(&solved(0, count), nodes, result.data());
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < nodes; ++i) result(i, 0) -= globals[k] * solved(i, k);
    }
    border_->set_globals(globals, x);
    return status;
  }

  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> nodal_;
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source_, nodal_source_;
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op_;
  Teuchos::RCP<const BorderedOperator> border_;
  VectorSpace space_;
  bool at_once_;
  Teuchos::RCP<MultiVector> solved_;
  System all_, columns_, rhs_;  ///< the columns and the right-hand side behind them, and both for themselves
  mutable bool columns_are_solved_ = false;
  mutable std::vector<double> small_;  ///< row by row
};

}  // namespace

bool BorderedSolverFactory::isCompatible(const Source& source) const { return !bordered(source).is_null(); }

Teuchos::RCP<BorderedSolverFactory::Op> BorderedSolverFactory::createOp() const {
  const bool direct = nonnull(Teuchos::rcp_dynamic_cast<const DirectSolverFactory>(nodal_));
  return Teuchos::rcp(new BorderedSolve(nodal_->createOp(), direct));
}

void BorderedSolverFactory::initializeOp(const Teuchos::RCP<const Source>& source, Op* op,
                                         Thyra::ESupportSolveUse support) const {
  dynamic_cast<BorderedSolve&>(*op).take(source, *nodal_, support);
}

void BorderedSolverFactory::uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                                           Teuchos::RCP<const Thyra::PreconditionerBase<double>>*,
                                           Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const {
  const Teuchos::RCP<const Source> kept = dynamic_cast<BorderedSolve&>(*op).release();
  if (source != nullptr) *source = kept;
}

}  // namespace ixos
