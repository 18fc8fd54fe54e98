#include "solve/factorization.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <utility>

#include "base/one_of.hpp"

namespace ixos {

std::unique_ptr<Factorization> make_factorization(const std::string& type) {
  if (type == "KLU") return make_klu();
  if (type == "CHOLMOD") return make_cholmod();
  return make_mumps(type == "MUMPS Single");
}

void KeptFactorization::renew(const Teuchos::RCP<const CrsMatrix>& matrix, const std::string& type) {
  if (!factorization_ || matrix.get() != matrix_.get()) {
    auto factorization = make_factorization(type);
    factorization->remember(std::exchange(loaded_, {}));
    factorization->analyze(matrix);
    matrix_ = matrix;
    factorization_ = std::move(factorization);
  }
  factorization_->factor();
}

void KeptFactorization::transfer(Record& record) {
  FactorizationMemory memory = factorization_ ? factorization_->memory() : loaded_;
  record.number("indefinite", memory.indefinite);
  record.share("pivots for", memory.pivots_for);
  if (!record.loading()) return;
  factorization_.reset();
  loaded_ = std::move(memory);
}

Teuchos::RCP<const Teuchos::ParameterList> factorization_parameters() {
  const auto valid = Teuchos::parameterList();
  valid->set(
      "Solver Type", "CHOLMOD",
      "\"CHOLMOD\" (symmetric matrices) or \"KLU\" (any), both on the first rank; \"MUMPS\" (symmetric matrices), on "
      "all ranks; \"MUMPS Single\", in single precision: a preconditioner",
      one_of({"CHOLMOD", "KLU", "MUMPS", "MUMPS Single"}));
  return valid;
}

}  // namespace ixos
