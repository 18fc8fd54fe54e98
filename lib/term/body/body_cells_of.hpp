/// BodyCells of one cell type; included only where they are made.
#pragma once
#include "term/body/body_cells.hpp"

#include <stdexcept>
#include <type_traits>

#include "element/cell_kernel.hpp"
#include "fem/corner_element.hpp"
#include "term/body/block_cells.hpp"
#include "term/corner_matrices.hpp"
#include "term/galerkin_products.hpp"

namespace ixos {

template <class Element>
class BodyCellsOf final : public BodyCells<SpaceOf<Element>> {
  using Base = BodyCells<SpaceOf<Element>>;
  using Kernel = CellKernel<Element>;
  static constexpr std::size_t N = Kernel::N;
  using Base::C;
  using Base::D;
  using Base::G;
  using typename Base::Gradient;
  using typename Base::Moduli;
  using typename Base::ModuliOf;
  using Cells = BlockCells<Kernel>;
  using Nodal = typename Cells::Nodal;
  using CellTangent = typename Cells::CellTangent;

 public:
  BodyCellsOf(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern, int points)
      : cells_of_(mesh, block, pattern, points) {
    this->cells_ = cells_of_.batches.cells();
    this->points_ = cells_of_.table.size();
    this->has_default_points_ = cell_rule<Element>(block, points) == mass_rule<Element>();
    this->places_ = places_of(cell_rule<Element>(block, points));
    this->owned_ = cells_of_.owned;
    for (const auto& geometry : cells_of_.geometry)
      for (const auto& point : geometry.points) this->weights_.push_back(point.weight);
  }

  void place(const Pattern& pattern) override { cells_of_.batches.place(pattern); }

