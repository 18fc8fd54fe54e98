#include "solve/direct/direct_solver.hpp"

#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "base/phase_timer.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

class DirectSolve final : public Thyra::LinearOpWithSolveBase<double>, public KeptState {
 public:
  VectorSpace range() const override { return op->range(); }
  VectorSpace domain() const override { return op->domain(); }
  void transfer(Record& record) override { factorization.transfer(record); }
  bool correction(const Thyra::VectorBase<double>& residual, Thyra::VectorBase<double>& step) const override {
    solveImpl(Thyra::NOTRANS, residual, Teuchos::ptrFromRef(step), Teuchos::null);
    return true;
  }

  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source;
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op;
  KeptFactorization factorization;

 private:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return op->opSupported(transpose); }
  void applyImpl(const Thyra::EOpTransp transpose, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    Thyra::apply(*op, transpose, x, y, alpha, beta);
  }
  bool solveSupportsImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp, const Thyra::SolveMeasureType&) const override {
    return true;
  }
  Thyra::SolveStatus<double> solveImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& b,
                                       const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                                       const Teuchos::Ptr<const Thyra::SolveCriteria<double>>) const override {
    const TimedScope timed(Phase::LinearSolve);
    factorization.solve(*Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(b)),
                        *Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(x)));
    Thyra::SolveStatus<double> status;
    status.solveStatus = Thyra::SOLVE_STATUS_CONVERGED;
    status.achievedTol = Thyra::SolveStatus<double>::unknownTolerance();
    return status;
  }
};

}  // namespace

bool DirectSolverFactory::isCompatible(const Source& source) const { return !matrix_of(source).is_null(); }

Teuchos::RCP<DirectSolverFactory::Op> DirectSolverFactory::createOp() const {
  return keep(Teuchos::rcp(new DirectSolve));
}

void DirectSolverFactory::initializeOp(const Teuchos::RCP<const Source>& source, Op* op,
                                       const Thyra::ESupportSolveUse) const {
  const TimedScope timed(Phase::Factorization);
  auto& direct = dynamic_cast<DirectSolve&>(*op);
  direct.source = source;
  direct.op = source->getOp();
  renew(matrix_of(*source), direct.factorization);
}

void DirectSolverFactory::uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                                         Teuchos::RCP<const Thyra::PreconditionerBase<double>>*,
                                         Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const {
  auto& direct = dynamic_cast<DirectSolve&>(*op);
  if (source != nullptr) *source = direct.source;
  direct.source = Teuchos::null;
}

}  // namespace ixos
