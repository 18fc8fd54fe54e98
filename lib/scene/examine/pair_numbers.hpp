/// The numbers of a scene's interactions of two surfaces.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/examine/characteristic_numbers.hpp"

namespace ixos {

/// A surface of a pair.
struct PairSurface {
  const SideSet& set;
  const BodyNumbers& body;
  int part;          ///< of the mesh, see connected_parts()
  double curvature;  ///< 1/R of a disk or a ball, else 0: the nodes tell [1/L0]
};

/// Adds to `numbers`, which has what the law gives, the lengths of a body on a rigid obstacle that two surfaces amount
/// to: its modulus is 1/E* = 1/E1* + 1/E2*, that of W/E likewise, its curvature 1/R1 + 1/R2 if both surfaces are round
/// and bulge (Johnson 1985), its extent the smaller one; as plates both bend: 1/(E* h^3) = 1/(E1* h1^3) + 1/(E2* h2^3).
/// The normal points out of `other`. The largest gap exceeds the least by what the surfaces are not flat. The extent
/// stays 0, and nothing is known, if the surfaces do not face each other where they are nearest, or if both are on one
/// part. `parts`: see connected_parts().
void add_pair(const Mesh& mesh, const std::vector<int>& parts, const PairSurface& own, const PairSurface& other,
              SurfaceNumbers& numbers);

}  // namespace ixos
