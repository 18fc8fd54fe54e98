/// Symmetric tensors of stress, and their invariants.
#pragma once
#include <array>

namespace ixos {

/// Components xx, yy, zz, xy, yz, zx. In plane strain yz and zx are zero, zz is not.
using SymmetricTensor = std::array<double, 6>;

/// Returns von Mises' equivalent stress, sqrt(3/2 s:s) with the deviator s: the stress of a uniaxial state.
double von_mises(const SymmetricTensor& stress);

/// Returns the eigenvalues, the largest first (LAPACK's DSYEV); NaN unless all components are finite.
std::array<double, 3> principal_values(const SymmetricTensor& stress);

}  // namespace ixos
