/// Planes at which a body may be cut out of a symmetric one.
#pragma once
#include <cstddef>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// A plane across a coordinate axis, at an end of a body.
struct CutPlane {
  std::size_t axis = 0;      ///< 0: x
  double place = 0;          ///< coordinate along the axis [L0]
  std::vector<int> nodes{};  ///< of the body in the plane, without derivatives; ascending
};

/// Returns the planes at the ends of a body where a side set of the body's boundary meets the plane at a right angle
/// and bends away from it, as a smooth surface does at a plane of symmetry: the sides at the plane lean by at most 20
/// degrees, those behind them by nearly twice as much, or more, on average. A flat surface meets none, neither does a
/// whole disk. The ends of a body of revolution along its radius are left out. `parts`: see connected_parts().
std::vector<CutPlane> cut_planes(const Mesh& mesh, const SideSet& set, const std::vector<int>& parts);

}  // namespace ixos
