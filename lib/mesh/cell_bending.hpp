/// How stiff a body of linear cells is in bending.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// The energy of a cell's bending mode. The mode's strain is linear in each direction; its part that varies along a
/// parametric direction of the gradient k, with displacements along the unit vector e, has the energy density
/// (along (e k)^2 + shear |k|^2)/2. Moduli [E0].
struct BendingModuli {
  double along = 0;  ///< Standard cells: lambda + mu
  double shear = 0;  ///< mu
  double plate = 0;  ///< E/(1 - nu^2), which the bent material has
};

/// The cells of one body.
struct BendingQuery {
  std::string block{};
  BendingModuli moduli{};
  bool enriched_only = false;  ///< plain cells do not lock
  /// A body bends along directions in which it is at least this many times as long as it is thick; 0: along all.
  double slenderness = 0;
  std::vector<bool> held{};  ///< by node; empty: none. Layers on a side whose corners are all held do not bend.
};

/// Ratios to the stiffness of the material.
struct CellBending {
  double cell = 1;    ///< of one cell
  double body = 1;    ///< of the layers of cells through the thickness: 1 + (cell - 1)/layers^2
  int layers = 0;     ///< 0: the body does not bend
  double aspect = 0;  ///< length of the cell over its thickness
};

/// Returns the largest ratio `body` that more than half of the body's volume reaches, and the cell that has it; {} if
/// the body has less than two cells. A cell counts with its worst direction. Looks at some 64 cells, and counts up to
/// 64 cells on either side of each. Quadratic cells have the ratio 1.
CellBending typical_bending(const Mesh& mesh, const BendingQuery& query);

}  // namespace ixos
