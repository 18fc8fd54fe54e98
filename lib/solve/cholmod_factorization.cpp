#include <cholmod.h>
#include <fmt/format.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "solve/factorization.hpp"

namespace ixos {
namespace {

class Cholmod final : public Factorization {
 public:
  Cholmod() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
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
    if (matrix->getComm()->getSize() != 1) throw std::runtime_error("CHOLMOD runs on one rank; use KLU2 on several");
    const auto local = matrix->getLocalMatrixHost();
    starts_.resize(static_cast<std::size_t>(local.numRows()) + 1);
    for (std::size_t i = 0; i < starts_.size(); ++i) starts_[i] = static_cast<int>(local.graph.row_map(i));
    analyze_again();
  }

  void factor() override {
    cholmod_sparse view = matrix_view();
    cholmod_factorize(&view, factor_, &common_);
    if (common_.status == CHOLMOD_NOT_POSDEF && common_.supernodal != CHOLMOD_SIMPLICIAL) {
      common_.supernodal = CHOLMOD_SIMPLICIAL;
      analyze_again();
      cholmod_factorize(&view, factor_, &common_);
    }
    if (common_.status != CHOLMOD_OK)
      throw std::runtime_error(fmt::format("CHOLMOD cannot factor the matrix (status {})", common_.status));
  }

  void solve(const MultiVector& b, MultiVector& x) override {
    const auto source = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto target = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t column = 0; column < source.extent(1); ++column) {
      cholmod_dense rhs{};
      rhs.nrow = rhs.nzmax = rhs.d = source.extent(0);
      rhs.ncol = 1;
      rhs.x = const_cast<double*>(&source(0, column));
      rhs.xtype = CHOLMOD_REAL;
      rhs.dtype = CHOLMOD_DOUBLE;
      if (!cholmod_solve2(CHOLMOD_A, factor_, &rhs, nullptr, &solution_, nullptr, &work1_, &work2_, &common_))
        throw std::runtime_error("CHOLMOD cannot solve");
      std::copy_n(static_cast<const double*>(solution_->x), source.extent(0), &target(0, column));
    }
  }

 private:
  /// The matrix is symmetric, so its rows are its columns; CHOLMOD reads the upper triangle and skips the rest.
  cholmod_sparse matrix_view() {
    const auto local = matrix_->getLocalMatrixHost();
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(local.numRows());
    view.nzmax = local.nnz();
    view.p = starts_.data();
    view.i = const_cast<int*>(local.graph.entries.data());
    view.x = const_cast<double*>(local.values.data());
    view.stype = 1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
  }

  void analyze_again() {
    cholmod_sparse view = matrix_view();
    cholmod_free_factor(&factor_, &common_);
    factor_ = cholmod_analyze(&view, &common_);
    if (factor_ == nullptr)
      throw std::runtime_error(fmt::format("CHOLMOD cannot analyze the matrix (status {})", common_.status));
  }

  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* work1_ = nullptr;
  cholmod_dense* work2_ = nullptr;
  Teuchos::RCP<const CrsMatrix> matrix_;
  std::vector<int> starts_;
};

}  // namespace

std::unique_ptr<Factorization> make_cholmod() { return std::make_unique<Cholmod>(); }

}  // namespace ixos
