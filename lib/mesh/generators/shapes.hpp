/// Structured meshes made in memory.
#pragma once
#include <array>

#include "mesh/mesh.hpp"

namespace ixos {

/// A disk of quadrilaterals on an O-grid: a square core and rings around it.
struct DiskShape {
  double diameter = 10.0;          ///< [L0], > 0
  std::array<double, 2> center{};  ///< [L0]
  int core_divisions = 4;          ///< cells along a side of the core, >= 2 and even
  int rings = 2;                   ///< layers of cells around the core, >= 1
  double core_half_side = 0.4;     ///< half side of the core over the radius, in (0, 0.7)
  bool half = false;               ///< only the half at x >= center[0]
  int cell_order = 1;              ///< 1: four nodes a cell; 2: nine, those of the surface on the circle
};

/// Returns (core_divisions)^2 + 4 core_divisions rings cells, counter-clockwise. Block "body"; node and side set
/// "surface"; the node set "center" is the node at the centre. A half disk has half of the cells, and the node set
/// "axis" of the nodes on its straight side. Throws InputError for a value out of range.
Mesh disk(const DiskShape& shape);

/// A ball of hexahedra: a cube as the core and layers of cells around it.
struct BallShape {
  double diameter = 10.0;          ///< [L0], > 0
  std::array<double, 3> center{};  ///< [L0]
  int core_divisions = 4;          ///< cells along an edge of the core, >= 1
  int rings = 2;                   ///< layers of cells around the core, >= 1
  double core_half_side = 0.35;    ///< half edge of the core over the radius, in (0, 0.55)
};

/// Returns core_divisions^2 (core_divisions + 6 rings) cells. Block "body"; node and side set "surface", whose nodes
/// are on the sphere, on lines of equal angles. Throws InputError for a value out of range.
Mesh ball(const BallShape& shape);

/// A box of quadrilaterals (dimension 2) or hexahedra (dimension 3).
struct BoxShape {
  int dimension = 2;
  std::array<double, 3> lower{};                 ///< corner with the smallest coordinates [L0]
  std::array<double, 3> lengths{1.0, 1.0, 1.0};  ///< [L0], > 0
  std::array<int, 3> divisions{1, 1, 1};         ///< cells along x, y, z, >= 1
};

/// Returns a box. Block "body"; node and side sets "left", "right" (x), "bottom", "top" (the last direction: y in 2D, z
/// in 3D), "front", "back" (y in 3D) and "surface" (all). Throws InputError for a value out of range.
Mesh box(const BoxShape& shape);

}  // namespace ixos
