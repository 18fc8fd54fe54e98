/// Parts of space, to select sides and nodes by their place.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// The intersection of all conditions that are given; without any, all of space. Every list has D coordinates, or is
/// empty. A point that is outside by no more than the tolerance counts as inside.
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
  double tolerance = 0;      ///< at least 0 [L0]; 0: place_tolerance() of the mesh
};

/// Returns how far a node of the mesh may be off the place that it stands for [L0]: a thousandth of the shortest edge
/// of the cells, corner to corner, but at least 1e-9 of the mesh's largest extent, where cells have edges of no length.
/// A file with 4-byte reals rounds coordinates by 6e-8 of their size, one with six digits by up to 5e-6 of it: less
/// than this if 16,000, or 200, of the shortest edges span the mesh. 0 for a mesh without cells.
double place_tolerance(const Mesh& mesh);

/// Returns the box around a mesh for messages: "(0, 0) to (2, 1)".
std::string span_in_words(const Mesh& mesh);

/// Tells which nodes and sides of a mesh lie in a region.
class Inside {
 public:
  /// Refers to the mesh, and keeps a copy of the region. Throws InputError, with the name of a scene's parameter, if a
  /// list has another number of coordinates than the mesh, a normal is zero, or the point of a plane or the centre of a
  /// sphere stands alone.
  Inside(const Mesh& mesh, const Region& region);

  /// Returns how far the node is outside of one of the region's conditions, of several the largest distance [L0]; 0 or
  /// less inside. Ignores `normal`.
  double excess(int node) const;
  /// Returns the largest one of the side's corners; infinity if its outward_normal() is too far from `normal`.
  double excess(const Side& side) const;
  double tolerance() const { return tolerance_; }
  /// Returns whether something so far outside may be meant to lie in the region: it is outside by no more than ten
  /// tolerances, and the tolerance is the mesh's. A user who gives a tolerance knows better.
  bool is_doubtful(double distance) const { return doubts_ && distance > tolerance_ && distance <= 10 * tolerance_; }
  /// Returns span_in_words() of the mesh.
  std::string span() const { return span_in_words(mesh_); }

 private:
  const Mesh& mesh_;
  Region region_;      ///< with points in place of empty ones, and normals of length 1
  double cosine_ = 0;  ///< the least one between a side's outward normal and `normal`
  double tolerance_ = 0;
  bool doubts_ = false;
};

}  // namespace ixos
