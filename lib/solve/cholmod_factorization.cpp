#include <cholmod.h>
#include <fmt/format.h>
#include <mpi.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "solve/factorization.hpp"

namespace ixos {
namespace {

/// Owned rows of all ranks collected on the first. The row map's ranges follow each other in rank order.
class Gather {
 public:
  explicit Gather(const CrsMatrix& matrix)
      : comm_(*dynamic_cast<const Teuchos::MpiComm<int>&>(*matrix.getComm()).getRawMpiComm()) {
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
    const auto local = matrix.getLocalMatrixHost();
    rows_ = counts(static_cast<int>(local.numRows()));
    entries_ = counts(static_cast<int>(local.nnz()));
  }

  bool root() const { return rank_ == 0; }
  bool single() const { return size_ == 1; }
  int rows() const { return rows_.total; }
  int entries() const { return entries_.total; }

  void collect_rows(const int* mine, int* all) const { collect(rows_, mine, all, MPI_INT); }
  void collect_rows(const double* mine, double* all) const { collect(rows_, mine, all, MPI_DOUBLE); }
  void collect_entries(const int* mine, int* all) const { collect(entries_, mine, all, MPI_INT); }
  void collect_entries(const double* mine, double* all) const { collect(entries_, mine, all, MPI_DOUBLE); }
  void distribute_rows(const double* all, double* mine) const {
    MPI_Scatterv(all, rows_.count.data(), rows_.start.data(), MPI_DOUBLE, mine, rows_.mine, MPI_DOUBLE, 0, comm_);
  }
  /// The first rank's status on all ranks.
  int agreed(int status) const {
    if (size_ > 1) MPI_Bcast(&status, 1, MPI_INT, 0, comm_);
    return status;
  }

 private:
  struct Counts {
    int mine = 0;
    int total = 0;
    std::vector<int> count, start;
  };
  Counts counts(int mine) const {
    Counts result;
    result.mine = mine;
    result.count.resize(static_cast<std::size_t>(size_));
    MPI_Allgather(&mine, 1, MPI_INT, result.count.data(), 1, MPI_INT, comm_);
    result.start.assign(result.count.size(), 0);
    std::partial_sum(result.count.begin(), result.count.end() - 1, result.start.begin() + 1);
    const long long total = std::accumulate(result.count.begin(), result.count.end(), 0LL);
    if (total > std::numeric_limits<int>::max()) throw std::runtime_error("the matrix is too large for CHOLMOD");
    result.total = static_cast<int>(total);
    return result;
  }
  void collect(const Counts& counts, const void* mine, void* all, MPI_Datatype type) const {
    MPI_Gatherv(mine, counts.mine, type, all, counts.count.data(), counts.start.data(), type, 0, comm_);
  }

  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
  Counts rows_, entries_;
};

class Cholmod final : public Factorization {
 public:
  Cholmod() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
    // Below some 80 operations an entry of L (CHOLMOD says 40) the simplicial factorisation was the faster, by 1.6
    // at 41.
    common_.supernodal_switch = 80;
    common_.final_ll = 0;  // L D L^T: an indefinite tangent is factored too
  }
  ~Cholmod() override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_free_dense(&solution_, &common_);
    cholmod_free_dense(&work1_, &common_);
    cholmod_free_dense(&work2_, &common_);
    cholmod_finish(&common_);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) override {
    matrix_ = matrix;
    gather_ = std::make_unique<Gather>(*matrix);
    collect_pattern();
    int status = CHOLMOD_OK;
    if (gather_->root()) status = analyze_again();
    status = gather_->agreed(status);
    if (status != CHOLMOD_OK)
      throw std::runtime_error(fmt::format("CHOLMOD cannot analyze the matrix (status {})", status));
  }

  void factor() override {
    collect_values();
    int status = CHOLMOD_OK;
    if (gather_->root()) {
      cholmod_sparse view = matrix_view();
      cholmod_factorize(&view, factor_, &common_);
      if (common_.status == CHOLMOD_NOT_POSDEF && factor_->is_super != 0) {
        common_.supernodal = CHOLMOD_SIMPLICIAL;
        if (analyze_again() == CHOLMOD_OK) cholmod_factorize(&view, factor_, &common_);
      }
      status = common_.status;
    }
    status = gather_->agreed(status);
    if (status != CHOLMOD_OK)
      throw std::runtime_error(fmt::format("CHOLMOD cannot factor the matrix (status {})", status));
  }

