#include "solve/direct/selected_entries.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <numeric>
#include <utility>

namespace ixos {

void SelectedEntries::select(const CollectedMatrix& matrix, const std::vector<int>& entries,
                             const std::vector<std::size_t>& targets) {
  const std::vector<int>& begins = matrix.entry_begins();
  std::vector<std::pair<int, std::size_t>> sorted(entries.size());  // in the order of the ranks' values
  for (std::size_t k = 0; k < sorted.size(); ++k) sorted[k] = {matrix.arrival(entries[k]), targets[k]};
  std::sort(sorted.begin(), sorted.end());
  counts_.assign(begins.size(), 0);
  asked_.clear();
  targets_.clear();
  std::size_t rank = 0;
  for (const auto& [arrival, target] : sorted) {
    while (rank + 1 < begins.size() && arrival >= begins[rank + 1]) ++rank;
    asked_.push_back(arrival - begins[rank]);
    ++counts_[rank];
    targets_.push_back(target);
  }
  mine_.resize(static_cast<std::size_t>(counts_[0]));
  arrived_.resize(asked_.size() - mine_.size());
}

void SelectedEntries::share(const CollectedMatrix& matrix) {
  matrix_ = matrix.source();
  comm_ = matrix.comm();
  root_ = matrix.root();
  counts_.resize(matrix.entry_begins().size());
  int count = 0;
  MPI_Scatter(counts_.data(), 1, MPI_INT, &count, 1, MPI_INT, 0, comm_);
  mine_.resize(static_cast<std::size_t>(count));
  starts_.assign(counts_.size(), 0);
  std::partial_sum(counts_.begin(), counts_.end() - 1, starts_.begin() + 1);
  MPI_Scatterv(asked_.data(), counts_.data(), starts_.data(), MPI_INT, mine_.data(), count, MPI_INT, 0, comm_);
  if (!root_) return sent_.resize(mine_.size());
  counts_[0] = 0;  // the first rank sends nothing to itself
  std::partial_sum(counts_.begin(), counts_.end() - 1, starts_.begin() + 1);
}

void SelectedEntries::copy(double* array) {
  const double* values = matrix_->getLocalMatrixHost().values.data();
  if (root_)
    for (std::size_t k = 0; k < mine_.size(); ++k) array[targets_[k]] = values[mine_[k]];
  else
    for (std::size_t k = 0; k < mine_.size(); ++k) sent_[k] = values[mine_[k]];
  if (counts_.size() == 1) return;
  MPI_Gatherv(sent_.data(), static_cast<int>(sent_.size()), MPI_DOUBLE, arrived_.data(), counts_.data(), starts_.data(),
              MPI_DOUBLE, 0, comm_);
  for (std::size_t k = 0; k < arrived_.size(); ++k) array[targets_[mine_.size() + k]] = arrived_[k];
}

}  // namespace ixos
