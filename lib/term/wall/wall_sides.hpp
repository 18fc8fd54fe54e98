/// The sides of a surface before an obstacle, whatever their type.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "discretization/pattern.hpp"
#include "interaction/half_space.hpp"
#include "interaction/obstacle.hpp"
#include "mesh/local_mesh.hpp"
#include "term/interaction.hpp"

namespace ixos {

class CoarseSpace;

/// The matrices of all sides, applied without the matrix of the whole. `K`: what a quadrature point has.
template <class K>
class SideMatrices {
 public:
  virtual ~SideMatrices() = default;
  /// Sets the matrix of a batch to the sum of N_a k N_c over its points.
  virtual void set(std::size_t b, const K* k) = 0;
  /// Add the product with x to y, and the diagonal to d; both are local arrays.
  virtual void add_product(const double* x, double* y) const = 0;
  virtual void add_diagonal(double* d) const = 0;
  /// Adds P^T K P, see TangentAction::add_coarse(). Throws std::logic_error unless the sides' may_be_coarsened().
  virtual void add_coarse(const CoarseSpace& coarse, double* values) const = 0;
};

/// Sides in packs, the batches, with quadrature points. All that knows a type of sides stands behind this interface and
/// the two below, so that terms are compiled once for all types, and a type once for all terms. Arrays of points are
/// those of one batch.
template <std::size_t Dim>
class WallSides {
 public:
  static constexpr std::size_t D = Dim;
  using Matrix = Small<Pack, D>;

  virtual ~WallSides() = default;

  /// Returns the numbers of batches, and of quadrature points of a side.
  std::size_t size() const { return owned_.size(); }
  std::size_t points() const { return total_shape_.size(); }
  /// Returns the reference coordinates of the points along a side, see PointColumns.
  const std::vector<std::array<double, 3>>& reference_places() const { return places_; }
  /// Returns the number of sides of a batch.
  std::size_t lanes(std::size_t b) const { return std::min(width, sides_ - b * width); }
  /// Returns 1 for sides that count on this rank, otherwise 0.
  const Pack& owned(std::size_t b) const { return owned_[b]; }
  /// Returns quadrature weight times reference length or area, by quadrature point, for integrals of the law: of an
  /// axisymmetric mesh the area of the ring; times the factor if there is one.
  const Pack* measure(std::size_t b) const { return &measure_[b * points()]; }
  /// Returns it without the factor.
  const Pack* area(std::size_t b) const { return area_.empty() ? measure(b) : &area_[b * points()]; }
  /// Returns the sum of the magnitudes of the shape functions at a quadrature point.
  double total_shape(std::size_t q) const { return total_shape_[q]; }

  /// Finds the places of the sides' entries in a pattern that has changed.
  virtual void place(const Pattern& pattern) = 0;
  /// Multiplies the measure by the factor at each quadrature point. Called at most once.
  virtual void scale(const SurfaceFactor& factor) = 0;
  /// Returns whether coarser sides may stand for these, see has_coarser_element; true without sides.
  virtual bool may_be_coarsened() const = 0;
  /// Adds numbers of a batch's points to the nodes, with the weights of nodal means.
  virtual void add_weighted_nodal(std::size_t b, const Pack* values, double* by_node) const = 0;
  /// Adds, per local node, the integrals of these weights over the sides that are not counted yet, and counts them.
  virtual void add_nodal_measure(CountedSides& counted, double* measure_by_node) const = 0;

 protected:
  static constexpr auto width = static_cast<std::size_t>(pack_width);

  std::size_t sides_ = 0;
  std::vector<Pack> owned_;
  std::vector<Pack> measure_;        ///< batches x quadrature points
  std::vector<Pack> area_;           ///< the measure without the factor; empty if there is none
  std::vector<double> total_shape_;  ///< by quadrature point
  std::vector<std::array<double, 3>> places_;
};

/// Sides before a flat wall, where gaps are linear in the displacement and forces have the direction of its normal.
template <std::size_t D>
class FlatWallSides : public WallSides<D> {
 public:
  using Matrices = SideMatrices<Pack>;

  const std::array<double, 3>& normal() const { return wall_.normal; }