  void solve(const MultiVector& b, MultiVector& x) override {
    const auto source = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto target = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t column = 0; column < source.extent(1); ++column) {
      const double* rhs = source.extent(0) > 0 ? &source(0, column) : nullptr;
      double* solution = target.extent(0) > 0 ? &target(0, column) : nullptr;
      if (!gather_->single()) gather_->collect_rows(rhs, rhs_.data());
      // It fails only for want of memory; to agree on that would cost a message in every Krylov iteration.
      if (gather_->root() && !solve_column(gather_->single() ? rhs : rhs_.data())) throw std::bad_alloc();
      const double* all = gather_->root() ? static_cast<const double*>(solution_->x) : nullptr;
      if (gather_->single())
        std::copy_n(all, source.extent(0), solution);
      else
        gather_->distribute_rows(all, solution);
    }
  }

 private:
  /// On the first rank: the starts of all rows, and on several ranks their columns and where each value goes.
  void collect_pattern() {
    const auto local = matrix_->getLocalMatrixHost();
    const auto rows = static_cast<std::size_t>(local.numRows());
    std::vector<int> lengths(rows);
    for (std::size_t i = 0; i < rows; ++i)
      lengths[i] = static_cast<int>(local.graph.row_map(i + 1) - local.graph.row_map(i));
    starts_.assign(1, 0);
    if (gather_->single()) {
      for (int length : lengths) starts_.push_back(starts_.back() + length);
      return;
    }
    const Map& columns = *matrix_->getColMap();
    std::vector<int> global(local.nnz());
    for (std::size_t k = 0; k < global.size(); ++k)
      global[k] = static_cast<int>(columns.getGlobalElement(local.graph.entries(k)));
    const auto all_rows = static_cast<std::size_t>(gather_->root() ? gather_->rows() : 0);
    const auto all_entries = static_cast<std::size_t>(gather_->root() ? gather_->entries() : 0);
    std::vector<int> all_lengths(all_rows), unsorted(all_entries);
    gather_->collect_rows(lengths.data(), all_lengths.data());
    gather_->collect_entries(global.data(), unsorted.data());
    rhs_.resize(all_rows);
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

  void collect_values() {
    if (gather_->single()) return;
    gather_->collect_entries(matrix_->getLocalMatrixHost().values.data(), incoming_.data());
    for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = incoming_[static_cast<std::size_t>(place_[k])];
  }

  /// The matrix is symmetric, so its rows are its columns; CHOLMOD reads the upper triangle and skips the rest.
  cholmod_sparse matrix_view() {
    const auto local = matrix_->getLocalMatrixHost();
    const bool single = gather_->single();
    cholmod_sparse view{};
    view.nrow = view.ncol = starts_.size() - 1;
    view.nzmax = static_cast<std::size_t>(gather_->entries());
    view.p = starts_.data();
    view.i = single ? const_cast<int*>(local.graph.entries.data()) : columns_.data();
    view.x = single ? const_cast<double*>(local.values.data()) : values_.data();
    view.stype = 1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
  }

  int analyze_again() {
    cholmod_sparse view = matrix_view();
    cholmod_free_factor(&factor_, &common_);
    factor_ = cholmod_analyze(&view, &common_);
    return factor_ == nullptr && common_.status == CHOLMOD_OK ? CHOLMOD_INVALID : common_.status;
  }

  bool solve_column(const double* rhs_values) {
    cholmod_dense rhs{};
    rhs.nrow = rhs.nzmax = rhs.d = starts_.size() - 1;
    rhs.ncol = 1;
    rhs.x = const_cast<double*>(rhs_values);
    rhs.xtype = CHOLMOD_REAL;
    rhs.dtype = CHOLMOD_DOUBLE;
    return cholmod_solve2(CHOLMOD_A, factor_, &rhs, nullptr, &solution_, nullptr, &work1_, &work2_, &common_) != 0;
  }

  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* work1_ = nullptr;
  cholmod_dense* work2_ = nullptr;
  Teuchos::RCP<const CrsMatrix> matrix_;
  std::unique_ptr<Gather> gather_;
  std::vector<int> starts_;
  // On the first of several ranks: right-hand side, columns and values of the whole matrix, row by row and sorted;
  // values as they come in; of each entry, where it comes in.
  std::vector<double> rhs_, values_, incoming_;
  std::vector<int> columns_, place_;
};

}  // namespace

std::unique_ptr<Factorization> make_cholmod() { return std::make_unique<Cholmod>(); }

}  // namespace ixos
