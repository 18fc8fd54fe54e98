#include <dmumps_c.h>
#include <fmt/format.h>
#include <smumps_c.h>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "base/memory.hpp"
#include "solve/loaded/mumps_factorization.hpp"

namespace ixos {
namespace {

struct Double {
  using Struct = DMUMPS_STRUC_C;
  using Real = double;
  static void call(Struct& data) { dmumps_c(&data); }
};
struct Single {
  using Struct = SMUMPS_STRUC_C;
  using Real = float;
  static void call(Struct& data) { smumps_c(&data); }
};

/// MUMPS with the lower triangle distributed: every rank passes the rows that it owns. Right-hand sides go through the
/// first rank.
template <class Precision>
class Mumps final : public Factorization {
  using Real = typename Precision::Real;

 public:
  Mumps() = default;
  ~Mumps() override {
    if (data_.job != 0) run(-2);
  }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) override {
    matrix_ = matrix;
    const auto comm = Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(matrix->getComm(), true);
    comm_ = *comm->getRawMpiComm();
    MPI_Comm_rank(comm_, &rank_);
    collect_pattern();
    data_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm_));
    data_.par = 1;
    data_.sym = 1;  // L D L^T without pivoting
    run(-1);
    for (int control : {1, 2, 3, 4}) set(control, 0);  // no output
    set(7, 5);                                         // METIS
    set(13, 1);                                        // the root is not distributed: Cholesky would refuse it there
    set(14, 30);                                       // workspace beyond the estimate, per cent
    set(18, 3);                                        // distributed matrix
    data_.n = static_cast<MUMPS_INT>(matrix->getGlobalNumRows());
    data_.nnz_loc = static_cast<MUMPS_INT8>(rows_.size());
    data_.irn_loc = rows_.data();
    data_.jcn_loc = columns_.data();
    run(1);
    require("analyze");
  }

  void factor() override {
    const auto local = matrix_->getLocalMatrixHost();
    for (std::size_t k = 0; k < places_.size(); ++k) values_[k] = static_cast<Real>(local.values(places_[k]));
    data_.a_loc = values_.data();
    run(2);
    // The estimate of the workspace was too small: the next attempt gets more.
    for (int more = 100; more <= 800 && (data_.infog[0] == -8 || data_.infog[0] == -9); more *= 2) {
      set(14, more);
      run(2);
    }
    require("factor");
  }

  /// Solves for all columns in one pass over the factors.
  void solve(const MultiVector& b, MultiVector& x) override {
    const std::size_t columns = b.getNumVectors(), n = all_.empty() ? 0 : static_cast<std::size_t>(data_.n);
    const auto from = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    all_.resize(std::max(columns * n, all_.size()));
    mine_.resize(from.extent(0));
    for (std::size_t j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < mine_.size(); ++i) mine_[i] = static_cast<Real>(from(i, j));
      MPI_Gatherv(mine_.data(), static_cast<int>(mine_.size()), type(), all_.data() + j * n, counts_.data(),
                  starts_.data(), type(), 0, comm_);
    }
    data_.nrhs = static_cast<MUMPS_INT>(columns);
    data_.lrhs = data_.n;
    data_.rhs = all_.data();
    run(3);
    require("solve with");
    const auto to = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t j = 0; j < columns; ++j) {
      MPI_Scatterv(all_.data() + j * n, counts_.data(), starts_.data(), type(), mine_.data(),
                   static_cast<int>(mine_.size()), type(), 0, comm_);
      for (std::size_t i = 0; i < mine_.size(); ++i) to(i, j) = static_cast<double>(mine_[i]);
    }
  }

  const FactorizationMemory& memory() const override { return memory_; }
  void remember(FactorizationMemory memory) override { memory_ = std::move(memory); }

 private:
  static MPI_Datatype type() { return std::is_same_v<Real, float> ? MPI_FLOAT : MPI_DOUBLE; }

  void run(int job) {
    data_.job = job;
    Precision::call(data_);
  }
  /// Sets a control parameter by its number in MUMPS' documentation, from 1.
  void set(int control, int value) { data_.icntl[control - 1] = value; }

  void require(const char* what) const {
    const int status = data_.infog[0], detail = data_.infog[1];
    if (status >= 0) return;
    if (status == -5 || status == -7 || status == -13) {
      // It asked for so many integers (-7) or reals; negative: millions of them.
      const double entries = detail < 0 ? -1e6 * detail : detail;
      note_failed_allocation(static_cast<std::size_t>(entries * (status == -7 ? sizeof(MUMPS_INT) : sizeof(Real))));
      throw std::bad_alloc();
    }
    throw std::runtime_error(fmt::format("MUMPS cannot {} the matrix (status {}, {})", what, status, detail));
  }

  void collect_pattern() {
    const auto local = matrix_->getLocalMatrixHost();
    const auto row_map = matrix_->getRowMap();
    const auto column_map = matrix_->getColMap();
    if (matrix_->getGlobalNumRows() >= static_cast<Tpetra::global_size_t>(std::numeric_limits<int>::max()))
      throw std::runtime_error("the matrix has too many rows for MUMPS");
    for (LocalId row = 0; row < local.numRows(); ++row) {
      const GlobalId i = row_map->getGlobalElement(row);
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
        const GlobalId j = column_map->getGlobalElement(local.graph.entries(k));
        if (j > i) continue;
        rows_.push_back(static_cast<MUMPS_INT>(i + 1));
        columns_.push_back(static_cast<MUMPS_INT>(j + 1));
        places_.push_back(k);
      }
    }
    values_.resize(places_.size());
    int ranks = 1;
    MPI_Comm_size(comm_, &ranks);
    counts_.resize(static_cast<std::size_t>(ranks));
    starts_.assign(counts_.size(), 0);
    const int count = local.numRows();
    MPI_Allgather(&count, 1, MPI_INT, counts_.data(), 1, MPI_INT, comm_);
    for (std::size_t r = 1; r < counts_.size(); ++r) starts_[r] = starts_[r - 1] + counts_[r - 1];
    if (rank_ == 0) all_.resize(matrix_->getGlobalNumRows());
  }

  typename Precision::Struct data_{};
  Teuchos::RCP<const CrsMatrix> matrix_;
  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  std::vector<MUMPS_INT> rows_, columns_;  ///< of the entries handed over, from 1
  std::vector<std::size_t> places_;        ///< of these entries in the matrix
  std::vector<Real> values_, mine_, all_;
  std::vector<int> counts_, starts_;  ///< rows of each rank
  FactorizationMemory memory_;
};

}  // namespace

std::unique_ptr<Factorization> make_mumps(bool single_precision) {
  if (single_precision) return std::make_unique<Mumps<Single>>();
  return std::make_unique<Mumps<Double>>();
}

}  // namespace ixos
