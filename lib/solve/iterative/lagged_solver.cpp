#include "solve/iterative/lagged_solver.hpp"

#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/phase_timer.hpp"
#include "solve/direct/direct_preconditioner.hpp"
#include "solve/direct/first_rank_factorization.hpp"
#include "solve/iterative/collected_cg.hpp"
#include "solve/iterative/kept_preconditioner.hpp"
#include "solve/iterative/sparing_preconditioner.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

using KrylovFactory = Thyra::LinearOpWithSolveFactoryBase<double>;
using Status = Thyra::SolveStatus<double>;

constexpr int unknown = std::numeric_limits<int>::max() / 2;  ///< more iterations than any solve takes

/// CG found that the matrix is not positive definite.
class NegativeCurvature : public std::runtime_error {
 public:
  NegativeCurvature() : std::runtime_error("the matrix of the linear system is not positive definite") {}
};

[[noreturn]] void throw_not_finite() { throw std::runtime_error("a number of the iteration is not finite"); }

/// Returns the tolerance of a solve whose criteria are the residual's norm relative to that of the right-hand side, or
/// of the first residual, which is the same from x = 0; else 0.
double relative_tolerance(const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) {
  if (criteria.is_null() || criteria->requestedTol == Thyra::SolveCriteria<double>::unspecifiedTolerance()) return 0;
  const auto& measure = criteria->solveMeasureType;
  const bool relative = measure.numerator == Thyra::SOLVE_MEASURE_NORM_RESIDUAL &&
                        (measure.denominator == Thyra::SOLVE_MEASURE_NORM_RHS ||
                         measure.denominator == Thyra::SOLVE_MEASURE_NORM_INIT_RESIDUAL);
  return relative ? criteria->requestedTol : 0;
}

int iterations(const Status& status) {
  return status.extraParameters.is_null() ? 0 : status.extraParameters->get<int>("Iteration Count", 0);
}

/// Returns the 2-norms of the columns.
std::vector<double> column_norms(const Thyra::MultiVectorBase<double>& vectors) {
  std::vector<double> result(static_cast<std::size_t>(vectors.domain()->dim()));
  Thyra::norms_2(vectors, Teuchos::arrayViewFromVector(result));
  return result;
}
double largest_norm(const Thyra::MultiVectorBase<double>& vectors) {
  const std::vector<double> all = column_norms(vectors);
  return *std::max_element(all.begin(), all.end());
}
bool is_finite(const Thyra::MultiVectorBase<double>& vectors) {
  const std::vector<double> all = column_norms(vectors);
  return std::all_of(all.begin(), all.end(), [](double norm) { return std::isfinite(norm); });
}

class LaggedSolve final : public Thyra::LinearOpWithSolveBase<double>, public KeptState {
 public:
  LaggedSolve(Teuchos::RCP<const KrylovFactory> krylov,
              Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner, const LaggedOptions& options,
              std::shared_ptr<LinearStatistics> statistics, std::shared_ptr<const int> family)
      : krylov_factory_(std::move(krylov)),
        options_(options),
        statistics_(std::move(statistics)),
        family_(std::move(family)),
        krylov_(krylov_factory_->createOp()),
        preconditioner_(std::move(preconditioner), options, statistics_) {}

  void initialize(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source) {
    source_ = source;
    given_ = Teuchos::null;
    collected_ = false;
    fresh_ = false;
    preconditioner_.rebuild(source_, stale_);
    if (stale_) return renew();
    attach(preconditioner_.get());
  }
  /// Solves with a preconditioner of the caller until the next initialize().
  void initialize(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                  const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given) {
    source_ = source;
    given_ = given;
    attach(given);
  }
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> release() { return std::exchange(source_, Teuchos::null); }

  void transfer(Record& record) override {
    record.number("stale", stale_);
    transfer_least_iterations(record);
    record.number("excess", excess_);
    record.number("refused", refused_);
    preconditioner_.transfer(record);
  }

  bool correction(const Thyra::VectorBase<double>& residual, Thyra::VectorBase<double>& step) const override;

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> range() const override { return krylov_->range(); }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> domain() const override { return krylov_->domain(); }

