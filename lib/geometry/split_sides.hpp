/// Sides of a surface in space that has triangles, as four-sided patches.
#pragma once
#include <vector>

#include "geometry/surface_patch.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/side_grid.hpp"

namespace ixos {

/// Each side is cut at its middle and at those of its edges, a triangle into three patches and a quadrilateral beside
/// triangles into four, so that patches meet side by side. They keep the shape of a side: the functions of its nodes at
/// places that are bilinear in a patch's parameters. Smooth sides of linear cells have that of quadratic ones through
/// EdgeMiddles; their normals jump by what falls with the square of the sides' length.
struct SplitSides {
  std::vector<SurfacePatch<3>> patches;  ///< without neighbours; smooth at the sides within a side of a cell
  std::vector<int> side;                 ///< by patch
  std::vector<SideGrid::Face> faces;     ///< by patch: corners, by their numbers in `x`
  std::vector<Vec<3>> x;                 ///< places of the surface's nodes, then of points between them [L0]
  std::vector<long long> numbers;        ///< parallel to x: of a node in messages
};

/// Cuts the sides of linear and quadratic cells. `nodes`: those of the surface, in the order of their global numbers.
/// Throws InputError with `name` if two sides go along an edge in one direction, or if a smooth side follows more than
/// SurfacePatch<3>::most nodes.
SplitSides split_sides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const std::vector<int>& nodes,
                       bool smooth, const std::string& name);

}  // namespace ixos
