/// The cells of a block, whatever their type.
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "discretization/pattern.hpp"
#include "element/cell_product.hpp"
#include "material/points.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

class CoarseSpace;

/// From local arrays to the displacement gradients at the quadrature points of a pack of cells, a batch, and back from
/// stresses and moduli to forces and matrices. All that knows a cell type stands behind this interface, so that terms
/// are compiled once for all types, and a cell type once for all terms. Arrays of points are those of a batch.
template <class Space>
class BodyCells {
 public:
  static constexpr std::size_t G = Space::G, C = Space::C;
  static constexpr std::size_t D = Space::is_ring ? 2 : G;  ///< components of a displacement
  using Gradient = Small<Pack, G>;
  using Moduli = Small<Pack, C>;
  /// Computes the moduli of `count` points from number `first` on.
  using ModuliOf = std::function<void(std::size_t first, std::size_t count, Moduli*)>;

  virtual ~BodyCells() = default;

  /// Returns the numbers of batches, of points of a batch, and of cells.
  std::size_t size() const { return owned_.size(); }
  std::size_t points() const { return points_; }
  /// Returns the reference coordinates of the points, see PointColumns.
  const std::vector<std::array<double, 3>>& places() const { return places_; }
  std::size_t cells() const { return cells_; }
  std::size_t lanes(std::size_t b) const { return std::min(width, cells_ - b * width); }
  /// Returns the number of a lane's cell in the block.
  static std::size_t number(std::size_t b, std::size_t lane) { return b * width + lane; }
  /// Returns quadrature weight times reference volume [L0^D].
  const Pack& weight(std::size_t b, std::size_t q) const { return weights_[b * points_ + q]; }
  const Pack* weights(std::size_t b) const { return &weights_[b * points_]; }
  /// Returns 1 for cells whose energy counts on this rank, else 0.
  const Pack& owned(std::size_t b) const { return owned_[b]; }
  /// Returns whether the points are those of Mass.
  bool has_default_points() const { return has_default_points_; }

  /// Finds the places of the cells' entries in a pattern that has changed.
  virtual void place(const Pattern& pattern) = 0;

  /// Computes the gradients of a local array, or of the change from one to another, which loses no digits if it is
  /// small.
  virtual void gradients(std::size_t b, const double* local, Gradient* h) const = 0;
  virtual void gradients_of_change(std::size_t b, const double* from, const double* to, Gradient* h) const = 0;
  /// Adds the forces of stresses to a local array; spoils `p`.
  virtual void add_forces(std::size_t b, Gradient* p, double* f) const = 0;
  /// Adds the tangent of moduli to matrix values. `symmetric`: they are.
  virtual void add_tangent(std::size_t b, bool symmetric, const ModuliOf& moduli, double* values) const = 0;
  /// Does the same with the moduli in the deformed body, times a factor. In three dimensions only.
  virtual void add_spatial_tangent(
      std::size_t b, double factor,
      const std::function<void(std::size_t first, std::size_t count, SpatialState<Pack, G>*)>& states,
      double* values) const = 0;
  /// Add to local arrays the sums of the magnitudes of the rows of symmetric moduli's tangent, and its diagonal.
  virtual void add_row_sums(std::size_t b, const ModuliOf& moduli, double* sums) const = 0;
  virtual void add_diagonal(std::size_t b, const ModuliOf& moduli, double* diagonal) const = 0;

  /// Return the points in space for products, see PointProduct. These functions are for plane and solid bodies.
  virtual const SpacePoint<Pack, D>* space_points(std::size_t b) const = 0;
  /// Add products with all batches' data, `size` numbers a batch, to local arrays; see TangentAction.
  virtual void add_product(const PointProduct<D>& product, const NarrowPack* data, std::size_t size, const double* x,
                           double* y) const = 0;
  virtual void add_rough_product(const PointProduct<D>& product, const NarrowPack* data, std::size_t size,
                                 const double* x, double* y) const = 0;
  virtual void add_diagonal_of(const PointProduct<D>& product, const NarrowPack* data, std::size_t size,
                               double* d) const = 0;
  virtual bool has_coarse() const = 0;
  virtual void add_coarse(const PointProduct<D>& product, const NarrowPack* data, std::size_t size,
                          const CoarseSpace& coarse, double* values) const = 0;

 protected:
  static constexpr auto width = static_cast<std::size_t>(pack_width);

  std::size_t cells_ = 0, points_ = 0;
  bool has_default_points_ = false;
  std::vector<Pack> weights_, owned_;
  std::vector<std::array<double, 3>> places_;
};

/// Returns the cells of one block; `points` as for make_elastic_term(). A separate file defines each.
std::unique_ptr<BodyCells<PlaneSpace>> make_body_cells(PlaneSpace, const LocalMesh& mesh, const LocalBlock& block,
                                                       const Pattern& pattern, int points);
std::unique_ptr<BodyCells<SolidSpace>> make_body_cells(SolidSpace, const LocalMesh& mesh, const LocalBlock& block,
                                                       const Pattern& pattern, int points);
std::unique_ptr<BodyCells<RingSpace>> make_body_cells(RingSpace, const LocalMesh& mesh, const LocalBlock& block,
                                                      const Pattern& pattern, int points);

/// Calls function(Space{}) for the space of a mesh's bodies.
template <class Function>
decltype(auto) in_space_of(const LocalMesh& mesh, const Function& function) {
  if (mesh.axisymmetric) return function(RingSpace{});
  if (mesh.dimension == 2) return function(PlaneSpace{});
  return function(SolidSpace{});
}

}  // namespace ixos
