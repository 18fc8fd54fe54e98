#include "solve/lagged_solver.hpp"

#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_PreconditionerFactoryHelpers.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/agreement.hpp"
#include "base/phase_timer.hpp"
#include "solve/operator_preconditioner.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

using KrylovFactory = Thyra::LinearOpWithSolveFactoryBase<double>;
using Status = Thyra::SolveStatus<double>;

constexpr int unknown = std::numeric_limits<int>::max() / 2;  ///< more iterations than any solve takes

/// Belos' CG reports this in the message only.
bool shows_negative_curvature(const std::exception& error) {
  return std::string(error.what()).find("non-positive value for p^H*A*p") != std::string::npos;
}

int iterations(const Status& status) {
  return status.extraParameters.is_null() ? 0 : status.extraParameters->get<int>("Iteration Count", 0);
}

class LaggedSolve final : public Thyra::LinearOpWithSolveBase<double>, public KeptState {
 public:
  LaggedSolve(Teuchos::RCP<const KrylovFactory> krylov,
              Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner, const LaggedOptions& options,
              std::shared_ptr<LinearStatistics> statistics, std::shared_ptr<const int> family)
      : krylov_factory_(std::move(krylov)),
        factory_(std::move(preconditioner)),
        options_(options),
        statistics_(std::move(statistics)),
        family_(std::move(family)),
        krylov_(krylov_factory_->createOp()),
        preconditioner_(factory_->createPrec()) {}

  void initialize(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source) {
    source_ = source;
    given_ = Teuchos::null;
    fresh_ = false;
    if (loaded_) rebuild();
    loaded_ = false;
    if (stale_) return renew();
    attach();
  }
  /// Solves with a preconditioner of the caller until the next initialize().
  void initialize(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                  const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given) {
    source_ = source;
    given_ = given;
    krylov_factory_->initializePreconditionedOp(source, given, krylov_.get(), Thyra::SUPPORT_SOLVE_UNSPECIFIED);
  }
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> release() { return std::exchange(source_, Teuchos::null); }

  void transfer(Record& record) override {
    if (record.in_memory() && transfer_setup(record)) return transfer_counts(record);
    record.number("matrices", matrices_);
    record.share("first matrix", first_matrix_);
    record.share("matrix", matrix_);
    transfer_counts(record);
    if (record.loading()) {
      preconditioner_ = factory_->createPrec();  // no trace of later matrices
      if (!record.in_memory()) setup_ = ++statistics_->setups;
      loaded_ = true;
    }
    const auto inner = Teuchos::rcp_dynamic_cast<KeptState>(preconditioner_->getNonconstUnspecifiedPrecOp());
    if (nonnull(inner)) inner->transfer(record);
  }

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> range() const override { return krylov_->range(); }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> domain() const override { return krylov_->domain(); }

 private:
  auto values() const { return Teuchos::rcp_const_cast<CrsMatrix>(matrix_of(*source_))->getLocalMatrixHost().values; }

  /// Transfers the number of the set-up that the preconditioner is of. Returns whether it is that of the record: then
  /// the preconditioner is as it was.
  bool transfer_setup(Record& record) {
    if (!record.loading() && options_.of_matrix && !options_.restartable)
      throw InputError(
          "the preconditioner does not keep the matrices that it came from, so a step cannot be repeated from a saved "
          "state (Output/Checkpoint/Keep is 0, or LinearSolverFactory was made with restartable = false)");
    long setup = setup_;
    record.number("setup", setup);
    const bool same = record.loading() && setup >= 0 && setup == setup_;
    setup_ = setup;
    return same;
  }
  void transfer_counts(Record& record) {
    record.number("stale", stale_);
    transfer_least_iterations(record);
    record.number("excess", excess_);
    record.number("refused", refused_);
  }
  void transfer_least_iterations(Record& record) {
    auto families = static_cast<int>(least_iterations_.size());
    record.number("families", families);
    if (families < 0 || families > 1000) throw InputError("the number of families is not between 0 and 1000");
    least_iterations_.resize(static_cast<std::size_t>(families), unknown);
    for (int i = 0; i < families; ++i) {
      int& least = least_iterations_[static_cast<std::size_t>(i)];
      record.number(("least iterations " + std::to_string(i + 1)).c_str(), least);
      if (least < 0) throw InputError("a number of iterations is negative");
    }
  }
  /// Returns the least iterations of the present family with this preconditioner.
  int& least_iterations() const {
    const auto family = static_cast<std::size_t>(*family_);
    if (family >= least_iterations_.size()) least_iterations_.resize(family + 1, unknown);
    return least_iterations_[family];
  }

