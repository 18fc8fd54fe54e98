#include "solve/bordered/bordered_solver.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Vector.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/dense_solve.hpp"
#include "solve/bordered/bordered_operator.hpp"

namespace ixos {
namespace {

using Criteria = Teuchos::Ptr<const Thyra::SolveCriteria<double>>;

Teuchos::RCP<const BorderedOperator> bordered(const Thyra::LinearOpSourceBase<double>& source) {
  return Teuchos::rcp_dynamic_cast<const BorderedOperator>(Extract::getConstTpetraOperator(source.getOp()));
}

class BorderedSolve final : public Thyra::LinearOpWithSolveBase<double> {
 public:
  explicit BorderedSolve(Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> nodal) : nodal_(std::move(nodal)) {}

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
    }
    solved_columns_.clear();
    factory.initializeOp(nodal_source_, nodal_.get(), support);
  }
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> release() { return std::exchange(source_, Teuchos::null); }
  const Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>>& nodal() const { return nodal_; }

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

  /// Sets x = K^-1 b. Returns the solver's status.
  Thyra::SolveStatus<double> solve_nodal(const Teuchos::RCP<const Vector>& b, const Teuchos::RCP<Vector>& x,
                                         const Criteria& criteria) const {
    const auto from = Thyra::createConstVector<double, LocalId, GlobalId, Node>(b, space_);
    const auto to = Thyra::createVector<double, LocalId, GlobalId, Node>(x, space_);
    Thyra::assign(to.ptr(), 0.0);
    return Thyra::solve<double>(*nodal_, Thyra::NOTRANS, *from, to.ptr(), criteria);
  }

  /// Solves for the columns, and makes the small matrix block - rows^T K^-1 columns. Returns false if a solve fails.
  bool solve_columns(const Criteria& criteria) const {
    if (!solved_columns_.empty()) return true;
    const std::size_t count = border_->size();
    std::vector<Teuchos::RCP<Vector>> solved(count);
    small_ = border_->block();
    for (std::size_t k = 0; k < count; ++k) {
      if (!border_->has_column(k)) continue;
      solved[k] = Teuchos::rcp(new Vector(border_->nodal()->getDomainMap()));
      if (solve_nodal(border_->column(k), solved[k], criteria).solveStatus == Thyra::SOLVE_STATUS_UNCONVERGED)
        return false;
      const std::vector<double> product = border_->rows_times(*solved[k]);
      for (std::size_t i = 0; i < count; ++i) small_[i * count + k] -= product[i];
    }
    solved_columns_ = std::move(solved);
    return true;
  }

  Thyra::SolveStatus<double> solveImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& b,
                                       const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                                       const Criteria criteria) const override {
    const auto from = Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(b));
    const auto to = Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(x));
    Thyra::SolveStatus<double> status;
    status.solveStatus = Thyra::SOLVE_STATUS_UNCONVERGED;
    for (std::size_t column = 0; column < from->getNumVectors(); ++column) {
      const Teuchos::RCP<const Vector> rhs = from->getVector(column);
      const Teuchos::RCP<Vector> solution = to->getVectorNonConst(column);
      const Teuchos::RCP<Vector> nodes = border_->nodes_of(*solution);
      status = solve_nodal(border_->nodes_of(*rhs), nodes, criteria);
      if (status.solveStatus == Thyra::SOLVE_STATUS_UNCONVERGED || !solve_columns(criteria)) {
        status.solveStatus = Thyra::SOLVE_STATUS_UNCONVERGED;
        return status;
      }
      std::vector<double> globals = border_->globals_of(*rhs);
      const std::vector<double> known = border_->rows_times(*nodes);
      for (std::size_t k = 0; k < globals.size(); ++k) globals[k] -= known[k];
      globals = dense_solve(small_, globals);
      if (globals.empty())
        throw std::runtime_error("nothing resists some motion of a rigid body: hold it, or add springs");
      for (std::size_t k = 0; k < globals.size(); ++k)
        if (nonnull(solved_columns_[k])) nodes->update(-globals[k], *solved_columns_[k], 1.0);
      border_->set_globals(globals, *solution);
    }
    return status;
  }

  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> nodal_;
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source_, nodal_source_;
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op_;
  Teuchos::RCP<const BorderedOperator> border_;
  VectorSpace space_;
  mutable std::vector<Teuchos::RCP<Vector>> solved_columns_;  ///< null where the column is 0; empty: not solved yet
  mutable std::vector<double> small_;                         ///< row by row
};

}  // namespace

bool BorderedSolverFactory::isCompatible(const Source& source) const { return !bordered(source).is_null(); }

Teuchos::RCP<BorderedSolverFactory::Op> BorderedSolverFactory::createOp() const {
  return Teuchos::rcp(new BorderedSolve(nodal_->createOp()));
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
