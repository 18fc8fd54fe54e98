#include <Amesos2.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include "solve/factorization.hpp"
#include "solve/klu2_repair.hpp"

namespace ixos {
namespace {

class Klu2 final : public Factorization {
 public:
  void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) override {
    anchor_klu2_repair();
    matrix_ = matrix;
    solver_ = Amesos2::create<CrsMatrix, MultiVector>("KLU2", matrix);
    solver_->symbolicFactorization();
  }
  void factor() override {
    solver_->setA(matrix_, Amesos2::SYMBFACT);  // new values, same sparsity
    solver_->numericFactorization();
  }
  void solve(const MultiVector& b, MultiVector& x) override {
    solver_->solve(Teuchos::ptrFromRef(x), Teuchos::ptrFromRef(b));
  }

 private:
  Teuchos::RCP<const CrsMatrix> matrix_;
  Teuchos::RCP<Amesos2::Solver<CrsMatrix, MultiVector>> solver_;
};

}  // namespace

std::unique_ptr<Factorization> make_klu2() { return std::make_unique<Klu2>(); }

}  // namespace ixos
