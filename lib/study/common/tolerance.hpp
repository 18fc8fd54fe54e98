/// Tolerances as users write them.
#pragma once
#include <string>

namespace ixos {

/// Returns the part of a quantity that a text spells: "1%" and "0.01" are the same. Throws InputError, which names the
/// option, unless it is at least 1e-8 and less than 1.
double read_tolerance(const std::string& option, const std::string& text);

}  // namespace ixos
