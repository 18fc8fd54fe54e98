#include "solve/factorization.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <utility>

namespace ixos {

std::unique_ptr<Factorization> make_factorization(const std::string& type) {
  return type == "KLU" ? make_klu() : make_cholmod();
}

void KeptFactorization::renew(const Teuchos::RCP<const CrsMatrix>& matrix, const std::string& type) {
  if (!factorization_ || matrix.get() != matrix_.get()) {
    auto factorization = make_factorization(type);
    factorization->analyze(matrix);
    matrix_ = matrix;
    factorization_ = std::move(factorization);
  }
  factorization_->factor();
}

Teuchos::RCP<const Teuchos::ParameterList> factorization_parameters() {
  const auto valid = Teuchos::parameterList();
  valid->set("Solver Type", "CHOLMOD", "\"CHOLMOD\" (symmetric matrices) or \"KLU\" (any), both on the first rank",
             Teuchos::rcp(new Teuchos::StringValidator(Teuchos::tuple<std::string>("CHOLMOD", "KLU"))));
  return valid;
}

}  // namespace ixos
