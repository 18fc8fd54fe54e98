/// Sides of cells, and edges of sides, as surfaces and curves of their own.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "mesh/mortar/polygon.hpp"

namespace ixos {

/// A plane onto which facets are projected along its normal; of a curve, the line along the first axis.
struct ProjectionPlane {
  Vec<3> origin{};
  std::array<Vec<3>, 2> axes{};  ///< orthogonal, of length 1
  Vec<2> image(const Vec<3>& x) const { return {inner(x - origin, axes[0]), inner(x - origin, axes[1])}; }
};

/// A side of a plain cell, or an edge of such a side: its nodes and their shape functions.
class Facet {
 public:
  Facet(const Mesh& mesh, const Side& side);

  const std::vector<int>& nodes() const { return nodes_; }
  /// Returns the nodes' places [L0].
  const std::vector<Vec<3>>& places() const { return places_; }
  int dimension() const { return dimension_; }
  /// Returns the number of corners; they are the first nodes.
  std::size_t corners() const { return corners_; }
  /// Returns the degree of the shape functions as polynomials of the reference coordinates.
  int degree() const;
  /// Returns whether the integrals of all shape functions are positive, so that they have dual ones: all but those of
  /// triangles with six nodes, whose corners have none.
  bool has_dual_functions() const { return !is_triangle() || nodes_.size() != 6; }
  /// Returns the mean of the corners.
  Vec<3> middle() const;
  /// Returns the longest distance between two corners [L0].
  double size() const;
  /// Returns the outward normal of a side between the corners, of length 1; of an edge of a side, 0.
  const Vec<3>& normal() const { return normal_; }
  /// Returns the plane through the middle across the normal, of an edge the line between its ends.
  ProjectionPlane plane() const;
  /// Returns whether the shape functions are polynomials of the place: the facet is a line or a parallelogram, with its
  /// further nodes in the middles.
  bool is_affine() const;
  /// Returns the edges of a side of two dimensions.
  std::vector<Facet> edges() const;

  /// Returns the convex parts of the image: one of a curve or a linear side, those between the nodes of a quadratic
  /// one, whose curved edges become chords.
  std::vector<Polygon> images(const ProjectionPlane& plane) const;
  /// Returns the reference coordinates of the point with that image (Newton's method); nothing if there is none nearby.
  std::optional<Vec<2>> find(const ProjectionPlane& plane, const Vec<2>& image) const;
  /// Returns the values of the nodes' shape functions.
  std::vector<double> values(const Vec<2>& xi) const { return shape(xi).value; }
  /// Returns the place of a point [L0].
  Vec<3> point(const Vec<2>& xi) const;

 private:
  Facet() = default;
  struct Shape {
    std::vector<double> value;
    std::vector<Vec<2>> gradient;
  };
  Shape shape(const Vec<2>& xi) const;
  bool is_triangle() const { return corners_ == 3; }
  /// Returns the reference coordinates from which Newton's method starts.
  Vec<2> start() const { return is_triangle() ? Vec<2>{1.0 / 3, 1.0 / 3} : Vec<2>{}; }

  int dimension_ = 1;
  std::size_t corners_ = 2;
  int order_ = 1;  ///< of the cell
  std::vector<int> nodes_;
  std::vector<Vec<3>> places_;
  Vec<3> normal_{};
};

/// Returns the edges that one of the sides alone has.
std::vector<Facet> boundary_edges(const std::vector<Facet>& sides);

/// A node and its place.
struct FacetEnd {
  int node;
  Vec<3> place;
};

/// Returns the ends of curves, and the nodes in which they turn by more than 30 degrees.
std::vector<FacetEnd> curve_ends(const std::vector<Facet>& curves);

}  // namespace ixos
