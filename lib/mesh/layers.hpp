/// Layers of cells below a surface.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// The cells of a side set whose opposite side has no neighbour: the body is one cell thick there.
struct SingleLayer {
  double share = 0;      ///< of the set's sides that have such a cell
  double thickness = 0;  ///< mean distance of the two sides' centres in those cells [L0]
};

/// Returns them for any set, enriched or not.
SingleLayer single_layer(const Mesh& mesh, const SideSet& set);

}  // namespace ixos
