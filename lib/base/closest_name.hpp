/// Suggestions for misspelt names.
#pragma once
#include <string>
#include <vector>

namespace ixos {

/// The candidate with the smallest Damerau-Levenshtein distance to `name` (optimal string alignment, case ignored);
/// empty when there is no candidate.
std::string closest_name(const std::string& name, const std::vector<std::string>& candidates);

/// The names in double quotes, separated by commas.
std::string quoted_list(const std::vector<std::string>& names);

}  // namespace ixos
