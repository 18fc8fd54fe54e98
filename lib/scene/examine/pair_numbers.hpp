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

/// Adds to `numbers`, which has what the law gives, what two surfaces show where they are nearest to each other: the
/// lengths of a body on a rigid obstacle whose modulus is 1/E* = 1/E1* + 1/E2*, whose curvature is 1/R1 + 1/R2 (Johnson
/// 1985) and whose extent and thickness are the smaller ones. The normal points out of `other`. Without nodes that face
/// each other the extent stays 0. `parts`: see connected_parts().
void add_pair(const Mesh& mesh, const std::vector<int>& parts, const PairSurface& own, const PairSurface& other,
              SurfaceNumbers& numbers);

}  // namespace ixos
