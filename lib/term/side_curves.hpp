/// The sides of a surface in the plane as curves.
#pragma once
#include <vector>

#include "interaction/curve_segment.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// How the sides of a surface are joined.
enum class Smoothing {
  None,       ///< straight sides: the normal jumps at each node
  CatmullRom  ///< C1 curves through the nodes, linear in their places; they end at corners of more than 30 degrees
};

/// A surface as curves. Segments name nodes by their place in `nodes`.
struct SideCurves {
  std::vector<int> nodes;                 ///< local nodes
  std::vector<CurveSegment> segments;     ///< one for each side, in the order of the sides
  std::vector<char> owned;                ///< by segment: energies count it on this rank
  std::vector<std::array<int, 3>> sides;  ///< by segment: local block, number of the cell, side, which identify it

  /// Returns the places X + u of the nodes [L0]; u is local.
  std::vector<Planar> places(const LocalMesh& mesh, const double* u) const;
};

/// Returns the curves of sides of linear cells. Throws InputError with `name` if the mesh has three dimensions, a side
/// is not straight between two nodes (an enriched or a quadratic one), or more than two sides meet in a node.
SideCurves side_curves(const LocalMesh& mesh, const std::vector<LocalSide>& sides, Smoothing smoothing,
                       const std::string& name);

}  // namespace ixos
