/// Values of nodal variables in an Exodus file. Included by lib/io only.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/exodus_handle.hpp"

namespace ixos {

/// Returns the nodal variable of that name at the last time, a number for each of the file's nodes. Throws InputError,
/// with the path, that names the variables of the file if it has no such variable, and if the file has no times, or the
/// values cannot be read.
std::vector<double> last_nodal_values(const ExodusHandle& file, const std::string& name, int64_t nodes);

}  // namespace ixos
