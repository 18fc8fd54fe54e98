/// Sections of a spatula across its centreline, and the centreline.
#pragma once
#include <array>
#include <vector>

#include "mesh/generators/spatula.hpp"

namespace ixos {

/// A node's place in a section: an O-grid whose core's cells and rings make layers one upon the other, and whose rings
/// have cells at the two narrow ends too.
struct SectionNode {
  int column;  ///< 0 to core_cells
  int layer;   ///< 0 to core_layers: of the core; of a ring, 0: its lower side, core_layers: its upper one
  int ring;    ///< 0: the core's boundary or inside, to rings: the surface
};

/// Height over the pad's underside, over the thickness: 0 to 1. Layers get thicker from the underside on.
class SpatulaLayers {
 public:
  SpatulaLayers(const SpatulaShape& shape, const SpatulaDivisions& divisions);
  double height(const SectionNode& node) const;

 private:
  int core_layers_, rings_;
  std::vector<double> heights_;
};

/// Returns the node in the shaft's disk, [L0]: lateral and upward from the centreline.
std::array<double, 2> disk_node(const SpatulaShape& shape, const SpatulaDivisions& divisions, const SectionNode& node);

/// The centreline from the pad's rear end on: an arc, then straight.
struct CenterlinePoint {
  double x, z;          ///< [L0]
  double sine, cosine;  ///< of the angle to the wall; the section's upward direction is (sine, cosine)
};
CenterlinePoint centerline(const SpatulaShape& shape, double length);

/// Returns how far the section is on its way from the pad's rectangle, 0, to the shaft's disk, 1: a quintic with no
/// slope and no curvature at the ends.
double roundness(const SpatulaShape& shape, double length);

/// Returns the distance from the pad's rear end, along the centreline, of station `station` counted from the shaft's
/// end. Cells grow geometrically along the transition.
double station_length(const SpatulaShape& shape, const SpatulaDivisions& divisions, int station);

}  // namespace ixos
