/// The largest rotation and the extreme strains of a displacement field.
#pragma once
#include <vector>

#include "base/small_matrix.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Extremes of deformation gradients F = R U. The principal strains are the eigenvalues of U - I, stretches less 1.
struct StrainExtent {
  double rotation = 0;  ///< largest angle of R, from 0 to pi [rad]
  double least = 0;     ///< least principal strain, at most 0 [-]
  double largest = 0;   ///< largest principal strain, at least 0 [-]
};

/// Returns the extremes of one displacement gradient H = F - I; in plane strain there is none out of the plane.
StrainExtent strain_extent(const Small<double, 2>& h);
StrainExtent strain_extent(const Small<double, 3>& h);

/// Returns the extremes over the quadrature points of this rank's own cells, and the hoop strains of rings. `u`: local
/// array, ghosts included. Leaves out the modes of enhanced cells. NaN if the field is not finite.
StrainExtent strain_extent(const LocalMesh& mesh, const std::vector<double>& u);

}  // namespace ixos
