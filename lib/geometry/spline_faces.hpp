/// Splines over the four-sided faces of a surface in space.
#pragma once
#include <array>
#include <vector>

#include "geometry/face_patches.hpp"
#include "mesh/side_grid.hpp"

namespace ixos {

/// Patches of a bicubic spline near the nodes of a surface. Its control points are v - a sum of (e - v) over the nodes
/// e at the edges of a node v, a = (6 + 2 cos(2 pi/n))/(n (n + 5)) where n faces meet: on even grids, where a = 1/6,
/// the spline approximates a smooth surface through the nodes to fourth order in their distance (de Boor and Fix 1973).
/// Where four faces meet in each corner of a face and of its neighbours, tangents and curvatures are continuous.
/// Elsewhere the patches are those of Loop and Schaefer (2008): continuous, with a tangent plane that jumps along edges
/// from nodes where other than four faces meet. Creases and rims are splines of their nodes in the plane, see
/// spline_patch().
class SplineFaces {
 public:
  /// The grid must outlive it.
  explicit SplineFaces(const SideGrid& grid);

  /// Returns the control points of a face in the form of Bezier, as bezier_patch() takes them.
  std::array<NodeWeights, 16> controls(int face) const;

 private:
  struct Vertex {
    std::vector<int> faces;
    std::vector<int> ends;     ///< of its edges
    std::vector<int> creases;  ///< the ends of creases and rims among them
    bool goes_on = false;      ///< there are two creases, which continue each other
  };
  NodeWeights control_of(int node) const;
  std::size_t valence(int face, int node) const;
  std::array<int, 2> ends(int face, int node) const;
  void add_inner(int face, int node, double factor, NodeWeights& sum) const;
  NodeWeights edge(int face, int node, int end) const;
  NodeWeights corner(int node) const;

  const SideGrid& grid_;
  std::vector<Vertex> vertices_;
  std::vector<NodeWeights> controls_;  ///< by node: of the spline
};

}  // namespace ixos
