/// Cells in SIMD batches: gather from local arrays, scatter to force and matrix.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "discretization/pattern.hpp"

namespace ixos {

/// Cells (or sides) of N nodes with D degrees of freedom each, pack_width at a time. The last batch is filled up with
/// copies of its first cell, which are gathered, so that kernels see sound numbers, but never scattered.
template <std::size_t N, std::size_t D>
class ElementBatches {
 public:
  /// `nodes`: cells x N local node numbers. `scale`: empty, or cells x N factors of the nodes' shape functions.
  ElementBatches(const std::vector<int>& nodes, const Pattern& pattern, const std::vector<double>& scale = {})
      : cells_(nodes.size() / N) {
    dofs_.resize((cells_ + width - 1) / width);
    for (std::size_t e = 0; e < dofs_.size() * width; ++e) {
      const int* cell = &nodes[(e < cells_ ? e : (e / width) * width) * N];
      for (std::size_t a = 0; a < N; ++a) dofs_[e / width][a][e % width] = cell[a] * static_cast<int>(D);
    }
    place(pattern);
    if (scale.empty()) return;
    scale_.resize(dofs_.size());
    for (std::size_t e = 0; e < dofs_.size() * width; ++e)
      for (std::size_t a = 0; a < N; ++a)
        scale_[e / width][a][e % width] = scale[(e < cells_ ? e : (e / width) * width) * N + a];
  }

  /// Finds the places of the cells' entries in a pattern that has changed.
  void place(const Pattern& pattern) {
    places_.resize(dofs_.size());
    for (std::size_t batch = 0; batch < dofs_.size(); ++batch)
      for (std::size_t lane = 0; lane < width; ++lane) {
        const auto node = [&](std::size_t a) { return dofs_[batch][a][lane] / static_cast<int>(D); };
        Places& places = places_[batch];
        for (std::size_t a = 0; a < N; ++a) {
          places.stride[a][lane] = pattern.has_row(node(a)) ? pattern.stride(node(a)) : 0;
          for (std::size_t b = 0; b < N; ++b) places.offset[a][b][lane] = pattern.offset(node(a), node(b));
        }
      }
  }

  static constexpr std::size_t width = static_cast<std::size_t>(pack_width);
  std::size_t cells() const { return cells_; }
  std::size_t size() const { return dofs_.size(); }
  std::size_t lanes(std::size_t batch) const { return std::min(width, cells_ - batch * width); }

  /// Returns the first local degree of freedom of a node.
  int first_dof(std::size_t batch, std::size_t node, std::size_t lane) const { return dofs_[batch][node][lane]; }

  void gather(std::size_t batch, const double* local, Small<Pack, N, D>& values) const {
    const Dofs& dof = dofs_[batch];
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d)
        values[a][d] = Pack([&](auto lane) { return local[static_cast<std::size_t>(dof[a][lane]) + d]; });
    scale(batch, values);
  }

  /// Gathers component d alone.
  void gather(std::size_t batch, const double* local, std::size_t d, std::array<Pack, N>& values) const {
    const Dofs& dof = dofs_[batch];
    for (std::size_t a = 0; a < N; ++a)
      values[a] = Pack([&](auto lane) { return local[static_cast<std::size_t>(dof[a][lane]) + d]; });
    scale(batch, values);
  }

  /// Gathers the values less those of the first node, `first`, in single precision: the rounding errors are then
  /// relative to the differences in a cell, however large its displacement is.
  void gather_differences(std::size_t batch, const double* local, Small<NarrowPack, N, D>& values,
                          std::array<NarrowPack, D>& first) const {
    const Dofs& dof = dofs_[batch];
    for (std::size_t d = 0; d < D; ++d) {
      const auto component = [&](std::size_t a) {
        return Pack([&](auto lane) { return local[static_cast<std::size_t>(dof[a][lane]) + d]; });
      };
      const Pack origin = component(0);
      first[d] = narrow<NarrowPack>(origin);
      for (std::size_t a = 0; a < N; ++a) values[a][d] = narrow<NarrowPack>(component(a) - origin);
    }
  }

  /// Returns whether nodes have factors other than 1.
  bool scaled() const { return !scale_.empty(); }
  /// Returns the factor of a node's shape function in that cell.
  double scale(std::size_t batch, std::size_t node, std::size_t lane) const {
    return scale_.empty() ? 1.0 : scale_[batch][node][lane];
  }

