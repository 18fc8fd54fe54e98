/// Words of a given choice, for Teuchos parameter lists.
#pragma once
#include <Teuchos_ParameterEntryValidator.hpp>
#include <string>
#include <vector>

namespace ixos {

/// Returns a validator that accepts these words only.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(const std::vector<std::string>& words);

}  // namespace ixos
