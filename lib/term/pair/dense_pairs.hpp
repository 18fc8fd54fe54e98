/// The sum over all pairs of area elements of two surfaces.
#pragma once
#include <vector>

#include "geometry/pair_search.hpp"
#include "interaction/pair_kernel.hpp"
#include "term/force_term.hpp"
#include "term/pair/surface_elements.hpp"

namespace ixos {

/// E = sum over pairs of points of (a1 . a2) W(r), r their distance, with its derivatives by the nodes' places: those
/// of the secondary, then those of the primary surface. `acts`: by secondary patch, whether its points count.
template <std::size_t D>
class DensePairs {
 public:
  /// `points`: per direction on each side, 0 for the default. The surfaces must outlive it.
  DensePairs(const PairSurfaces<D>& surfaces, const PairKernel<D>& kernel, int points)
      : kernel_(kernel),
        first_(surfaces.secondary, surfaces.secondary.points_along(points)),
        second_(surfaces.primary, surfaces.primary.points_along(points)) {}

  double energy(const PairPlaces<D>& places, const std::vector<char>& acts) const;
  /// Returns the force on the secondary surface, minus the derivative by a common motion of its points.
  Vec<D> force(const PairPlaces<D>& places, const std::vector<char>& acts) const;
  /// Returns dE/dx by node.
  std::vector<Vec<D>> gradient(const PairPlaces<D>& places, const std::vector<char>& acts) const;
  /// Adds the factor times the second derivatives to a square matrix, row by row. Convex: of each pair of points only
  /// the stiffness along the line between them, if it is positive.
  void add_hessian(const PairPlaces<D>& places, const std::vector<char>& acts, Tangent kind, double factor,
                   std::vector<double>& matrix) const;

 private:
  using Placed = typename SurfaceElements<D>::Placed;
  using Matrix = typename SurfaceElements<D>::Matrix;
  /// By point: dE/dx, dE/da, and the sums over the other surface of d2E/dx dx and d2E/dx da.
  struct Sums {
    std::vector<Vec<D>> by_place, by_area;
    std::vector<Matrix> places, mixed;
    explicit Sums(std::size_t points)
        : by_place(points, Vec<D>{}), by_area(points, Vec<D>{}), places(points, Matrix{}), mixed(points, Matrix{}) {}
  };
  struct Gradient {
    std::vector<Vec<D>> place1, area1, place2, area2;  ///< by point
  };
  Gradient at_points(const Placed& first, const Placed& second, const std::vector<char>& acts) const;
  /// Adds the second derivatives among the nodes of one surface, whose first one has the number `start`.
  void add_own(const SurfaceElements<D>& surface, const Placed& placed, const Sums& sums, double factor,
               std::size_t start, std::vector<double>& matrix) const;

  PairKernel<D> kernel_;
  SurfaceElements<D> first_, second_;
};

extern template class DensePairs<2>;
extern template class DensePairs<3>;

}  // namespace ixos
