/// Parts of space, to select sides and nodes by their place.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// The intersection of all conditions that are given; without any, all of space. Every list has D coordinates, or is
/// empty. Points on a boundary count as inside, to 1e-9 of the mesh's size.
struct Region {
  std::vector<double> lower{};          ///< an axis-parallel box: its least coordinates [L0]; empty: no bound
  std::vector<double> upper{};          ///< its largest coordinates [L0]; empty: no bound
  std::vector<double> plane_normal{};   ///< a plane: its normal, of any length; empty: no plane
  std::vector<double> plane_point{};    ///< a point of the plane [L0]; empty: the origin
  double sphere_radius = 0;             ///< a ball (2D: a disk): its radius [L0]; 0: no ball
  std::vector<double> sphere_center{};  ///< its centre [L0]; empty: the origin
  /// Sides only: the direction in which they look, of any length; empty: any.
  std::vector<double> normal{};
  double normal_angle = 30;  ///< the largest angle between a side's outward normal and `normal` [degrees]
};

/// Tells which nodes and sides of a mesh lie in a region.
class Inside {
 public:
  /// Refers to the mesh, and keeps a copy of the region. Throws InputError, with the name of a scene's parameter, if a
  /// list has another number of coordinates than the mesh, a normal is zero, or the point of a plane or the centre of a
  /// sphere stands alone.
  Inside(const Mesh& mesh, const Region& region);

  /// Tests the place of the node; ignores `normal`.
  bool node(int node) const;
  /// Tests the places of the side's corners, and its outward normal: in 3D that of its diagonals.
  bool side(const Side& side) const;
  /// Returns the bounding box of the mesh, for messages.
  std::string span() const;

 private:
  const Mesh& mesh_;
  Region region_;      ///< with points in place of empty ones, and normals of length 1
  double cosine_ = 0;  ///< the least one between a side's outward normal and `normal`
  double slack_ = 0;
};

}  // namespace ixos
