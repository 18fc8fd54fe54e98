/// A gecko's spatula of hexahedra: a flat pad on a wall, a shaft that rises from its rear end, and a transition.
///
/// The pad lies along x from its rear end (x = 0) to its tip (x = pad length), its flat underside at z = gap over the
/// wall z = 0; y is the lateral direction and y = 0 a plane of symmetry. The shaft rises from the rear end towards
/// negative x. The scene is that of Gautam and Sauer (2014), who leave the geometry to Sauer and Holl (2013); outline,
/// morphing and mesh are ours.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Lengths in L0, here nm.
struct SpatulaShape {
  double pad_length = 230;
  double neck_width = 100;         ///< of the pad's rear end
  double tip_width = 240;          ///< the pad's largest width, >= neck_width
  double widening_length = 100;    ///< the half-width grows by s^2 (3 - 2 s), s = x / widening_length, then stays
  double tip_length = 120;         ///< the outline ends in half an ellipse of semi-axes tip_length and tip_width / 2
  double rear_thickness = 15;      ///< of the pad at x = 0, linear in x
  double tip_thickness = 5;        ///< of the pad at x = pad_length
  double transition_length = 100;  ///< along the centreline; the rectangle there becomes the shaft's disk
  double fillet_radius = 68;       ///< of the centreline, an arc that begins at the pad and is tangent to pad and shaft
  double shaft_diameter = 80;
  double shaft_length = 180;       ///< beyond the transition
  double inclination = 45;         ///< between shaft and wall, degrees, in (0, 90]
  double gap = 0.254709287789268;  ///< of the underside; the default is the equilibrium gap 15^(-1/6) / 2.5

  int core_cells = 44;  ///< cells across the core of a section, even, >= 4
  int core_layers = 2;  ///< cells through it, >= 1
  int rings = 2;        ///< layers of cells around it, >= 1; core_layers + 2 rings layers lie on the wall
  int tip_rows = 10;    ///< rows of cells that turn around the tip, 1 to core_cells / 2 - 1
  int stations = 0;  ///< cells along, from the shaft's end to the pad's side at 45 degrees of the tip; 0: target_cells
  int target_cells = 114414;  ///< chooses `stations`; below 50,000 also fewer cells in a section than given above
  double growth = 2;          ///< cell length in the shaft over that in the pad, >= 1
  double layer_ratio = 2;     ///< thickness of the pad's uppermost layer over the lowest, in the contact, >= 1
};

/// Into how many cells a shape is divided.
struct SpatulaDivisions {
  int core_cells, core_layers, rings, tip_rows;
  int shaft, transition, pad;  ///< cells along each
  int stations() const { return shaft + transition + pad; }
  int section_cells() const { return core_cells * core_layers + rings * 2 * (core_cells + core_layers); }
  int cells() const;
};

/// Returns the divisions of the shape. Throws InputError, with the name, the value and what is allowed, for a value out
/// of range.
SpatulaDivisions spatula_divisions(const SpatulaShape& shape);

/// Returns the mesh of hexahedra, block "body". Side and node sets "pad" (the flat underside; a cell has at most one
/// side in it), "shaft end" (the plane cut at the top) and "surface" (all of it); node set "tip": the underside's
/// foremost node, on y = 0.
///
/// Sections across are O-grids: a core of core_cells x core_layers cells and rings around it. A section is swept from
/// the shaft to the pad. The pad's outline is smooth, so a sweep to the tip would end in cells with an angle of 180
/// degrees at the meeting of sides and tip. Instead the outermost tip_rows columns of either side turn around the tip,
/// and so do the cells at the narrow ends of the sections. Throws InputError as spatula_divisions() does, and if the
/// transition would sink below the pad's underside.
Mesh spatula(const SpatulaShape& shape);

}  // namespace ixos
