/// A tangent applied without a matrix, from what a kernel keeps at the quadrature points.
#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "term/body/block_cells.hpp"
#include "term/child_matrices.hpp"
#include "term/corner_matrices.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// The part that terms have in common: a term derives from it and fills the data in its linearize(). `Kept` computes
/// with the data of a batch, see ElasticAction and ModuliAction. They are kept in single precision. The cells must
/// outlive the action.
template <class Kept, class Kernel>
class KeptAction : public TangentAction {
  using Cells = BlockCells<Kernel>;
  using Nodal = typename Cells::Nodal;
  using Layout = typename Kept::Layout;

 public:
  void add_product(const double* x, double* y) const override {
    typename Kept::template Scratch<Pack> scratch(cells_.table.size());
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Nodal u, f{};
      cells_.batches.gather(b, x, u);
      Kept::add_product(cells_.table, layout_, &data_[b * size_], u, scratch, f);
      cells_.batches.scatter_force(b, f, y);
    }
  }

  /// Nodal values are differences in a cell, so the shape functions must have the sum 1. Enriched cells may have
  /// others.
  void add_rough_product(const double* x, double* y) const override {
    using Shape = typename Kernel::Shape;
    if constexpr (is_linear_element<Shape> || std::is_same_v<Shape, Quad9> || std::is_same_v<Shape, Hex27>) {
      if (!cells_.batches.scaled()) return add_single_product(x, y);
    }
    add_product(x, y);
  }

  void add_diagonal(double* d) const override {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Nodal diagonal{};
      Kept::add_diagonal(cells_.table, layout_, &data_[b * size_], diagonal);
      cells_.batches.scatter_diagonal(b, diagonal, d);
    }
  }

  bool has_coarse() const override { return has_coarser_element<typename Kernel::Shape>; }

  /// The kept data are in reference coordinates, so they serve linear cells with the same points. The matrix of a cell
  /// is found column by column.
  void add_coarse(const CoarseSpace& coarse, double* values) const override {
    using Corners = typename CornerElement<typename Kernel::Shape>::type;
    if constexpr (is_linear_element<typename Kernel::Shape>) {
      add_to_parents(coarse, values);
    } else if constexpr (std::is_void_v<Corners>) {
      if (cells_.size() > 0) TangentAction::add_coarse(coarse, values);
    } else {
      using Linear = typename Kept::template On<Corners>;
      constexpr std::size_t C = Corners::nodes, D = Kernel::D;
      const ShapeTable<Corners> table(cells_.table);
      typename Linear::template Scratch<Pack> scratch(table.size());
      const auto set_matrix = [&](std::size_t b, Small<Pack, C * D>& k) {
        for (std::size_t column = 0; column < C * D; ++column) {
          Small<Pack, C, D> u{}, f{};
          u[column / D][column % D] = 1.0;
          Linear::add_product(table, layout_, &data_[b * size_], u, scratch, f);
          for (std::size_t row = 0; row < C * D; ++row) k[row][column] = f[row / D][row % D];
        }
      };
      add_corner_matrices<C>(cells_.batches, coarse, set_matrix, values);
    }
  }

 protected:
  explicit KeptAction(const Cells& cells) : cells_(cells) {}

  /// Calls linearize(batch, data), which fills the data of each batch.
  template <class Linearize>
  void keep(const Layout& layout, const Linearize& linearize) {
    layout_ = layout;
    size_ = cells_.table.size() * layout_.point_size();
    data_.resize(size_ * cells_.size());
    for (std::size_t b = 0; b < cells_.size(); ++b) linearize(b, &data_[b * size_]);
  }

 private:
  void add_single_product(const double* x, double* y) const {
    typename Kept::template Scratch<NarrowPack> scratch(cells_.table.size());
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Small<NarrowPack, Kernel::N, Kernel::D> u, f{};
      cells_.batches.gather_differences(b, x, u, scratch.origin);
      Kept::add_product(cells_.table, layout_, &data_[b * size_], u, scratch, f);
      Nodal force;
      for (std::size_t a = 0; a < f.size(); ++a)
        for (std::size_t i = 0; i < f[a].size(); ++i) force[a][i] = widen<Pack>(f[a][i]);
      cells_.batches.scatter_force(b, force, y);
    }
  }

  /// Adds S^T k S of each cell, column by column.
  void add_to_parents(const CoarseSpace& coarse, double* values) const {
    constexpr std::size_t N = Kernel::N, D = Kernel::D;
    typename Kept::template Scratch<Pack> scratch(cells_.table.size());
    const auto set_matrix = [&](std::size_t b, const ChildShares<N>& shares, Small<Pack, N * D>& k) {
      for (std::size_t column = 0; column < N * D; ++column) {
        Nodal u{}, f{};
        for (std::size_t a = 0; a < N; ++a) u[a][column % D] = shares[a][column / D];
        Kept::add_product(cells_.table, layout_, &data_[b * size_], u, scratch, f);
        for (std::size_t p = 0; p < N; ++p)
          for (std::size_t i = 0; i < D; ++i) {
            Pack sum = 0.0;
            for (std::size_t a = 0; a < N; ++a) sum += shares[a][p] * f[a][i];
            k[p * D + i][column] = sum;
          }
      }
    };
    add_child_matrices(
        cells_.batches, coarse, [this](std::size_t b) { return cells_.owned[b]; }, set_matrix, values);
  }

  const Cells& cells_;
  Layout layout_;
  std::size_t size_ = 0;  ///< of a batch's data
  std::vector<NarrowPack> data_;
};

}  // namespace ixos
