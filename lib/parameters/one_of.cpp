#include "parameters/one_of.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>

namespace ixos {
namespace {

class Choice final : public Teuchos::StringValidator {
 public:
  using StringValidator::StringValidator;
};

}  // namespace

Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(const std::vector<std::string>& words) {
  return Teuchos::rcp(new Teuchos::StringValidator(Teuchos::Array<std::string>(words)));
}

Teuchos::RCP<const Teuchos::ParameterEntryValidator> choice_of(const std::vector<std::string>& words) {
  return Teuchos::rcp(new Choice(Teuchos::Array<std::string>(words)));
}

bool is_choice(const Teuchos::RCP<const Teuchos::ParameterEntryValidator>& validator) {
  return nonnull(Teuchos::rcp_dynamic_cast<const Choice>(validator));
}

}  // namespace ixos
