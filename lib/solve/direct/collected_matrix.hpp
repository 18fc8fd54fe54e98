/// A distributed matrix collected on the first rank, for the sequential factorisations.
#pragma once
#include <mpi.h>

#include <array>
#include <functional>
#include <vector>

#include "base/tpetra.hpp"

namespace ixos {

/// The rows of all ranks, one after the other, on the first rank; the row map's ranges must follow each other in rank
/// order, as a DofSpace's do. On a single rank nothing is copied. All functions are collective unless they say
/// otherwise.
class CollectedMatrix {
 public:
  /// The matrix must be fill-complete and keep its sparsity. Throws std::runtime_error if it has more than 2^31 - 1
  /// entries.
  explicit CollectedMatrix(const Teuchos::RCP<const CrsMatrix>& matrix);

  /// Collects the present values.
  void refresh();
  bool root() const { return rank_ == 0; }    ///< Not collective.
  bool single() const { return size_ == 1; }  ///< Returns whether there is one rank. Not collective.
  const Teuchos::RCP<const CrsMatrix>& source() const { return matrix_; }  ///< Not collective.
  MPI_Comm comm() const { return comm_; }                                  ///< Not collective.

  // The following are valid on the first rank, and not collective: compressed rows, columns sorted. The arrays belong
  // to this object or to the matrix; sequential libraries take them without const.
  int size() const { return static_cast<int>(starts_.size()) - 1; }
  int entries() const { return starts_.back(); }
  int* starts() { return starts_.data(); }
  int* columns() { return single() ? local_columns_ : columns_.data(); }
  double* values() { return single() ? local_values_ : values_.data(); }

  /// Returns the place of one of the values in the sequence of all ranks' local values, one rank after the other.
  int arrival(int entry) const { return single() ? entry : place_[static_cast<std::size_t>(entry)]; }
  /// Returns where each rank's local values begin in that sequence. Valid on all ranks.
  const std::vector<int>& entry_begins() const { return entry_counts_.start; }

  /// Return the first rank's status, or numbers, on all ranks.
  int agreed(int status) const;
  std::array<double, 3> agreed(std::array<double, 3> numbers) const;
  /// Solves for the columns of b. On the first rank, `solve` gets the whole columns, and sets those of the solution;
  /// every rank gets its part in x.
  using SolveColumns = std::function<void(const std::vector<const double*>& b, const std::vector<double*>& x)>;
  void solve(const MultiVector& b, MultiVector& x, const SolveColumns& solve);

 private:
  struct Counts {
    int mine = 0;
    std::vector<int> count, start;
  };
  Counts counts(int mine) const;
  void collect(const Counts& counts, const void* mine, void* all, MPI_Datatype type) const;
  void collect_pattern();

  Teuchos::RCP<const CrsMatrix> matrix_;
  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
  Counts row_counts_, entry_counts_;
  std::vector<int> starts_{0};
  int* local_columns_ = nullptr;  ///< on a single rank
  double* local_values_ = nullptr;
  // On the first of several ranks: right-hand sides, solutions, columns and values of the whole matrix; the values in
  // the order in which they arrive; for each entry, its position in that order.
  std::vector<double> rhs_, solutions_, values_, incoming_;
  std::vector<int> columns_, place_;
};

}  // namespace ixos
