/// Words of a given choice, for Teuchos parameter lists.
#pragma once
#include <Teuchos_ParameterEntryValidator.hpp>
#include <string>
#include <vector>

namespace ixos {

/// Returns a validator that accepts these words only.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(const std::vector<std::string>& words);

/// Returns a validator that accepts the same, for a parameter that chooses among sublists: of those whose names are
/// words, only the chosen one is filled in with defaults.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> choice_of(const std::vector<std::string>& words);
bool is_choice(const Teuchos::RCP<const Teuchos::ParameterEntryValidator>& validator);

}  // namespace ixos
