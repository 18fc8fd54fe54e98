/// Words of a given choice, for Teuchos parameter lists.
#pragma once
#include <Teuchos_ParameterEntryValidator.hpp>
#include <string>
#include <vector>

namespace ixos {

/// The words of a parameter that chooses. Some parameters and sublists beside it belong to one word or to several.
struct Choice {
  struct Word {
    std::string name;
    std::vector<std::string> belongings;  ///< names of parameters and sublists
  };
  std::vector<Word> words;
  bool exclusive = false;  ///< whether the validation refuses what belongs to other words only

  /// Returns the names that belong to this word.
  std::vector<std::string> belongings(const std::string& word) const;
  /// Returns the names that belong to other words only, each once; none if `word` is not a word.
  std::vector<std::string> left_out(const std::string& word) const;
  /// Returns the words to which this name belongs.
  std::vector<std::string> owners(const std::string& name) const;
};

/// Returns a validator that accepts these words only.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(const std::vector<std::string>& words);

/// Returns a validator that accepts the same, for a parameter that chooses among sublists: of those whose names are
/// words, only the chosen one is filled in with defaults. A scene may hold the others too.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> choice_of(const std::vector<std::string>& words);

/// Returns a validator that accepts the same, for a parameter that chooses what else stands beside it. A scene may not
/// hold what belongs to other words only.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> exclusive_choice_of(const std::vector<Choice::Word>& words);

/// Returns the choice of a validator that choice_of() or exclusive_choice_of() made; null for any other.
const Choice* choice_behind(const Teuchos::RCP<const Teuchos::ParameterEntryValidator>& validator);

}  // namespace ixos