 private:
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

  void renew() const {
    const TimedScope timed(Phase::Factorization);
    stale_ = true;       // should this throw
    collected_ = false;  // a new factorisation may have a new copy
    preconditioner_.renew(source_);
    attach(preconditioner_.get());
    stale_ = false;
    fresh_ = true;
    excess_ = 0;
  }
  void attach(const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& preconditioner) const {
    krylov_factory_->initializePreconditionedOp(
        source_, options_.spares_last ? sparing_preconditioner(preconditioner, converged_) : preconditioner,
        krylov_.get(), Thyra::SUPPORT_SOLVE_UNSPECIFIED);
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
    return b.domain()->dim() > 1 ? solve_columns(b, x, criteria) : solve_system(b, x, criteria);
  }

  /// Solves for several right-hand sides: rounds with the factorisation take all at once, which passes over the factors
  /// once; the rest is done one by one. The length of a column's step is that of the method of steepest descent.
  Status solve_columns(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                       const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    constexpr int rounds = 3;
    const double tolerance = relative_tolerance(criteria);
    const auto count = static_cast<std::size_t>(b.domain()->dim());
    const std::vector<double> scales = column_norms(b);
    std::vector<double> norms = scales;
    const auto residual = b.clone_mv(), step = b.clone_mv(), product = b.clone_mv();
    Thyra::assign(x, 0.0);
    const auto reached = [&](std::size_t k) { return norms[k] <= tolerance * scales[k]; };
    for (int round = 0; round < rounds && options_.factorizes && given_.is_null() && tolerance > 0; ++round) {
      const TimedScope timed(Phase::LinearSolve);
      Thyra::apply(*preconditioner_.get()->getUnspecifiedPrecOp(), Thyra::NOTRANS, *residual, step.ptr());
      Thyra::apply(*krylov_, Thyra::NOTRANS, *step, product.ptr());
      ++statistics_->iterations;
      std::vector<double> slopes(count), curvatures(count);
      Thyra::dots(*residual, *step, Teuchos::arrayViewFromVector(slopes));
      Thyra::dots(*product, *step, Teuchos::arrayViewFromVector(curvatures));
      bool all = true, falls = true;
      const std::vector<double> last = norms;
      for (std::size_t k = 0; k < count; ++k) {
        const auto column = static_cast<Thyra::Ordinal>(k);
        if (reached(k) || !(slopes[k] > 0 && curvatures[k] > 0)) continue;
        Thyra::Vp_StV(x->col(column).ptr(), slopes[k] / curvatures[k], *step->col(column));
        Thyra::Vp_StV(residual->col(column).ptr(), -slopes[k] / curvatures[k], *product->col(column));
        norms[k] = Thyra::norm_2(*residual->col(column));
        all = all && reached(k);
        falls = falls && norms[k] < 0.25 * last[k];
      }
      if (all || !falls) break;
    }
    Status status;
    status.solveStatus = Thyra::SOLVE_STATUS_CONVERGED;
    for (std::size_t k = 0; k < count; ++k) {
      if (tolerance > 0 ? reached(k) : norms[k] == 0) continue;
      Thyra::SolveCriteria<double> own = nonnull(criteria) ? *criteria : Thyra::SolveCriteria<double>();
      if (tolerance > 0) own.requestedTol = std::min(tolerance * scales[k] / norms[k], 0.9);
      const auto column = static_cast<Thyra::Ordinal>(k);
      Status one = solve_system(*residual->col(column), step->col(column).ptr(), Teuchos::ptrFromRef(own));
      if (one.solveStatus != Thyra::SOLVE_STATUS_CONVERGED) return one;
      Thyra::Vp_V(x->col(column).ptr(), *step->col(column));
    }
    return status;
  }