  /// Compute the points' gaps at displacement u, and the change of the gaps under a change of u.
  virtual void gaps(std::size_t b, const double* u, Pack* r) const = 0;
  virtual void gap_changes(std::size_t b, const double* local, Pack* r) const = 0;
  /// Adds the forces N_a p n of the points' p to a local array.
  virtual void add_forces(std::size_t b, const Pack* p, double* f) const = 0;
  /// Adds the sum of N_a k N_c n n^T to matrix values.
  virtual void add_tangent(std::size_t b, const Pack* k, double* values) const = 0;
  /// Adds the sum of |N_a| k |n_i| |n|_1 to a local array, with numbers k that are not negative.
  virtual void add_row_sums(std::size_t b, const Pack* k, double* sums) const = 0;
  virtual std::unique_ptr<Matrices> create_matrices() const = 0;
  /// See Admissibility::lowest_point() and SurfaceReport.
  virtual LowestPoint lowest_gap(const double* u) const = 0;
  virtual void lower_nodal_gaps(const double* u, double* by_node) const = 0;
  virtual void set_nodal_normals(double* local) const = 0;

 protected:
  explicit FlatWallSides(const HalfSpace& wall) : wall_(wall) {}

  HalfSpace wall_;
};

/// Sides before an obstacle of any shape.
template <std::size_t D>
class CurvedWallSides : public WallSides<D> {
 public:
  using typename WallSides<D>::Matrix;
  using Matrices = SideMatrices<Matrix>;

  /// Compute the points' places at displacement u, and their changes under a change of u.
  virtual void places(std::size_t b, const double* u, PackPoint* x) const = 0;
  virtual void changes(std::size_t b, const double* local, PackPoint* x) const = 0;
  /// Adds the forces N_a t of the points' vectors t to a local array.
  virtual void add_forces(std::size_t b, const PackPoint* t, double* f) const = 0;
  /// Adds the sum of N_a k N_c to matrix values.
  virtual void add_tangent(std::size_t b, const Matrix* k, double* values) const = 0;
  /// Adds the sum of |N_a| t to a local array, with numbers t that are not negative.
  virtual void add_row_sums(std::size_t b, const PackPoint* t, double* sums) const = 0;
  virtual std::unique_ptr<Matrices> create_matrices() const = 0;
  /// Returns the square of the longest way of a batch's nodes between two displacements.
  virtual Pack longest_way_square(std::size_t b, const double* from, const double* to) const = 0;
  /// See Admissibility::lowest_point() and SurfaceReport. `obstacle_gap`: gap and normal, and second derivatives for
  /// gaps.
  using GapOf = std::function<ObstacleGap(const PackPoint&)>;
  virtual LowestPoint lowest_gap(const double* u, const std::function<Pack(const PackPoint&)>& gap_of) const = 0;
  virtual void lower_nodal_gaps(const double* u, const GapOf& obstacle_gap, double* by_node) const = 0;
  virtual void set_nodal_normals(const double* u, const GapOf& obstacle_gap, double* local) const = 0;
};

/// Sides of one type of element and choice of tied edges: those that a set has, or a kind of a block that it may have.
struct SideGroup {
  CellType type;
  int side;
  std::vector<LocalSide> sides;
};

/// A side of the cells of a block.
struct SideKind {
  int block;
  int side;
};

/// Returns the groups of the sides and of the kinds: a set may hold enriched sides beside plain ones. Without
/// sides and kinds, returns one empty group, because the functions that a model calls if it has a term are collective.
std::vector<SideGroup> grouped(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                               const std::vector<SideKind>& kinds = {});

/// Make the sides of a group in the plane or in space; `points` as for SurfaceOptions. They compile apart, as
/// flat_sides_plane.cpp and the like.
template <std::size_t D>
std::unique_ptr<FlatWallSides<D>> make_flat_sides(const LocalMesh& mesh, const SideGroup& group, const Pattern& pattern,
                                                  const HalfSpace& wall, int points);
template <std::size_t D>
std::unique_ptr<CurvedWallSides<D>> make_curved_sides(const LocalMesh& mesh, const SideGroup& group,
                                                      const Pattern& pattern, int points);

}  // namespace ixos
