/// The shape of a surface of a mesh at rest.
#pragma once
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the places of a side's corners, along its rim; then, of a quadratic cell, those of its other nodes [L0].
std::vector<Vec<3>> side_points(const Mesh& mesh, const Side& side);

/// Returns the extent of a connected part along a direction of length 1 [L0]. `parts`: see connected_parts().
double extent_along(const Mesh& mesh, const std::vector<int>& parts, int part, const Vec<3>& direction);

/// Returns the curvature 1/R [1/L0] of a surface at a place whose outward normal is -`normal`, as its nodes around have
/// it; 0 if it is flat there, hollow, an edge, or too coarse. Hanging nodes and those of enrichment are on straight
/// sides.
double curvature_of(const Mesh& mesh, const SideSet& set, const Vec<3>& apex, const Vec<3>& normal);

/// Returns how far a surface extends along a direction of length 1 [L0]: 0 of one that is flat across it.
double height_of(const Mesh& mesh, const SideSet& set, const Vec<3>& direction);

/// Returns the shorter extent of a surface across its normal, of length 1, along the axes but the one nearest to it,
/// turned into its plane; of a body of revolution the outer radius, where the surface lies across the axis [L0].
double extent_of(const Mesh& mesh, const SideSet& set, const Vec<3>& normal);

struct SurfaceNormal {
  Vec<3> direction{};      ///< outwards, of length 1; not a number where the sides cancel
  bool is_on_rim = false;  ///< the node has one side, in space at most two: the direction is that of one half
};

/// Returns the normal of a surface at a node: the mean of the sides of the set that have it, weighted by their size.
SurfaceNormal normal_at(const Mesh& mesh, const SideSet& set, int node);

}  // namespace ixos
