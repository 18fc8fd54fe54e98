/// Names of sets with a "*".
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns whether a name has a "*", which stands for any characters, also none.
bool is_pattern(const std::string& name);
bool matches(const std::string& pattern, const std::string& name);

/// Returns the names, each pattern among them replaced by those of `known` that it matches, in their order. A pattern
/// that matches none stays; what a pattern has named already is left out.
std::vector<std::string> expanded(const std::vector<std::string>& names, const std::vector<std::string>& known);

/// Adds sets under the names of patterns: all sides, or all nodes, of the sets that a pattern matches. A pattern that
/// matches no set adds none; names without a "*" are passed over.
void add_pattern_sets(const std::vector<std::string>& names, Mesh& mesh);

}  // namespace ixos
