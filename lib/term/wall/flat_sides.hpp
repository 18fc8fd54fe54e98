/// Sides before a flat wall: from displacements to gaps, and from gaps' forces back.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "term/corner_matrices.hpp"
#include "term/galerkin_products.hpp"
#include "term/wall/sides_of.hpp"
#include "term/wall/surface_sides.hpp"

namespace ixos {

/// Nodal arrays of a batch of sides are gaps, or changes along the wall's normal. The gap at a quadrature point is
/// sum_a N_a g_a of the nodal gaps g_a, and the force is along the normal, so all quantities are scalar.
template <class SideElement>
class FlatSides final : public SurfaceSides<SideElement, FlatWallSides<SideElement::dimension + 1>> {
  using Base = SurfaceSides<SideElement, FlatWallSides<SideElement::dimension + 1>>;

 public:
  using Base::batches;
  using Base::D;
  using Base::N;
  using Base::quadrature;
  using Nodal = std::array<Pack, N>;

  FlatSides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, const HalfSpace& wall,
            int points)
      : Base(mesh, sides, pattern, points, wall) {
    double origin = 0;
    for (std::size_t d = 0; d < D; ++d) {
      origin += wall.point[d] * wall.normal[d];
      if (wall.normal[d] != 0) components_.push_back(d);
    }
    if (components_.empty()) components_.push_back(0);  // the normal is out of the plane
    for (std::size_t b = 0; b < this->size(); ++b) {
      reference_gap_.push_back(along_normal(this->reference(b)));
      // A derivative has no distance from the origin.
      for (std::size_t a = 0; a < Base::places; ++a) reference_gap_.back()[a] -= origin;
    }
  }

  /// Returns the gaps at displacement u, and the change of the gaps under a change of u.
  Nodal gaps_of(std::size_t b, const double* u) const {
    Nodal gap = change_of(b, u);
    for (std::size_t a = 0; a < N; ++a) gap[a] += reference_gap_[b][a];
    return gap;
  }
  Nodal change_of(std::size_t b, const double* local) const {
    Nodal change{}, component;
    for (const std::size_t d : components_) {
      batches().gather(b, local, d, component);
      for (std::size_t a = 0; a < N; ++a) change[a] += component[a] * this->wall_.normal[d];
    }
    return change;
  }

  /// Returns the vectors of that length along the normal.
  Small<Pack, N, D> from_normal(const Nodal& along) const {
    Small<Pack, N, D> result;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = along[a] * this->wall_.normal[d];
    return result;
  }
  /// Adds forces of that length along the normal to a local array.
  void scatter_along(std::size_t b, Nodal along, double* local) const {
    if (components_.size() > 1) return batches().scatter_force(b, from_normal(along), local);
    for (std::size_t a = 0; a < N; ++a) along[a] *= this->wall_.normal[components_[0]];
    batches().scatter_force(b, components_[0], along, local);
  }
  /// Sets a matrix on such vectors from the one on their lengths.
  template <std::size_t Nodes>
  void spread(const Small<Pack, Nodes>& along, Small<Pack, Nodes * D>& matrix) const {
    for (std::size_t r = 0; r < Nodes * D; ++r)
      for (std::size_t c = 0; c < Nodes * D; ++c)
        matrix[r][c] = along[r / D][c / D] * (this->wall_.normal[r % D] * this->wall_.normal[c % D]);
  }

  void gaps(std::size_t b, const double* u, Pack* r) const override { interpolate(gaps_of(b, u), r); }
  void gap_changes(std::size_t b, const double* local, Pack* r) const override { interpolate(change_of(b, local), r); }

