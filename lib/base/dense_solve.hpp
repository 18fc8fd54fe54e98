/// Small dense systems.
#pragma once
#include <vector>

namespace ixos {

/// Returns the solution of A x = b, A row by row, its equations and unknowns scaled, by elimination with complete
/// pivoting (Golub and Van Loan 2013, section 3.4.8); empty if A is singular, to rounding. For a few unknowns: LAPACK
/// with its estimate of the condition takes several times as long.
std::vector<double> dense_solve(std::vector<double> a, std::vector<double> b);

}  // namespace ixos