  /// Makes the preconditioner from the matrix's present values.
  void make() const { initialize_preconditioner(*factory_, options_.of_matrix, source_, *preconditioner_); }
  void renew() const {
    const TimedScope timed(Phase::Factorization);
    stale_ = true;  // should this throw
    setup_ = -1;
    make();
    if (options_.restartable && options_.of_matrix) note_matrix();
    attach();
    stale_ = false;
    fresh_ = true;
    excess_ = 0;
    setup_ = ++statistics_->setups;
  }
  /// A renewed multigrid keeps prolongators of its first matrix.
  void note_matrix() const {
    const auto present = values();
    if (options_.from_scratch && matrices_ == 1) first_matrix_ = std::move(matrix_);
    matrix_.assign(present.data(), present.data() + present.extent(0));
    matrices_ = options_.from_scratch ? std::min(matrices_ + 1, 2) : 1;
  }
  /// Some parts are made at the first use only (MueLu's coarsest level), from the values that the matrix has then.
  void force() const {
    const auto op = preconditioner_->getUnspecifiedPrecOp();
    if (op.is_null()) return;
    const auto x = Thyra::createMembers(op->domain(), 1);
    const auto y = Thyra::createMembers(op->range(), 1);
    Thyra::assign(x.ptr(), 0.0);
    Thyra::apply(*op, Thyra::NOTRANS, *x, y.ptr());
  }
  /// Makes the preconditioner as it was when the checkpoint was written.
  void rebuild() const {
    const TimedScope timed(Phase::Factorization);
    if (!options_.of_matrix) return make();
    const auto here = values();
    const std::vector<double> present(here.data(), here.data() + here.extent(0));
    const auto make_from = [&](const std::vector<double>& earlier) {
      together<InputError>(matrix_of(*source_)->getComm(), [&] {
        if (earlier.size() != present.size()) throw InputError("a matrix of the checkpoint has a different size");
      });
      std::copy(earlier.begin(), earlier.end(), here.data());
      make();
      force();
    };
    // They could be made once, so they can be made again. If the last one is stale, only the traces of the first one
    // count.
    if (matrices_ > 1) make_from(first_matrix_);
    if (matrices_ == 1 || (matrices_ > 1 && !stale_)) make_from(matrix_);
    // A multigrid's finest level is the matrix itself. If only preconditioners have a matrix, it resumes with the
    // values from which they were made, as in an uninterrupted run.
    const auto assemblable =
        Teuchos::rcp_dynamic_cast<const AssemblableOperator>(Extract::getConstTpetraOperator(source_->getOp()));
    if (nonnull(assemblable))
      assemblable->forget_values();
    else
      std::copy(present.begin(), present.end(), here.data());
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
    if (nonnull(given_)) return counted(b, x, criteria);
    const bool old = !fresh_;
    try {
      Status status = attempt(b, x, criteria);
      if (status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED || !old) return status;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      const bool indefinite = shows_negative_curvature(error);
      // A new preconditioner would not change the matrix. If the old one is to blame, it is discarded at the second
      // failure.
      if (old && indefinite && !refused_) {
        refused_ = true;
        stale_ = false;
        throw std::runtime_error("the matrix of the linear system is not positive definite");
      }
      if (!old) throw std::runtime_error(std::string("the linear solver broke down: ") + error.what());
    }
    if (options_.from_scratch) {
      preconditioner_ = factory_->createPrec();
      matrices_ = 0;
      first_matrix_.clear();
    }
    renew();
    try {
      return attempt(b, x, criteria);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      throw std::runtime_error(std::string("the linear solver broke down: ") + error.what());
    }
  }

