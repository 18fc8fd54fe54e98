/// Suggestions for misspelt names.
#pragma once
#include <string>
#include <vector>

namespace ixos {

/// Returns the candidate with the smallest Damerau-Levenshtein distance to `name` (optimal string alignment, case
/// ignored); empty if there is no candidate. Candidates of several words that `name` abbreviates ("AVF", "gen-alpha",
/// "HHT") and those within one edit come before all others. Ignores what follows the first 255 bytes of a name.
std::string closest_name(const std::string& name, const std::vector<std::string>& candidates);

/// Returns `what "name" does not exist; did you mean "..."?`, followed by `there` and the names: "The mesh has" "a",
/// "b". Without names it is `what "name" does not exist.`, followed by `there` and "none".
std::string no_such(const std::string& what, const std::string& name, const std::vector<std::string>& names,
                    const std::string& there);

/// Returns the names in double quotes, separated by commas.
std::string quoted_list(const std::vector<std::string>& names);

}  // namespace ixos
