/// Spheres and cubes of patches, without a model.
#pragma once
#include "geometry/surface_patches.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/partition.hpp"

namespace ixos::test {

/// The patches of a side set of a mesh in space, at rest.
struct MeshPatches {
  LocalMesh mesh;
  SurfacePatches<3> surface;
  std::vector<Vec<3>> x;  ///< of the surface's nodes

  MeshPatches(const Mesh& whole, const std::string& set, Smoothing smoothing)
      : mesh(localize(whole, partition_nodes(whole, 1), 0, 1, {set})),
        surface(surface_patches<3>(mesh, mesh.whole_side_sets.at(set), smoothing, set)) {
    for (const int node : surface.nodes) x.push_back(reference_place<3>(mesh, node));
  }
  const std::vector<SurfacePatch<3>>& patches() const { return surface.patches; }
};

/// A sphere about the origin of 6 `divisions`^2 patches.
struct SpherePatches : MeshPatches {
  SpherePatches(double radius, int divisions, Smoothing smoothing)
      : MeshPatches(of(radius, divisions), "surface", smoothing) {}
  static Mesh of(double radius, int divisions) {
    BallShape shape;
    shape.diameter = 2 * radius;
    shape.core_divisions = divisions;
    shape.rings = 1;
    return ball(shape);
  }
};

/// The cube of side 2 about the origin, of 3 x 3 bilinear patches a face.
struct CubePatches : MeshPatches {
  CubePatches() : MeshPatches(of(), "surface", Smoothing::None) {}
  static Mesh of() {
    BoxShape shape;
    shape.dimension = 3;
    shape.lower = {-1, -1, -1};
    shape.lengths = {2, 2, 2};
    shape.divisions = {3, 3, 3};
    return box(shape);
  }
};

}  // namespace ixos::test