  void gradients(std::size_t b, const double* local, Gradient* h) const override {
    gradients_of(b, cells_of_.gathered(b, local), h);
  }
  void gradients_of_change(std::size_t b, const double* from, const double* to, Gradient* h) const override {
    const Nodal start = cells_of_.gathered(b, from);
    Nodal change = cells_of_.gathered(b, to);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) change[a][i] -= start[a][i];
    gradients_of(b, change, h);
  }
  void add_forces(std::size_t b, Gradient* p, double* f) const override {
    const auto& geometry = cells_of_.geometry[b];
    Nodal force{};
    Kernel::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      Kernel::add_forces(geometry, first, count, p + first, force);
    });
    cells_of_.batches.scatter_force(b, force, f);
  }

  void add_tangent(std::size_t b, bool symmetric, const ModuliOf& moduli, double* values) const override {
    CellTangent tangent{};
    add_moduli(b, symmetric, moduli, tangent);
    cells_of_.batches.scatter_tangent(b, tangent, values);
  }
  void add_spatial_tangent(std::size_t b, double factor,
                           const std::function<void(std::size_t, std::size_t, SpatialState<Pack, G>*)>& states,
                           double* values) const override {
    if constexpr (D == 3) {
      CellTangent tangent{};
      Kernel::add_spatial_tangent(cells_of_.geometry[b], 0, this->points_, factor, states, tangent);
      cells_of_.batches.scatter_tangent(b, tangent, values);
    } else {
      throw std::logic_error("moduli in the deformed body are for three dimensions");
    }
  }
  void add_row_sums(std::size_t b, const ModuliOf& moduli, double* sums) const override {
    CellTangent tangent{};
    add_moduli(b, true, moduli, tangent);
    cells_of_.scatter_row_sums(b, tangent, sums);
  }
  void add_diagonal(std::size_t b, const ModuliOf& moduli, double* diagonal) const override {
    CellTangent tangent{};
    add_moduli(b, true, moduli, tangent);
    cells_of_.scatter_diagonal(b, tangent, diagonal);
  }

  const SpacePoint<Pack, D>* space_points([[maybe_unused]] std::size_t b) const override {
    if constexpr (!Kernel::revolved) return cells_of_.geometry[b].points.data();
    refuse_product();
  }

  void add_product(const PointProduct<D>& product, const NarrowPack* data, std::size_t size, const double* x,
                   double* y) const override {
    if constexpr (!Kernel::revolved) {
      PointScratch<D, Pack> scratch(this->points_);
      for (std::size_t b = 0; b < this->size(); ++b) {
        Nodal u, f{};
        cells_of_.batches.gather(b, x, u);
        multiply(product, data + b * size, u, scratch, f);
        cells_of_.batches.scatter_force(b, f, y);
      }
    } else {
      refuse_product();
    }
  }

  /// Nodal values are differences in a cell, so the shape functions must have the sum 1. Enriched cells may have
  /// others.
  void add_rough_product(const PointProduct<D>& product, const NarrowPack* data, std::size_t size, const double* x,
                         double* y) const override {
    if constexpr (std::is_same_v<Element, typename CellTraits<Element>::Plain>) {
      if (!cells_of_.batches.scaled()) return add_single_product(product, data, size, x, y);
    }
    add_product(product, data, size, x, y);
  }

  void add_diagonal_of(const PointProduct<D>& product, const NarrowPack* data, std::size_t size,
                       double* d) const override {
    if constexpr (!Kernel::revolved) {
      for (std::size_t b = 0; b < this->size(); ++b) {
        Nodal diagonal{};
        ixos::add_diagonal(cells_of_.table, product, data + b * size, diagonal);
        cells_of_.batches.scatter_diagonal(b, diagonal, d);
      }
    } else {
      refuse_product();
    }
  }

  bool has_coarse() const override { return has_coarser_element<Element>; }

  /// The kept data are in reference coordinates, so they serve linear cells with the same points. The matrix of a cell
  /// is found column by column.
  void add_coarse(const PointProduct<D>& product, const NarrowPack* data, std::size_t size, const CoarseSpace& coarse,
                  double* values) const override {
    using Corners = typename CornerElement<Element>::type;
    if constexpr (Kernel::revolved) {
      refuse_product();
    } else if constexpr (is_linear_element<Element>) {
      add_to_coarse_cells(product, data, size, coarse, values);
    } else if constexpr (std::is_void_v<Corners>) {
      if (this->size() > 0) throw std::logic_error("a term has no Galerkin product on linear cells");
    } else {
      constexpr std::size_t corners = Corners::nodes;
      const ShapeTable<Corners> table(cells_of_.table);
      PointScratch<D, Pack> scratch(table.size());
      const auto set_matrix = [&](std::size_t b, Small<Pack, corners * D>& k) {
        for (std::size_t column = 0; column < corners * D; ++column) {
          Small<Pack, corners, D> u{}, f{};
          u[column / D][column % D] = 1.0;
          ixos::add_product(table, product, data + b * size, u, scratch, f);
          for (std::size_t row = 0; row < corners * D; ++row) k[row][column] = f[row / D][row % D];
        }
      };
      add_corner_matrices<corners>(cells_of_.batches, coarse, set_matrix, values);
    }
  }

 private:
  void gradients_of(std::size_t b, const Nodal& u, Gradient* h) const {
    const auto& geometry = cells_of_.geometry[b];
    Kernel::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      Kernel::gradients(geometry, first, count, u, h + first);
    });
  }
  void add_moduli(std::size_t b, bool symmetric, const ModuliOf& moduli, CellTangent& tangent) const {
    Kernel::add_tangent_of(cells_of_.geometry[b], 0, this->points_, symmetric, moduli, tangent);
  }

  [[noreturn]] static void refuse_product() { throw std::logic_error("rings have no product without a matrix"); }
  template <class T>
  void multiply(const PointProduct<D>& product, const NarrowPack* data, const Small<T, N, D>& u,
                PointScratch<D, T>& scratch, Small<T, N, D>& f) const {
    ixos::add_product(cells_of_.table, product, data, u, scratch, f);
  }

  void add_single_product(const PointProduct<D>& product, const NarrowPack* data, std::size_t size, const double* x,
                          double* y) const {
    PointScratch<D, NarrowPack> scratch(this->points_);
    for (std::size_t b = 0; b < this->size(); ++b) {
      Small<NarrowPack, N, D> u, f{};
      cells_of_.batches.gather_differences(b, x, u, scratch.origin);
      multiply(product, data + b * size, u, scratch, f);
      Nodal force;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) force[a][i] = widen<Pack>(f[a][i]);
      cells_of_.batches.scatter_force(b, force, y);
    }
  }

  /// Adds P^T k P of each cell, column by column.
  void add_to_coarse_cells(const PointProduct<D>& product, const NarrowPack* data, std::size_t size,
                           const CoarseSpace& coarse, double* values) const {
    PointScratch<D, Pack> scratch(this->points_);
    const auto set_matrix = [&](std::size_t b, const Prolongation<N>& prolongation, Small<Pack, N * D>& k) {
      for (std::size_t column = 0; column < N * D; ++column) {
        Nodal u{}, f{};
        for (std::size_t a = 0; a < N; ++a) u[a][column % D] = prolongation[a][column / D];
        multiply(product, data + b * size, u, scratch, f);
        for (std::size_t p = 0; p < N; ++p)
          for (std::size_t i = 0; i < D; ++i) {
            Pack sum = 0.0;
            for (std::size_t a = 0; a < N; ++a) sum += prolongation[a][p] * f[a][i];
            k[p * D + i][column] = sum;
          }
      }
    };
    add_galerkin_products(
        cells_of_.batches, coarse, [this](std::size_t b) { return cells_of_.owned[b]; }, set_matrix, values);
  }

  Cells cells_of_;
};

}  // namespace ixos
