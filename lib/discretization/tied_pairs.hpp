/// Where terms write the matrix entries of tied nodes.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "mesh/local_mesh.hpp"

namespace ixos {

/// Blocks of node pairs of which one is tied, in an array behind the values of a matrix: so elements write all of their
/// entries alike, and only those near tied nodes are added once more: first to the columns of masters, for which the
/// rows of tied nodes have room, too, then to the rows of masters. Rows are owned nodes and tied nodes with an owned
/// master. Part of a Pattern.
class TiedPairs {
 public:
  TiedPairs() = default;
  /// `stencils`: nodes that are coupled with each other, all that have a tied one. `first`: index of the first value
  /// behind the matrix. `stride`: that of an owned row, which its further blocks share.
  TiedPairs(const std::vector<std::vector<int>>& stencils, const LocalMesh& mesh, int first,
            const std::function<int(int)>& stride);
  /// Finds what condense() adds to. `offset`: that of a block of the matrix, -1 for rows of other ranks.
  void find_targets(const NodeTies& ties, const std::function<int(int, int)>& offset,
                    const std::function<int(int)>& stride);

  std::size_t values() const { return static_cast<std::size_t>(end_ - first_value_); }
  /// Returns whether a tied node has a row.
  bool has_row(int tied) const { return row_of(tied) != nullptr; }
  int stride(int tied) const { return row_of(tied)->stride; }
  /// Returns the index of the block's first value; -1 if the pair has none.
  int offset(int row, int column) const;
  /// Returns the columns of a row's blocks here, ascending.
  const std::vector<int>& columns(int row) const;

  /// Adds the blocks to those of the masters, with the products of their weights, and sets them to zero.
  void condense(double* values) const;

 private:
  struct Row {
    int node;
    int first;   ///< index of its first value
    int stride;  ///< between the rows of its blocks
    std::vector<int> columns;
  };
  /// Blocks side by side that are added, with a weight, to others side by side.
  struct Target {
    int from, from_stride;
    int to, to_stride;
    int width;  ///< values in a row of all of them
    double weight;
  };
  const Row* row_of(int node) const;
  int offset_in(const Row& row, std::size_t number) const;
  void add_target(int from, int from_stride, int to, int to_stride, double weight);

  int dimension_ = 0;
  int first_value_ = 0, end_ = 0;
  std::vector<Row> rows_;        ///< by ascending node
  std::vector<Target> targets_;  ///< in their order: a later one may read what an earlier one wrote
};

}  // namespace ixos