  void scatter_force(std::size_t batch, Small<Pack, N, D> values, double* local) const {
    const Dofs& dof = dofs_[batch];
    const std::size_t used = lanes(batch);
    scale(batch, values);
    for (std::size_t a = 0; a < N; ++a) {
      const Rows rows(values[a]);
      for (std::size_t lane = 0; lane < used; ++lane) {
        double* target = local + dof[a][lane];
        for (std::size_t d = 0; d < D; ++d) target[d] += rows(lane, d);
      }
    }
  }

  /// Scatters forces that have component d alone.
  void scatter_force(std::size_t batch, std::size_t d, std::array<Pack, N> values, double* local) const {
    const Dofs& dof = dofs_[batch];
    const std::size_t used = lanes(batch);
    scale(batch, values);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t lane = 0; lane < used; ++lane)
        local[static_cast<std::size_t>(dof[a][lane]) + d] += values[a][lane];
  }

  /// Scatters a diagonal that was computed with the kernel's shape functions, without their factors in the cells.
  void scatter_diagonal(std::size_t batch, Small<Pack, N, D> values, double* local) const {
    scale(batch, values);
    scatter_force(batch, values, local);
  }

  /// Adds the rows of owned nodes to the matrix values, cell by cell and in each cell node by node, so that the memory
  /// of a row is visited once.
  void scatter_tangent(std::size_t batch, const Small<Pack, N * D>& k, double* values) const {
    const Places& places = places_[batch];
    const std::size_t used = lanes(batch);
    for (std::size_t a = 0; a < N; ++a) {
      std::array<std::array<Rows, N>, D> rows;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t c = 0; c < N; ++c) {
          std::array<Pack, D> vector;
          for (std::size_t j = 0; j < D; ++j) vector[j] = k[a * D + i][c * D + j];
          if (!scale_.empty())
            for (std::size_t j = 0; j < D; ++j) vector[j] *= scale_[batch][a] * scale_[batch][c];
          rows[i][c] = Rows(vector);
        }
      for (std::size_t lane = 0; lane < used; ++lane) {
        if (places.offset[a][0][lane] < 0) continue;  // the rank does not own this row
        for (std::size_t i = 0; i < D; ++i) {
          double* row = values + static_cast<std::size_t>(places.stride[a][lane]) * i;
          for (std::size_t c = 0; c < N; ++c) {
            double* target = row + places.offset[a][c][lane];
            std::array<double, D> sum;  // loads before stores: they go together
            for (std::size_t j = 0; j < D; ++j) sum[j] = target[j] + rows[i][c](lane, j);
            std::copy(sum.begin(), sum.end(), target);
          }
        }
      }
    }
  }

  /// Does the same with a matrix of component d alone.
  void scatter_tangent(std::size_t batch, std::size_t d, Small<Pack, N> k, double* values) const {
    const Places& places = places_[batch];
    const std::size_t used = lanes(batch);
    if (!scale_.empty())
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t c = 0; c < N; ++c) k[a][c] *= scale_[batch][a] * scale_[batch][c];
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t lane = 0; lane < used; ++lane) {
        if (places.offset[a][0][lane] < 0) continue;  // the rank does not own this row
        double* row = values + static_cast<std::size_t>(places.stride[a][lane]) * d + d;
        for (std::size_t c = 0; c < N; ++c) row[places.offset[a][c][lane]] += k[a][c][lane];
      }
  }

 private:
  /// A vector of space for each lane.
  class Rows {
   public:
    Rows() = default;
    explicit Rows(const std::array<Pack, D>& vector) {
      if constexpr (D == 3)
        interleave(vector[0], vector[1], vector[2], values_.data());
      else
        interleave(vector[0], vector[1], values_.data());
    }
    double operator()(std::size_t lane, std::size_t d) const { return values_[stride * lane + d]; }

   private:
    static constexpr std::size_t stride = D == 3 ? 4 : 2;
    alignas(64) std::array<double, stride * width> values_;
  };

  void scale(std::size_t batch, Small<Pack, N, D>& values) const {
    if (scale_.empty()) return;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) values[a][d] *= scale_[batch][a];
  }
  void scale(std::size_t batch, std::array<Pack, N>& values) const {
    if (scale_.empty()) return;
    for (std::size_t a = 0; a < N; ++a) values[a] *= scale_[batch][a];
  }

  using Dofs = std::array<std::array<int, width>, N>;  ///< first local degree of freedom of each node
  struct Places {
    std::array<std::array<int, width>, N> stride;                 ///< see Pattern::stride
    std::array<std::array<std::array<int, width>, N>, N> offset;  ///< see Pattern::offset
  };
  std::size_t cells_;
  std::vector<Dofs> dofs_;  ///< apart from the places, which products without a matrix do not need
  std::vector<Places> places_;
  std::vector<std::array<Pack, N>> scale_;  ///< empty if all factors are 1
};

}  // namespace ixos
