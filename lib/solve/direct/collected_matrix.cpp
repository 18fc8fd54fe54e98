#include "solve/direct/collected_matrix.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ixos {

CollectedMatrix::CollectedMatrix(const Teuchos::RCP<const CrsMatrix>& matrix)
    : matrix_(matrix), comm_(*dynamic_cast<const Teuchos::MpiComm<int>&>(*matrix->getComm()).getRawMpiComm()) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
  collect_pattern();
}

CollectedMatrix::Counts CollectedMatrix::counts(int mine) const {
  Counts result;
  result.mine = mine;
  result.count.resize(static_cast<std::size_t>(size_));
  MPI_Allgather(&mine, 1, MPI_INT, result.count.data(), 1, MPI_INT, comm_);
  result.start.assign(result.count.size(), 0);
  std::partial_sum(result.count.begin(), result.count.end() - 1, result.start.begin() + 1);
  const long long total = std::accumulate(result.count.begin(), result.count.end(), 0LL);
  if (total > std::numeric_limits<int>::max())
    throw std::runtime_error("the matrix is too large for a sequential factorisation");
  return result;
}

void CollectedMatrix::collect(const Counts& counts, const void* mine, void* all, MPI_Datatype type) const {
  MPI_Gatherv(mine, counts.mine, type, all, counts.count.data(), counts.start.data(), type, 0, comm_);
}

void CollectedMatrix::collect_pattern() {
  const auto local = matrix_->getLocalMatrixHost();
  const auto rows = static_cast<std::size_t>(local.numRows());
  std::vector<int> lengths(rows);
  for (std::size_t i = 0; i < rows; ++i)
    lengths[i] = static_cast<int>(local.graph.row_map(i + 1) - local.graph.row_map(i));
  row_counts_ = counts(static_cast<int>(rows));
  entry_counts_ = counts(static_cast<int>(local.nnz()));
  if (single()) {
    for (int length : lengths) starts_.push_back(starts_.back() + length);
    local_columns_ = const_cast<int*>(local.graph.entries.data());
    return;
  }
  const Map& columns = *matrix_->getColMap();
  std::vector<int> global(local.nnz());
  for (std::size_t k = 0; k < global.size(); ++k)
    global[k] = static_cast<int>(columns.getGlobalElement(local.graph.entries(k)));
  const auto total = [this](const Counts& counts) {
    return static_cast<std::size_t>(root() ? std::accumulate(counts.count.begin(), counts.count.end(), 0) : 0);
  };
  const std::size_t all_rows = total(row_counts_), all_entries = total(entry_counts_);
  std::vector<int> all_lengths(all_rows), unsorted(all_entries);
  collect(row_counts_, lengths.data(), all_lengths.data(), MPI_INT);
  collect(entry_counts_, global.data(), unsorted.data(), MPI_INT);
  values_.resize(all_entries);
  incoming_.resize(all_entries);
  place_.resize(all_entries);
  columns_.resize(all_entries);
  std::iota(place_.begin(), place_.end(), 0);
  for (int length : all_lengths) {
    const auto begin = place_.begin() + starts_.back();
    std::sort(begin, begin + length, [&](int a, int b) {
      return unsorted[static_cast<std::size_t>(a)] < unsorted[static_cast<std::size_t>(b)];
    });
    starts_.push_back(starts_.back() + length);
  }
  for (std::size_t k = 0; k < all_entries; ++k) columns_[k] = unsorted[static_cast<std::size_t>(place_[k])];
}

void CollectedMatrix::refresh() {
  const auto local = matrix_->getLocalMatrixHost();
  if (single()) {
    local_values_ = const_cast<double*>(local.values.data());
    return;
  }
  collect(entry_counts_, local.values.data(), incoming_.data(), MPI_DOUBLE);
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = incoming_[static_cast<std::size_t>(place_[k])];
}

int CollectedMatrix::agreed(int status) const {
  if (size_ > 1) MPI_Bcast(&status, 1, MPI_INT, 0, comm_);
  return status;
}

std::array<double, 3> CollectedMatrix::agreed(std::array<double, 3> numbers) const {
  if (size_ > 1) MPI_Bcast(numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, 0, comm_);
  return numbers;
}

void CollectedMatrix::solve(const MultiVector& b, MultiVector& x, const SolveColumns& solve) {
  const auto source = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto target = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
  const std::size_t count = source.extent(1), rows = root() ? static_cast<std::size_t>(size()) : 0;
  std::vector<const double*> rhs(count);
  std::vector<double*> solutions(count);
  if (!single()) {
    rhs_.resize(count * rows);
    solutions_.resize(rhs_.size());
  }
  for (std::size_t column = 0; column < count; ++column) {
    const double* const own = source.extent(0) > 0 ? &source(0, column) : nullptr;
    double* const own_solution = target.extent(0) > 0 ? &target(0, column) : nullptr;
    rhs[column] = single() ? own : rhs_.data() + column * rows;
    solutions[column] = single() ? own_solution : solutions_.data() + column * rows;
    if (!single()) collect(row_counts_, own, rhs_.data() + column * rows, MPI_DOUBLE);
  }
  if (root()) solve(rhs, solutions);
  for (std::size_t column = 0; column < count && !single(); ++column)
    MPI_Scatterv(solutions[column], row_counts_.count.data(), row_counts_.start.data(), MPI_DOUBLE,
                 target.extent(0) > 0 ? &target(0, column) : nullptr, row_counts_.mine, MPI_DOUBLE, 0, comm_);
}

}  // namespace ixos
