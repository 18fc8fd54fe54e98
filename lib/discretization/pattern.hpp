/// The sparsity of the tangent, and the places of an element's entries in it.
#pragma once
#include <cstddef>
#include <vector>

#include "base/tpetra.hpp"
#include "discretization/dof_space.hpp"
#include "discretization/tied_pairs.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Nodes that share a cell or a stencil are coupled. Rows are owned nodes; columns are local nodes in ascending order.
/// In the matrix each node pair is a dense block of dimension x dimension values whose rows are `stride` apart, so an
/// element's entries are written through one offset for each node pair, without a search.
///
/// Tied nodes have neither rows nor columns in the matrix. Terms write their entries all the same, behind the matrix
/// values (see TiedPairs), and condense() adds them where they belong.
class Pattern {
 public:
  /// `stencils`: further nodes that are coupled, all pairs of each stencil; local node numbers.
  explicit Pattern(const LocalMesh& mesh, const std::vector<std::vector<int>>& stencils = {});

  int dimension() const { return dimension_; }
  int rows() const { return static_cast<int>(row_start_.size()) - 1; }
  const std::vector<int>& row_start() const { return row_start_; }  ///< per owned node, in node pairs
  const std::vector<int>& columns() const { return columns_; }      ///< local node numbers
  int pairs() const { return static_cast<int>(columns_.size()); }
  /// Returns the number of values of the matrix, and that of an array to which terms add: with the room behind them.
  std::size_t matrix_values() const { return columns_.size() * block_size(); }
  std::size_t values() const { return matrix_values() + tied_.values(); }
  const NodeTies& ties() const { return ties_; }

  /// Returns whether terms add to blocks of that row: of an owned node, or of a tied one with an owned master.
  bool has_row(int node) const { return ties_.is_tied(node) ? tied_.has_row(node) : node < rows(); }
  /// Returns the index of the node pair, or -1 if `row` is not owned. Neither is tied. Throws std::logic_error if the
  /// nodes are not coupled.
  int pair(int row, int column) const;
  /// Returns the index of the first value of the node pair's block, or -1 unless has_row(row). Throws likewise.
  int offset(int row, int column) const;
  /// Returns the same, but -1 if the nodes are not coupled.
  int coupled_offset(int row, int column) const;
  /// Returns the distance between the rows of the blocks of a node with has_row().
  int stride(int row) const {
    return ties_.is_tied(row) ? tied_.stride(row)
                              : dimension_ * (row_start_[row_index(row) + 1] - row_start_[row_index(row)]);
  }
  /// Calls visit(column, offset) for the blocks of a node with has_row(), those of tied columns too.
  template <class Visit>
  void for_each_block(int row, const Visit& visit) const {
    for (int p = row < rows() ? row_start_[row_index(row)] : 0; row < rows() && p < row_start_[row_index(row) + 1]; ++p)
      visit(columns_[static_cast<std::size_t>(p)], offset_of(row, p));
    for (const int column : tied_.columns(row)) visit(column, tied_.offset(row, column));
  }

  /// Adds the blocks behind the matrix values to the matrix: K_free = C^T K C, see NodeTies. Sets them to zero.
  void condense(double* values) const {
    if (!ties_.empty()) tied_.condense(values);
  }

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

  /// Returns a matrix of this sparsity, fill-complete, values zero. Its memory has the room of values().
  Teuchos::RCP<CrsMatrix> create_matrix(const DofSpace& space) const;
  /// Returns the same with the rows of all local nodes, for a pattern of a mesh whose local nodes count as owned.
  Teuchos::RCP<CrsMatrix> create_local_matrix(const DofSpace& space) const;

 private:
  int find(int row, int column) const;
  int offset_of(int row, int pair) const;
  Teuchos::RCP<CrsMatrix> create_matrix(const Teuchos::RCP<const Map>& row_map, const DofSpace& space) const;
  static std::size_t row_index(int row) { return static_cast<std::size_t>(row); }
  std::size_t block_size() const { return static_cast<std::size_t>(dimension_) * static_cast<std::size_t>(dimension_); }
  int dimension_;
  NodeTies ties_;
  std::vector<int> row_start_;
  std::vector<int> columns_;
  TiedPairs tied_;
  mutable Teuchos::RCP<const CrsGraph> graph_;
};

/// Adds factor K x to y for matrix values K in the layout of a pattern, condensed: x local, y the rows of owned nodes.
inline void add_matrix_product(const Pattern& pattern, const double* values, double factor, const double* x,
                               double* y) {
  pattern.for_each_row(values, [&](int row, const auto& entries) {
    double sum = 0;
    entries([&](int column, double value) { sum += value * x[column]; });
    y[row] += factor * sum;
  });
}

}  // namespace ixos
