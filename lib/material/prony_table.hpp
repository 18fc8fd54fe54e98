/// Maxwell branches in a text file.
#pragma once
#include <string>
#include <vector>

#include "material/maxwell_branch.hpp"

namespace ixos {

/// Reads a table of relaxation times [T0] and shear moduli [E0], two numbers greater than 0 in each line, between them
/// blanks, tabs or one comma. Blank lines count for nothing, nor what follows a #. Throws InputError with file and
/// line.
std::vector<MaxwellBranch> read_prony_table(const std::string& file);

}  // namespace ixos
