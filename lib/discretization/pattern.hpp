/// The sparsity of the tangent, and the places of an element's entries in it.
#pragma once
#include <cstddef>
#include <vector>

#include "base/tpetra.hpp"
#include "discretization/dof_space.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Nodes that share a cell or a stencil are coupled. Rows are owned nodes; columns are local nodes in ascending order.
/// In the matrix each node pair is a dense block of dimension x dimension values whose rows are `stride` apart, so an
/// element's entries are written through one offset for each node pair, without a search.
class Pattern {
 public:
  /// `stencils`: further nodes that are coupled, all pairs of each stencil; local node numbers.
  explicit Pattern(const LocalMesh& mesh, const std::vector<std::vector<int>>& stencils = {});

  int dimension() const { return dimension_; }
  int rows() const { return static_cast<int>(row_start_.size()) - 1; }
  const std::vector<int>& row_start() const { return row_start_; }  ///< per owned node, in node pairs
  const std::vector<int>& columns() const { return columns_; }      ///< local node numbers
  int pairs() const { return static_cast<int>(columns_.size()); }

  /// Returns the index of the node pair, or -1 if `row` is not owned. Throws std::logic_error if the nodes are not
  /// coupled.
  int pair(int row, int column) const;
  /// Returns the index of the first matrix value of the node pair's block, or -1 if `row` is not owned.
  int offset(int row, int column) const;
  /// Returns the same, but -1 if the nodes are not coupled.
  int coupled_offset(int row, int column) const;
  /// Returns the distance between the rows of the blocks of that owned node.
  int stride(int row) const { return dimension_ * (row_start_[row_index(row) + 1] - row_start_[row_index(row)]); }

  /// Walks over the matrix, row by row in the order of memory: calls visit(r, entries) for each owned degree of freedom
  /// r, in which entries(f) calls f(c, place) for each entry of that row, c the local column, place that of its value.
  template <class Visit>
  void for_each_row(const Visit& visit) const {
    std::size_t place = 0;
    for (int row = 0; row < rows(); ++row) {
      const int* const first = columns_.data() + row_start_[row_index(row)];
      const int* const last = columns_.data() + row_start_[row_index(row) + 1];
      for (int i = 0; i < dimension_; ++i) {
        visit(row * dimension_ + i, [&, start = place](const auto& f) {
          std::size_t here = start;
          for (const int* column = first; column != last; ++column)
            for (int j = 0; j < dimension_; ++j) f(*column * dimension_ + j, here++);
        });
        place += static_cast<std::size_t>((last - first) * dimension_);
      }
    }
  }
  /// Does the same with the matrix values: entries(f) calls f(c, value).
  template <class Value, class Visit>
  void for_each_row(Value* values, const Visit& visit) const {
    for_each_row([&](int row, const auto& places) {
      visit(row, [&](const auto& f) { places([&](int column, std::size_t place) { f(column, values[place]); }); });
    });
  }

  /// Returns a matrix of this sparsity, fill-complete, values zero.
  Teuchos::RCP<CrsMatrix> create_matrix(const DofSpace& space) const;
  /// Returns the same with the rows of all local nodes, for a pattern of a mesh whose local nodes count as owned.
  Teuchos::RCP<CrsMatrix> create_local_matrix(const DofSpace& space) const;

 private:
  int find(int row, int column) const;
  int offset_of(int row, int pair) const;
  Teuchos::RCP<CrsMatrix> create_matrix(const Teuchos::RCP<const Map>& row_map, const DofSpace& space) const;
  static std::size_t row_index(int row) { return static_cast<std::size_t>(row); }
  int dimension_;
  std::vector<int> row_start_;
  std::vector<int> columns_;
  mutable Teuchos::RCP<const CrsGraph> graph_;
};

/// Adds factor K x to y for matrix values K in the layout of a pattern: x local, y the rows of owned nodes.
inline void add_matrix_product(const Pattern& pattern, const double* values, double factor, const double* x,
                               double* y) {
  pattern.for_each_row(values, [&](int row, const auto& entries) {
    double sum = 0;
    entries([&](int column, double value) { sum += value * x[column]; });
    y[row] += factor * sum;
  });
}

}  // namespace ixos
