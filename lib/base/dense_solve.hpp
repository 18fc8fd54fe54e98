/// Small dense systems.
#pragma once
#include <vector>

namespace ixos {

/// Returns the solution of A x = b, A row by row, its equations and unknowns scaled; empty if A is singular, to
/// rounding.
std::vector<double> dense_solve(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ixos
