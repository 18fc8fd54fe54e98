/// Some entries of a distributed matrix, collected on the first rank.
#pragma once
#include <mpi.h>

#include <cstddef>
#include <vector>

#include "base/tpetra.hpp"
#include "solve/direct/collected_matrix.hpp"

namespace ixos {

/// For a caller who needs only these entries, such as a triangle, in an order of his own: nothing else travels, and
/// each value is copied once to its place. On a single rank no message is sent.
class SelectedEntries {
 public:
  /// Takes `entries`, indices of matrix.values(), each at most once, and `targets`, the places of their values in the
  /// array of copy(). On the first rank only; not collective, so that a lack of memory can be agreed on before share().
  void select(const CollectedMatrix& matrix, const std::vector<int>& entries, const std::vector<std::size_t>& targets);
  /// Tells the other ranks what the first one has selected of the matrix. Collective.
  void share(const CollectedMatrix& matrix);

  /// Sets array[target] to the present value of each entry. Only the first rank needs an array. Collective.
  void copy(double* array);

 private:
  Teuchos::RCP<const CrsMatrix> matrix_;
  MPI_Comm comm_ = MPI_COMM_NULL;
  bool root_ = false;
  std::vector<int> mine_;             ///< this rank's entries: indices of its local values
  std::vector<int> asked_;            ///< on the first rank: those of all ranks, one after the other
  std::vector<std::size_t> targets_;  ///< on the first rank: of its own entries, then of those that arrive
  std::vector<int> counts_, starts_;  ///< by rank, of the values that arrive
  std::vector<double> sent_, arrived_;
};

}  // namespace ixos