  Status solve_system(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                      const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    if (nonnull(given_)) return counted(b, x, criteria);
    const bool old = !fresh_;
    try {
      Status status = attempt(b, x, criteria);
      if (status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED || !old) return status;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      const bool indefinite = shows_negative_curvature(error, b, *x);
      // A new preconditioner would not change the matrix. If the old one is to blame, it is discarded at the second
      // failure.
      if (old && indefinite && !refused_) {
        refused_ = true;
        stale_ = false;
        throw NegativeCurvature();
      }
      if (!old) return refined_or_broken(error, b, x, criteria);
    }
    if (options_.from_scratch) preconditioner_.start_over();
    renew();
    try {
      return attempt(b, x, criteria);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      return refined_or_broken(error, b, x, criteria);
    }
  }

  /// Returns whether CG failed because the matrix, or its preconditioner, is not positive definite. Belos' CG throws
  /// for that reason, on all ranks, and Trilinos 13.2 also where a number is not finite: its last iterate tells which.
  /// A failure of one of CG's variants for another reason counts too; what follows it is then tried in vain.
  bool shows_negative_curvature(const std::exception& error, const Thyra::MultiVectorBase<double>& b,
                                const Thyra::MultiVectorBase<double>& x) const {
    if (dynamic_cast<const NegativeCurvature*>(&error) != nullptr) return true;
    return options_.is_cg && dynamic_cast<const Thyra::CatastrophicSolveFailure*>(&error) != nullptr && is_finite(b) &&
           is_finite(x);
  }

  /// After CG failed with a preconditioner of this matrix: solves by refinement if the preconditioner is a
  /// factorisation and the matrix is indefinite. Throws std::runtime_error if that is not so, or if it fails too.
  Status refined_or_broken(const std::exception& error, const Thyra::MultiVectorBase<double>& b,
                           const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                           const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    Status status;
    const bool indefinite = shows_negative_curvature(error, b, *x);
    if (options_.factorizes && indefinite) status = refined(b, x, criteria);
    if (status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED) return status;
    const std::string why =
        indefinite
            ? "conjugate gradients found the matrix or its preconditioner not positive definite, as where a body "
              "buckles or snaps; the Linear Solver Type Direct solves with such matrices"
            : error.what();
    throw std::runtime_error("the linear solver broke down: " + why);
  }

  /// Solves by iterative refinement with the preconditioner. Gives up if a round does not halve the residual.
  Status refined(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                 const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    const TimedScope timed(Phase::LinearSolve);
    const bool told =
        nonnull(criteria) && criteria->requestedTol != Thyra::SolveCriteria<double>::unspecifiedTolerance();
    const double tolerance = told ? criteria->requestedTol : 1e-6;
    const auto inverse = preconditioner_.get()->getUnspecifiedPrecOp();
    const auto residual = b.clone_mv(), step = b.clone_mv();
    const double scale = largest_norm(b);
    Status status;
    Thyra::assign(x, 0.0);
    for (double last = std::numeric_limits<double>::infinity();;) {
      Thyra::apply(*inverse, Thyra::NOTRANS, *residual, step.ptr());
      Thyra::update(1.0, *step, x);
      Thyra::assign(residual.ptr(), b);
      Thyra::apply(*krylov_, Thyra::NOTRANS, *x, residual.ptr(), -1.0, 1.0);
      ++statistics_->iterations;
      const double norm = largest_norm(*residual);
      if (norm <= tolerance * scale) status.solveStatus = Thyra::SOLVE_STATUS_CONVERGED;
      status.achievedTol = norm / scale;
      if (norm <= tolerance * scale || !(norm < 0.5 * last)) return status;
      last = norm;
    }
  }

  /// Solves, and counts the iterations.
  Status counted(const Thyra::MultiVectorBase<double>& b, const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
                 const Teuchos::Ptr<const Thyra::SolveCriteria<double>>& criteria) const {
    const TimedScope timed(Phase::LinearSolve);
    const double tolerance = b.domain()->dim() == 1 && options_.cg_iterations > 0 ? relative_tolerance(criteria) : 0;
    FirstRankFactorization* const inverse = tolerance > 0 ? first_rank_inverse() : nullptr;
    if (inverse != nullptr) return solved_on_first_rank(*inverse, b, x, tolerance);
    *converged_ = options_.spares_last ? (1 - 1e-9) * tolerance * largest_norm(b) : 0;
    Thyra::assign(x, 0.0);
    Status status = Thyra::solve<double>(*krylov_, Thyra::NOTRANS, b, x, criteria);
    statistics_->iterations += iterations(status);
    // Newer versions of CG return this where older ones throw.
    if (options_.is_cg && status.solveStatus == Thyra::SOLVE_STATUS_UNCONVERGED && largest_norm(*x) == 0)
      throw_not_finite();
    return status;
  }

