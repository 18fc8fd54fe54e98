#include "solve/lagged_solver.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_PreconditionerFactoryHelpers.hpp>
#include <algorithm>
#include <stdexcept>

#include "base/phase_timer.hpp"

namespace ixos {
namespace {

using KrylovFactory = Thyra::LinearOpWithSolveFactoryBase<double>;
using Status = Thyra::SolveStatus<double>;

class LaggedSolve final : public Thyra::LinearOpWithSolveBase<double> {
 public:
  LaggedSolve(Teuchos::RCP<const KrylovFactory> krylov,
              Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner, double setup_cost,
              bool from_scratch, std::shared_ptr<LinearStatistics> statistics)
      : krylov_factory_(std::move(krylov)),
        factory_(std::move(preconditioner)),
        setup_cost_(setup_cost),
        from_scratch_(from_scratch),
        statistics_(std::move(statistics)),
        krylov_(krylov_factory_->createOp()),
        preconditioner_(factory_->createPrec()) {}

  void initialize(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source) {
    source_ = source;
    fresh_ = false;
    if (stale_) return renew();
    attach();
  }
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> release() { return std::exchange(source_, Teuchos::null); }

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> range() const override { return krylov_->range(); }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> domain() const override { return krylov_->domain(); }

 private:
  void renew() const {
    const TimedScope timed(Phase::Factorization);
    stale_ = true;  // should this throw
    factory_->initializePrec(source_, preconditioner_.get());
    attach();
    stale_ = false;
    fresh_ = true;
    excess_ = 0;
    ++statistics_->setups;
  }
  void attach() const {
    krylov_factory_->initializePreconditionedOp(source_, preconditioner_, krylov_.get(),
                                                Thyra::SUPPORT_SOLVE_UNSPECIFIED);
  }

  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return Thyra::opSupported(*krylov_, transpose); }
  void applyImpl(const Thyra::EOpTransp transpose, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    Thyra::apply(*krylov_, transpose, x, y, alpha, beta);
  }
  bool solveSupportsImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp, const Thyra::SolveMeasureType&) const override {
    return true;
  }

  Status solveImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& b,
                   const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                   const Teuchos::Ptr<const Thyra::SolveCriteria<double>> criteria) const override {
    const bool old = !fresh_;
    try {
      Status status = attempt(b, x, criteria);
      if (status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED || !old) return status;
    } catch (const std::exception& error) {
      if (!old) throw std::runtime_error(std::string("the linear solver broke down: ") + error.what());
    }
    if (from_scratch_) preconditioner_ = factory_->createPrec();
    renew();
    try {
      return attempt(b, x, criteria);
    } catch (const std::exception& error) {
      throw std::runtime_error(std::string("the linear solver broke down: ") + error.what());
    }
  }

  Status attempt(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                 const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    const TimedScope timed(Phase::LinearSolve);
    const bool first = fresh_;
    fresh_ = false;
    stale_ = true;  // should this throw, or not converge
    Thyra::assign(x, 0.0);
    Status status = Thyra::solve<double>(*krylov_, Thyra::NOTRANS, b, x, criteria);
    const int iterations =
        status.extraParameters.is_null() ? 0 : status.extraParameters->get<int>("Iteration Count", 0);
    statistics_->iterations += iterations;
    if (status.solveStatus != Thyra::SOLVE_STATUS_CONVERGED) return status;
    least_iterations_ = first ? iterations : std::min(least_iterations_, iterations);
    excess_ += iterations - least_iterations_;
    stale_ = excess_ > setup_cost_;
    return status;
  }

  Teuchos::RCP<const KrylovFactory> krylov_factory_;
  Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> factory_;
  double setup_cost_;
  bool from_scratch_;
  std::shared_ptr<LinearStatistics> statistics_;
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> krylov_;
  mutable Teuchos::RCP<Thyra::PreconditionerBase<double>> preconditioner_;
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source_;
  mutable bool stale_ = true;         ///< renew before the next matrix
  mutable bool fresh_ = false;        ///< renewed, and not used since
  mutable int least_iterations_ = 0;  ///< of the solves with this preconditioner
  mutable double excess_ = 0;         ///< iterations beyond the least, summed
};

}  // namespace

LaggedSolverFactory::LaggedSolverFactory(Teuchos::RCP<const KrylovFactory> krylov,
                                         Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner,
                                         double setup_cost, bool from_scratch,
                                         std::shared_ptr<LinearStatistics> statistics)
    : krylov_(std::move(krylov)),
      preconditioner_(std::move(preconditioner)),
      setup_cost_(setup_cost),
      from_scratch_(from_scratch),
      statistics_(std::move(statistics)) {}

Teuchos::RCP<LaggedSolverFactory::Op> LaggedSolverFactory::createOp() const {
  return Teuchos::rcp(new LaggedSolve(krylov_, preconditioner_, setup_cost_, from_scratch_, statistics_));
}

void LaggedSolverFactory::initializeOp(const Teuchos::RCP<const Source>& source, Op* op,
                                       const Thyra::ESupportSolveUse) const {
  dynamic_cast<LaggedSolve&>(*op).initialize(source);
}

void LaggedSolverFactory::uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                                         Teuchos::RCP<const Thyra::PreconditionerBase<double>>*,
                                         Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const {
  const auto released = dynamic_cast<LaggedSolve&>(*op).release();
  if (source != nullptr) *source = released;
}

}  // namespace ixos
