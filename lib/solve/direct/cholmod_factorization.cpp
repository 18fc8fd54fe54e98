#include <cholmod.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/memory.hpp"
#include "solve/direct/first_rank_factorization.hpp"

namespace ixos {
namespace {

class Cholmod final : public FirstRankFactorization {
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
    matrix_ = std::make_unique<CollectedMatrix>(matrix);
    matrix_->refresh();
    int status = CHOLMOD_OK;
    if (matrix_->root()) status = analyze_again();
    require(matrix_->agreed(status), "analyze");
  }

  void factor() override {
    matrix_->refresh();
    int status = CHOLMOD_OK;
    if (matrix_->root()) {
      cholmod_sparse view = matrix_view();
      cholmod_factorize(&view, factor_, &common_);
      if (common_.status == CHOLMOD_NOT_POSDEF && factor_->is_super != 0) {
        memory_.indefinite = true;
        common_.supernodal = CHOLMOD_SIMPLICIAL;
        if (analyze_again() == CHOLMOD_OK) cholmod_factorize(&view, factor_, &common_);
      }
      status = common_.status;
    }
    require(matrix_->agreed(status), "factor");
  }

  CollectedMatrix& collected() override { return *matrix_; }
  const double* solve_collected(const double* b) override {
    solve_columns(b, 1);
    return static_cast<const double*>(solution_->x);
  }
  void solve_collected(const std::vector<const double*>& b, const std::vector<double*>& x) override {
    const auto size = static_cast<std::size_t>(matrix_->size());
    if (b.size() > 1) {
      rhs_.resize(b.size() * size);
      for (std::size_t k = 0; k < b.size(); ++k) std::copy_n(b[k], size, &rhs_[k * size]);
    }
    solve_columns(b.size() > 1 ? rhs_.data() : b[0], b.size());
    for (std::size_t k = 0; k < x.size(); ++k)
      std::copy_n(static_cast<const double*>(solution_->x) + k * solution_->d, size, x[k]);
  }

  const FactorizationMemory& memory() const override { return memory_; }
  void remember(FactorizationMemory memory) override {
    memory_ = std::move(memory);
    if (memory_.indefinite) common_.supernodal = CHOLMOD_SIMPLICIAL;
  }

 private:
  static void require(int status, const char* what) {
    if (status == CHOLMOD_OUT_OF_MEMORY) {
      note_failed_allocation(0);
      throw std::bad_alloc();
    }
    if (status != CHOLMOD_OK)
      throw std::runtime_error(fmt::format("CHOLMOD cannot {} the matrix (status {})", what, status));
  }

  /// The matrix is symmetric, so its rows are its columns; CHOLMOD reads the upper triangle of that (our lower) and
  /// skips the rest.
  cholmod_sparse matrix_view() {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix_->size());
    view.nzmax = static_cast<std::size_t>(matrix_->entries());
    view.p = matrix_->starts();
    view.i = matrix_->columns();
    view.x = matrix_->values();
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

  /// Sets solution_. It fails only if memory runs out; an agreement on that would cost a message in every Krylov
  /// iteration.
  void solve_columns(const double* values, std::size_t count) {
    cholmod_dense rhs{};
    rhs.nrow = rhs.d = static_cast<std::size_t>(matrix_->size());
    rhs.ncol = count;
    rhs.nzmax = count * rhs.nrow;
    rhs.x = const_cast<double*>(values);
    rhs.xtype = CHOLMOD_REAL;
    rhs.dtype = CHOLMOD_DOUBLE;
    if (cholmod_solve2(CHOLMOD_A, factor_, &rhs, nullptr, &solution_, nullptr, &work1_, &work2_, &common_) == 0)
      require(CHOLMOD_OUT_OF_MEMORY, "solve with");
  }

  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* work1_ = nullptr;
  cholmod_dense* work2_ = nullptr;
  std::unique_ptr<CollectedMatrix> matrix_;
  std::vector<double> rhs_;  ///< of several columns
  FactorizationMemory memory_;
};

}  // namespace

std::unique_ptr<Factorization> make_cholmod() { return std::make_unique<Cholmod>(); }

}  // namespace ixos
