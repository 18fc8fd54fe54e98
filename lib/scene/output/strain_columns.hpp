/// The columns of history.csv for "Output/Strains".
#pragma once
#include <array>

namespace ixos {

/// The largest rotation [rad] and the least and largest principal strain [-] of a row, see StrainExtent.
inline constexpr std::array<const char*, 3> strain_columns{"largest_rotation", "least_strain", "largest_strain"};

}  // namespace ixos
