#include "parameters/one_of.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>

namespace ixos {

Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(const std::vector<std::string>& words) {
  return Teuchos::rcp(new Teuchos::StringValidator(Teuchos::Array<std::string>(words)));
}

}  // namespace ixos
