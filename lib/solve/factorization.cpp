#include "solve/factorization.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>

namespace ixos {

std::unique_ptr<Factorization> make_factorization(const std::string& type) {
  return type == "KLU2" ? make_klu2() : make_cholmod();
}

Teuchos::RCP<const Teuchos::ParameterList> factorization_parameters() {
  const auto valid = Teuchos::parameterList();
  valid->set("Solver Type", "CHOLMOD", "\"CHOLMOD\" (symmetric matrices) or \"KLU2\" (any), both on the first rank",
             Teuchos::rcp(new Teuchos::StringValidator(Teuchos::tuple<std::string>("CHOLMOD", "KLU2"))));
  return valid;
}

}  // namespace ixos