  /// Returns the preconditioner if the first rank applies it alone and collects the present matrix, so that it can
  /// iterate without messages; else null.
  FirstRankFactorization* first_rank_inverse() const {
    if (nonnull(given_)) return nullptr;
    const auto inverse =
        Teuchos::rcp_dynamic_cast<const CollectedInverse>(preconditioner_.get()->getUnspecifiedPrecOp());
    FirstRankFactorization* const result = inverse.is_null() ? nullptr : inverse->on_first_rank();
    if (result == nullptr) return nullptr;
    const auto matrix = Teuchos::rcp_dynamic_cast<const CrsMatrix>(Extract::getConstTpetraOperator(source_->getOp()));
    return matrix == result->collected().source() ? result : nullptr;
  }
  Status solved_on_first_rank(FirstRankFactorization& inverse, const Thyra::MultiVectorBase<double>& b,
                              const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x, double tolerance) const {
    if (!collected_) inverse.collected().refresh();
    collected_ = true;
    const CollectedSolve solve = collected_cg(
        inverse.collected(), [&inverse](const double* r) { return inverse.solve_collected(r); },
        *Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(b)),
        *Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(x)), tolerance, options_.cg_iterations);
    statistics_->iterations += solve.iterations;
    if (solve.status == CollectedSolve::NegativeCurvature) throw NegativeCurvature();
    if (solve.status == CollectedSolve::NotFinite) throw_not_finite();
    Status status;
    status.achievedTol = solve.residual;
    status.solveStatus =
        solve.status == CollectedSolve::Converged ? Thyra::SOLVE_STATUS_CONVERGED : Thyra::SOLVE_STATUS_UNCONVERGED;
    status.extraParameters = Teuchos::parameterList();
    status.extraParameters->set("Iteration Count", solve.iterations);
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
  LaggedOptions options_;
  std::shared_ptr<LinearStatistics> statistics_;
  std::shared_ptr<const int> family_;  ///< of the present matrix
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> krylov_;
  mutable KeptPreconditioner preconditioner_;
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source_;
  /// The caller's preconditioner, or null.
  Teuchos::RCP<const Thyra::PreconditionerBase<double>> given_;

  std::shared_ptr<double> converged_ = std::make_shared<double>(0);  ///< a smaller residual has converged; or 0

  mutable bool collected_ = false;             ///< the first rank has the present matrix
  mutable bool stale_ = true;                  ///< renew before the next matrix
  mutable bool fresh_ = false;                 ///< renewed, and not used since
  mutable std::vector<int> least_iterations_;  ///< of the solves with this preconditioner, by family
  mutable double excess_ = 0;                  ///< iterations beyond the least, summed
  mutable bool refused_ = false;               ///< the last matrix was found not positive definite
};

/// The factorisation may be one of an older matrix. The length of the step is therefore that of the method of steepest
/// descent, which lowers the error whatever the factorisation.
bool LaggedSolve::correction(const Thyra::VectorBase<double>& residual, Thyra::VectorBase<double>& step) const {
  if (!options_.factorizes || nonnull(given_)) return false;
  const TimedScope timed(Phase::LinearSolve);
  const Teuchos::RCP<Thyra::VectorBase<double>> product = residual.clone_v();
  Thyra::apply<double>(*preconditioner_.get()->getUnspecifiedPrecOp(), Thyra::NOTRANS, residual,
                       Teuchos::ptrFromRef(step));
  Thyra::apply<double>(*krylov_, Thyra::NOTRANS, step, product.ptr());
  const double slope = Thyra::dot(residual, step), curvature = Thyra::dot(*product, step);
  if (!(slope > 0 && curvature > 0)) return false;
  Thyra::scale(slope / curvature, Teuchos::ptrFromRef(step));
  return true;
}

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
