#include <fmt/format.h>
#include <klu.h>

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

class Klu final : public FirstRankFactorization {
 public:
  Klu() {
    klu_defaults(&common_);
    common_.btf = 0;     // a tangent is irreducible
    common_.scale = -1;  // and its diagonal dominates enough: nothing to scale, and no pass over it to check
  }
  ~Klu() override {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;

  void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) override {
    matrix_ = std::make_unique<CollectedMatrix>(matrix);
    bool done = true;
    if (matrix_->root()) {
      klu_free_numeric(&numeric_, &common_);
      klu_free_symbolic(&symbolic_, &common_);
      symbolic_ = klu_analyze(matrix_->size(), matrix_->starts(), matrix_->columns(), &common_);
      done = symbolic_ != nullptr;
      solution_.resize(static_cast<std::size_t>(matrix_->size()));
    }
    require(done, "analyze");
  }

  void factor() override {
    matrix_->refresh();
    bool done = true;
    if (matrix_->root()) {
      if (std::exchange(remembers_, false)) choose_pivots();
      if (!refactor()) {
        memory_.pivots_for.assign(matrix_->values(), matrix_->values() + matrix_->entries());
        done = choose_pivots();
      }
    }
    require(done, "factor");
  }

  CollectedMatrix& collected() override { return *matrix_; }
  /// KLU expects columns and gets the matrix's rows: it factors the transpose, and solves with the transpose of that.
  const double* solve_collected(const double* b) override {
    std::copy_n(b, solution_.size(), solution_.begin());
    klu_tsolve(symbolic_, numeric_, matrix_->size(), 1, solution_.data(), &common_);
    return solution_.data();
  }

  const FactorizationMemory& memory() const override { return memory_; }
  void remember(FactorizationMemory memory) override {
    memory_ = std::move(memory);
    remembers_ = true;
  }

 private:
  void require(bool done, const char* what) const {
    const int status = matrix_->agreed(done ? KLU_OK : common_.status != KLU_OK ? common_.status : KLU_SINGULAR);
    if (status == KLU_OUT_OF_MEMORY) {
      note_failed_allocation(0);
      throw std::bad_alloc();
    }
    if (status != KLU_OK) throw std::runtime_error(fmt::format("KLU cannot {} the matrix (status {})", what, status));
  }

  /// Factors new values with the previous pivots, as long as these do not shrink.
  bool refactor() {
    if (numeric_ == nullptr) return false;
    if (klu_refactor(matrix_->starts(), matrix_->columns(), matrix_->values(), symbolic_, numeric_, &common_) == 0 ||
        common_.status != KLU_OK)
      return false;
    return klu_rcond(symbolic_, numeric_, &common_) != 0 && common_.rcond > 1e-12;
  }
  bool choose_pivots() {
    klu_free_numeric(&numeric_, &common_);
    if (memory_.pivots_for.size() != static_cast<std::size_t>(matrix_->entries())) return false;
    numeric_ = klu_factor(matrix_->starts(), matrix_->columns(), memory_.pivots_for.data(), symbolic_, &common_);
    return numeric_ != nullptr && common_.status == KLU_OK;
  }

  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  std::unique_ptr<CollectedMatrix> matrix_;
  std::vector<double> solution_;
  FactorizationMemory memory_;
  bool remembers_ = false;  ///< the memory was set, and its pivots are yet to be chosen
};

}  // namespace

std::unique_ptr<FirstRankFactorization> make_klu() { return std::make_unique<Klu>(); }

}  // namespace ixos
