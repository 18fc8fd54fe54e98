/// The sides of a surface as patches.
#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "geometry/patch_points.hpp"
#include "geometry/surface_patch.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// How the sides of a surface are joined.
enum class Smoothing {
  None,  ///< straight or bilinear sides: the normal jumps between them
  /// Cubic curves, or bicubic patches where four sides meet at each inner node, through the nodes: linear in the nodes'
  /// places, and of one tangent where they meet at 30 degrees or less. Quadratic sides on surfaces with triangles, see
  /// SplitSides
  CatmullRom,
  /// Cubic splines near the nodes, of one tangent and one curvature where sides meet at 30 degrees or less; in space,
  /// see SplineFaces, where four of them meet at each node
  Spline
};

/// A surface as patches. They name nodes by their place in `nodes`.
template <std::size_t D>
struct SurfacePatches {
  std::vector<int> nodes;  ///< local nodes, in the order of their global numbers: alike on all ranks
  /// In the order of the sides: one for each, or several if the surface has triangles, see SplitSides.
  std::vector<SurfacePatch<D>> patches;
  std::vector<char> owned;                ///< by patch: energies count it on this rank
  bool through_nodes = true;              ///< false for splines in space
  std::vector<std::array<int, 3>> sides;  ///< by patch: local block, number of the cell, side, which identify that
  std::vector<int> part;                  ///< by patch: which one of its side it is, from 0

  /// Returns points_on_a_patch() of its patches.
  int points_along(int asked) const {
    return points_on_a_patch(asked, std::any_of(part.begin(), part.end(), [](int own) { return own > 0; }));
  }
  /// Returns the sides of the patches, or their parts, without nodes.
  std::vector<LocalSide> sides_of_patches() const;
};

/// Returns the patches of sides. Those of linear cells are joined as `smoothing` says; quadratic sides, and enriched
/// ones of Lagrange's kind, keep their own shape, whose normal jumps between them. Nodes on tied edges are left out.
/// Throws InputError with `name` if a side is of another kind (Q1CH), if sides are of several orders, if linear sides
/// in space are smoothed and have tied nodes, if more than two sides meet in a corner in the plane or in an edge in
/// space, if neighbours in space have opposite directions, if a surface with triangles is to be a spline, or if a patch
/// in space would have more than SurfacePatch<3>::most nodes.
template <std::size_t D>
SurfacePatches<D> surface_patches(const LocalMesh& mesh, const std::vector<LocalSide>& sides, Smoothing smoothing,
                                  const std::string& name);

/// Returns the surface's nodes and what the mesh says of its sides, without patches; throws if a side is of a kind that
/// surface_patches() refuses.
template <std::size_t D>
SurfacePatches<D> surface_of_sides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const std::string& name);

/// Returns whether some of the sides are triangles in space.
bool has_triangles(const LocalMesh& mesh, const std::vector<LocalSide>& sides);

/// Returns the number of patches of these sides.
std::size_t number_of_patches(const LocalMesh& mesh, const std::vector<LocalSide>& sides);

/// Returns the place of a local node among the surface's nodes, which are in the order of their global numbers.
int surface_number(const std::vector<int>& nodes, int node, const LocalMesh& mesh);

/// Shares of local arrays; null: 0.
using NodeParts = std::array<std::pair<double, const double*>, 3>;

/// Sets, for each of these local nodes, its place to `rest` times the undeformed one plus the sum of the parts.
/// `coordinates`: of the local mesh.
template <std::size_t D>
void combine_places(const std::vector<int>& nodes, const std::vector<double>& coordinates, double rest,
                    const NodeParts& parts, std::vector<Vec<D>>& places);
/// Returns these places.
template <std::size_t D>
std::vector<Vec<D>> combined_places(const std::vector<int>& nodes, const std::vector<double>& coordinates, double rest,
                                    const NodeParts& parts) {
  std::vector<Vec<D>> places;
  combine_places<D>(nodes, coordinates, rest, parts, places);
  return places;
}

/// Returns the place of a local node in the undeformed body [L0].
template <std::size_t D>
Vec<D> reference_place(const LocalMesh& mesh, int node) {
  Vec<D> x;
  for (std::size_t i = 0; i < D; ++i) x[i] = mesh.coordinates[D * static_cast<std::size_t>(node) + i];
  return x;
}

}  // namespace ixos
