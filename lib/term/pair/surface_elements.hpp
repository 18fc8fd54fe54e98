/// Area elements at the quadrature points of a surface.
#pragma once
#include <array>
#include <vector>

#include "base/pack.hpp"
#include "geometry/surface_patches.hpp"

namespace ixos {

/// Each quadrature point has its place x and the vector a of its deformed area element, times the quadrature weight. In
/// space a = w x_,1 x x_,2 points outwards. In the plane a = w x_,1, which is the outward one turned by a right angle:
/// inner products of two of them are the same. Both are polynomials of the nodes' places.
template <std::size_t D>
class SurfaceElements {
 public:
  /// A D x D matrix, row by row.
  using Matrix = std::array<double, D * D>;
  struct Point {
    std::size_t patch;
    typename SurfacePatch<D>::Weights value;                      ///< N_b
    std::array<typename SurfacePatch<D>::Weights, D - 1> slopes;  ///< N_b,1 times the quadrature weight, N_b,2
  };
  /// All points at places of the nodes. Packs hold one component of points that follow each other; their last lanes
  /// have no area.
  struct Placed {
    std::vector<Vec<D>> place, area;
    std::vector<std::array<Vec<D>, D - 1>> tangents;  ///< the first with the quadrature weight
    std::array<std::vector<Pack>, D> places, areas;
  };

  /// `points`: per direction on each patch. The surface must outlive it.
  SurfaceElements(const SurfacePatches<D>& surface, int points);

  const SurfacePatches<D>& surface() const { return surface_; }
  const std::vector<Point>& points() const { return points_; }
  std::size_t points_of_a_patch() const { return per_patch_; }
  std::size_t packs() const;
  Placed at(const std::vector<Vec<D>>& nodes) const;
  /// Returns da/dx_b at a point of the placed surface, of each node b of its patch.
  std::vector<Matrix> area_slopes(const Placed& placed, std::size_t point) const;
  /// Returns, by node of the surface, the derivative of a function of x and a, whose derivatives by them these are at
  /// the points.
  std::vector<Vec<D>> at_nodes(const Placed& placed, const std::vector<Vec<D>>& by_place,
                               const std::vector<Vec<D>>& by_area) const;

 private:
  const SurfacePatches<D>& surface_;
  std::size_t per_patch_;
  std::vector<Point> points_;
};

/// Returns the matrix whose product with x is a x x.
std::array<double, 9> cross_matrix(const Vec<3>& a);

extern template class SurfaceElements<2>;
extern template class SurfaceElements<3>;

}  // namespace ixos
