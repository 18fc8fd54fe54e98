#include "solve/direct/factorization.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <utility>

#include "parameters/one_of.hpp"
#include "solve/direct/first_rank_factorization.hpp"
#include "solve/solver_library.hpp"

namespace ixos {

std::vector<std::string> factorizations() {
#ifdef IXOS_CHOLMOD
  return {"CHOLMOD", "Band", "Band LU", "KLU", "MUMPS", "MUMPS Single"};
#else
  return {"KLU", "Band", "Band LU", "MUMPS", "MUMPS Single"};
#endif
}

std::string first_rank_factorization() { return factorizations().front(); }

std::unique_ptr<Factorization> make_factorization(const std::string& type) {
#ifdef IXOS_CHOLMOD
  if (type == "CHOLMOD") return make_cholmod();
#endif
  if (type == "Band") return make_band();
  if (type == "Band LU") return make_band_lu();
  if (type == "KLU") return make_klu();
  return solver_library().mumps(type == "MUMPS Single");
}

void KeptFactorization::renew(const Teuchos::RCP<const CrsMatrix>& matrix, const std::string& type) {
  if (!factorization_ || matrix.get() != matrix_.get()) {
    const FactorizationMemory memory = std::exchange(loaded_, {});
    const auto analyzed = [&](const std::string& name) {
      auto factorization = make_factorization(name);
      factorization->remember(memory);
      factorization->analyze(matrix);
      return factorization;
    };
    auto factorization = analyzed(type);
    if (!factorization->suits()) factorization = analyzed(type == "Band LU" ? "KLU" : first_rank_factorization());
    matrix_ = matrix;
    factorization_ = std::move(factorization);
  }
  factorization_->factor();
}

FirstRankFactorization* KeptFactorization::on_first_rank() const {
  return dynamic_cast<FirstRankFactorization*>(factorization_.get());
}

void KeptFactorization::transfer(Record& record) {
  FactorizationMemory memory = factorization_ ? factorization_->memory() : loaded_;
  record.number("indefinite", memory.indefinite);
  record.share("pivots for", memory.pivots_for);
  if (!record.loading()) return;
  if (record.in_memory() && factorization_) {
    const int changed = memory == factorization_->memory() ? 0 : 1;
    int any = 0;
    Teuchos::reduceAll(*matrix_->getComm(), Teuchos::REDUCE_MAX, 1, &changed, &any);
    if (any == 0) return;
  }
  factorization_.reset();
  loaded_ = std::move(memory);
}

Teuchos::RCP<const Teuchos::ParameterList> factorization_parameters() {
  const auto valid = Teuchos::parameterList();
  valid->set("Solver Type", first_rank_factorization(),
             "Factorisation. Band and CHOLMOD (symmetric matrices), Band LU (symmetric sparsity) and KLU (any matrix) "
             "work on the first rank, MUMPS (symmetric matrices) on all ranks. MUMPS Single works in single precision "
             "and can only be a "
             "preconditioner.",
             one_of(factorizations()));
  return valid;
}

}  // namespace ixos