  /// Solves, and counts the iterations.
  Status counted(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                 const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    const TimedScope timed(Phase::LinearSolve);
    Thyra::assign(x, 0.0);
    Status status = Thyra::solve<double>(*krylov_, Thyra::NOTRANS, b, x, criteria);
    statistics_->iterations += iterations(status);
    return status;
  }

  Status attempt(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                 const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    const bool first = fresh_;
    fresh_ = false;
    stale_ = true;  // should this throw, or not converge
    Status status = counted(b, x, criteria);
    if (status.solveStatus != Thyra::SOLVE_STATUS_CONVERGED) return status;
    refused_ = false;
    if (first) least_iterations_.clear();
    int& least = least_iterations();
    least = std::min(least, iterations(status));
    excess_ += iterations(status) - least;
    stale_ = excess_ > options_.setup_cost;
    return status;
  }

  Teuchos::RCP<const KrylovFactory> krylov_factory_;
  Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> factory_;
  LaggedOptions options_;
  std::shared_ptr<LinearStatistics> statistics_;
  std::shared_ptr<const int> family_;  ///< of the present matrix
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> krylov_;
  mutable Teuchos::RCP<Thyra::PreconditionerBase<double>> preconditioner_;
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source_;
  /// The caller's preconditioner, or null.
  Teuchos::RCP<const Thyra::PreconditionerBase<double>> given_;

  mutable bool stale_ = true;                          ///< renew before the next matrix
  mutable bool fresh_ = false;                         ///< renewed, and not used since
  mutable std::vector<int> least_iterations_;          ///< of the solves with this preconditioner, by family
  mutable double excess_ = 0;                          ///< iterations beyond the least, summed
  mutable bool refused_ = false;                       ///< the last matrix was found not positive definite
  mutable bool loaded_ = false;                        ///< from a checkpoint: the preconditioner is yet to be made
  mutable long setup_ = 0;                             ///< its number in the factory; 0: none yet, -1: it failed
  mutable int matrices_ = 0;                           ///< kept: none, the last one, or the first and the last one
  mutable std::vector<double> first_matrix_, matrix_;  ///< values
};

}  // namespace

LaggedSolverFactory::LaggedSolverFactory(Teuchos::RCP<const KrylovFactory> krylov,
                                         Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner,
                                         const LaggedOptions& options, std::shared_ptr<LinearStatistics> statistics)
    : krylov_(std::move(krylov)),
      preconditioner_(std::move(preconditioner)),
      options_(options),
      statistics_(std::move(statistics)) {}

Teuchos::RCP<LaggedSolverFactory::Op> LaggedSolverFactory::createOp() const {
  return keep(Teuchos::rcp(new LaggedSolve(krylov_, preconditioner_, options_, statistics_, family())));
}

void LaggedSolverFactory::initializeOp(const Teuchos::RCP<const Source>& source, Op* op,
                                       const Thyra::ESupportSolveUse) const {
  dynamic_cast<LaggedSolve&>(*op).initialize(source);
}

bool LaggedSolverFactory::supportsPreconditionerInputType(const Thyra::EPreconditionerInputType type) const {
  return krylov_->supportsPreconditionerInputType(type);
}

void LaggedSolverFactory::initializePreconditionedOp(const Teuchos::RCP<const Source>& source,
                                                     const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given,
                                                     Op* op, const Thyra::ESupportSolveUse) const {
  dynamic_cast<LaggedSolve&>(*op).initialize(source, given);
}

void LaggedSolverFactory::uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                                         Teuchos::RCP<const Thyra::PreconditionerBase<double>>*,
                                         Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const {
  const auto released = dynamic_cast<LaggedSolve&>(*op).release();
  if (source != nullptr) *source = released;
}

}  // namespace ixos
