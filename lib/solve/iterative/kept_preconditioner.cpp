#include "solve/iterative/kept_preconditioner.hpp"

#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <utility>

#include "base/agreement.hpp"
#include "base/phase_timer.hpp"
#include "solve/operator_preconditioner.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

auto values(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source) {
  return Teuchos::rcp_const_cast<CrsMatrix>(matrix_of(*source))->getLocalMatrixHost().values;
}

}  // namespace

void KeptPreconditioner::make(const Source& source) {
  initialize_preconditioner(*factory_, options_.of_matrix, source, *preconditioner_);
}

void KeptPreconditioner::renew(const Source& source) {
  setup_ = -1;
  make(source);
  if (options_.restartable && options_.of_matrix) note_matrix(source);
  setup_ = ++statistics_->setups;
}

void KeptPreconditioner::start_over() {
  preconditioner_ = factory_->createPrec();
  matrices_ = 0;
  first_matrix_.clear();
}

void KeptPreconditioner::note_matrix(const Source& source) {
  const auto present = values(source);
  if (options_.from_scratch && matrices_ == 1) first_matrix_ = std::move(matrix_);
  matrix_.assign(present.data(), present.data() + present.extent(0));
  matrices_ = options_.from_scratch ? std::min(matrices_ + 1, 2) : 1;
}

/// Some parts are made at the first use only (MueLu's coarsest level), from the values that the matrix has then.
void KeptPreconditioner::force() const {
  const auto op = preconditioner_->getUnspecifiedPrecOp();
  if (op.is_null()) return;
  const auto x = Thyra::createMembers(op->domain(), 1);
  const auto y = Thyra::createMembers(op->range(), 1);
  Thyra::assign(x.ptr(), 0.0);
  Thyra::apply(*op, Thyra::NOTRANS, *x, y.ptr());
}

void KeptPreconditioner::rebuild(const Source& source, bool stale) {
  if (!loaded_) return;
  const TimedScope timed(Phase::Factorization);
  if (options_.of_matrix) {
    const auto here = values(source);
    const std::vector<double> present(here.data(), here.data() + here.extent(0));
    const auto make_from = [&](const std::vector<double>& earlier) {
      together<InputError>(matrix_of(*source)->getComm(), [&] {
        if (earlier.size() != present.size()) throw InputError("a matrix of the checkpoint has a different size");
      });
      std::copy(earlier.begin(), earlier.end(), here.data());
      make(source);
      force();
    };
    // They could be made once, so they can be made again.
    if (matrices_ > 1) make_from(first_matrix_);
    if (matrices_ == 1 || (matrices_ > 1 && !stale)) make_from(matrix_);
    // A multigrid's finest level is the matrix itself. If only preconditioners have a matrix, it resumes with the
    // values from which they were made, as in an uninterrupted run.
    const auto assemblable =
        Teuchos::rcp_dynamic_cast<const AssemblableOperator>(Extract::getConstTpetraOperator(source->getOp()));
    if (nonnull(assemblable))
      assemblable->forget_values();
    else
      std::copy(present.begin(), present.end(), here.data());
  } else {
    make(source);
  }
  loaded_ = false;
}

void KeptPreconditioner::transfer(Record& record) {
  if (record.in_memory() && transfer_setup(record)) return;
  record.number("matrices", matrices_);
  record.share("first matrix", first_matrix_);
  record.share("matrix", matrix_);
  if (record.loading()) {
    preconditioner_ = factory_->createPrec();  // no trace of later matrices
    if (!record.in_memory()) setup_ = ++statistics_->setups;
    loaded_ = true;
  }
  const auto inner = Teuchos::rcp_dynamic_cast<KeptState>(preconditioner_->getNonconstUnspecifiedPrecOp());
  if (nonnull(inner)) inner->transfer(record);
}

/// Transfers the number of the set-up that the preconditioner is of. Returns whether it is that of the record: then the
/// preconditioner is as it was.
bool KeptPreconditioner::transfer_setup(Record& record) {
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

}  // namespace ixos