  void add_forces(std::size_t b, const Pack* p, double* f) const override {
    Nodal along{};
    for (std::size_t q = 0; q < quadrature().size(); ++q) {
      const auto& shape = quadrature().value[q];
      for (std::size_t a = 0; a < N; ++a) along[a] += shape[a] * p[q];
    }
    scatter_along(b, along, f);
  }
  void add_tangent(std::size_t b, const Pack* k, double* values) const override {
    Small<Pack, N> along = along_normal(k);
    if (components_.size() > 1) {
      Small<Pack, N * D> tangent;
      spread(along, tangent);
      return batches().scatter_tangent(b, tangent, values);
    }
    const double square = this->wall_.normal[components_[0]] * this->wall_.normal[components_[0]];
    for (auto& row : along)
      for (Pack& entry : row) entry *= square;
    batches().scatter_tangent(b, components_[0], along, values);
  }
  void add_row_sums(std::size_t b, const Pack* k, double* sums) const override {
    Nodal rows{};
    for (std::size_t q = 0; q < quadrature().size(); ++q)
      for (std::size_t a = 0; a < N; ++a) rows[a] += std::abs(quadrature().value[q][a]) * k[q];
    // |n_i n_j| summed over j.
    double normal_sum = 0;
    for (std::size_t d = 0; d < D; ++d) normal_sum += std::abs(this->normal()[d]);
    Small<Pack, N, D> along;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) along[a][d] = rows[a] * (std::abs(this->normal()[d]) * normal_sum);
    batches().scatter_force(b, along, sums);
  }
  std::unique_ptr<SideMatrices<Pack>> create_matrices() const override { return std::make_unique<Kept>(*this); }

  LowestPoint lowest_gap(const double* u) const override {
    return this->lowest_point(
        u, [&](std::size_t b) { return [gap = gaps_of(b, u)](const auto& shape) { return interpolate(shape, gap); }; });
  }
  void lower_nodal_gaps(const double* u, double* by_node) const override {
    for (std::size_t b = 0; b < this->size(); ++b) this->lower_nodal(b, gaps_of(b, u), by_node);
  }
  void set_nodal_normals(double* local) const override {
    Nodal ones;
    ones.fill(1.0);
    for (std::size_t b = 0; b < this->size(); ++b) this->set_nodal(b, from_normal(ones), local);
  }

 private:
  Nodal along_normal(const Small<Pack, N, D>& vectors) const {
    Nodal result;
    for (std::size_t a = 0; a < N; ++a) {
      result[a] = vectors[a][0] * this->wall_.normal[0];
      for (std::size_t d = 1; d < D; ++d) result[a] += vectors[a][d] * this->wall_.normal[d];
    }
    return result;
  }

  static Pack interpolate(const std::array<double, N>& shape, const Nodal& nodal) {
    Pack sum = shape[0] * nodal[0];
    for (std::size_t a = 1; a < N; ++a) sum += shape[a] * nodal[a];
    return sum;
  }
  void interpolate(const Nodal& nodal, Pack* r) const {
    for (std::size_t q = 0; q < quadrature().size(); ++q) r[q] = interpolate(quadrature().value[q], nodal);
  }
  /// Returns the sum of N_a k N_c over the points of a batch.
  Small<Pack, N> along_normal(const Pack* k) const {
    Small<Pack, N> along{};
    for (std::size_t q = 0; q < quadrature().size(); ++q) {
      const auto& shape = quadrature().value[q];
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t c = 0; c < N; ++c) along[a][c] += (shape[a] * shape[c]) * k[q];
    }
    return along;
  }

  /// Keeps the matrix of each side along the normal.
  class Kept final : public SideMatrices<Pack> {
   public:
    explicit Kept(const FlatSides& sides) : sides_(sides), along_(sides.size()) {}

    void set(std::size_t b, const Pack* k) override { along_[b] = sides_.along_normal(k); }

    void add_product(const double* x, double* y) const override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        const Nodal change = sides_.change_of(b, x);
        Nodal force{};
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t c = 0; c < N; ++c) force[a] += along_[b][a][c] * change[c];
        sides_.scatter_along(b, force, y);
      }
    }

    void add_diagonal(double* d) const override {
      for (std::size_t b = 0; b < along_.size(); ++b) {
        Small<Pack, N, D> diagonal;
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i)
            diagonal[a][i] = along_[b][a][a] * (sides_.normal()[i] * sides_.normal()[i]);
        sides_.batches().scatter_diagonal(b, diagonal, d);
      }
    }

    void add_coarse(const CoarseSpace& coarse, double* values) const override {
      using Corners = typename CornerElement<SideElement>::type;
      if constexpr (is_linear_element<SideElement>) {
        add_galerkin_products(
            sides_.batches(), coarse, [this](std::size_t b) { return sides_.owned(b); },
            [&](std::size_t b, const Prolongation<N>& prolongation, auto& k) {
              sides_.spread(galerkin_product<N, 1>(prolongation, along_[b]), k);
            },
            values);
      } else if constexpr (std::is_void_v<Corners>) {
        if (!sides_.may_be_coarsened()) throw std::logic_error("enriched sides have no coarse space");
      } else {
        const auto set = [&](std::size_t b, auto& k) { sides_.spread(on_corners<SideElement>(along_[b]), k); };
        add_corner_matrices<Corners::nodes>(sides_.batches(), coarse, set, values);
      }
    }

   private:
    const FlatSides& sides_;
    std::vector<Small<Pack, N>> along_;
  };

  std::vector<std::size_t> components_;  ///< of the normal that are not 0: one along an axis, and at least one
  std::vector<Nodal> reference_gap_;
};

template <std::size_t D>
std::unique_ptr<FlatWallSides<D>> make_flat_sides(const LocalMesh& mesh, const SideGroup& group, const Pattern& pattern,
                                                  const HalfSpace& wall, int points) {
  return sides_of<D, FlatSides, FlatWallSides<D>>(group, mesh, group.sides, pattern, wall, points);
}

}  // namespace ixos
