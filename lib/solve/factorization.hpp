/// Sparse factorisations behind the direct solver.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/tpetra.hpp"
#include "checkpoint/record.hpp"

namespace ixos {

/// What a factorisation keeps from matrix to matrix.
struct FactorizationMemory {
  bool indefinite = false;         ///< some matrix was not positive definite
  std::vector<double> pivots_for;  ///< on the first rank: the values that the order of pivots was chosen for
};

/// A factorisation of one matrix, whose sparsity stays: analyze() once, factor() for each set of values.
class Factorization {
 public:
  virtual ~Factorization() = default;
  /// Symbolic phase. Throws std::runtime_error where the sparsity is structurally singular.
  virtual void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) = 0;
  /// Numeric phase, from the matrix's present values. Throws std::runtime_error where a pivot vanishes.
  virtual void factor() = 0;
  /// x = A^-1 b for each column.
  virtual void solve(const MultiVector& b, MultiVector& x) = 0;

  virtual const FactorizationMemory& memory() const = 0;
  /// Before analyze(): go on as one with that memory.
  virtual void remember(FactorizationMemory memory) = 0;
};

/// CHOLMOD (Chen, Davis, Hager and Rajamanickam 2008): symmetric matrices, on the first rank, which gathers them from
/// all; the row map's ranges must follow each other in rank order, as a DofSpace's do. Supernodal Cholesky where the
/// matrix is large; simplicial L D L^T where it is small, and from the first matrix on that is not positive definite.
/// Of an unsymmetric matrix it takes the lower triangle for both: a preconditioner, not a solver.
/// In a build with IXOS_CHOLMOD only.
std::unique_ptr<Factorization> make_cholmod();

/// KLU (Davis and Palamadai Natarajan 2010): any matrix, on the first rank likewise. The pivots of one matrix serve for
/// the next as long as they can.
std::unique_ptr<Factorization> make_klu();

/// MUMPS (Amestoy, Duff, L'Excellent and Koster 2001): symmetric matrices, L D L^T without pivoting, on all ranks. On
/// several ranks it decides as messages come in: results repeat up to rounding only. In single precision it takes half
/// the memory and time: a preconditioner.
std::unique_ptr<Factorization> make_mumps(bool single_precision);

/// Returns the names of the factorisations in this build: "CHOLMOD" (built with IXOS_CHOLMOD only), "KLU", "MUMPS",
/// "MUMPS Single".
std::vector<std::string> factorizations();

/// Returns the fastest of them for small symmetric matrices: CHOLMOD, or KLU in a build without it.
std::string first_rank_factorization();

/// Makes the factorisation of that name.
std::unique_ptr<Factorization> make_factorization(const std::string& type);

/// A factorisation and the matrix that it belongs to.
class KeptFactorization {
 public:
  /// Numeric phase for the matrix's present values; symbolic phase, with a factorisation of that type, where it is
  /// another matrix object than last time. Throws std::runtime_error.
  void renew(const Teuchos::RCP<const CrsMatrix>& matrix, const std::string& type);
  /// x = A^-1 b for each column.
  void solve(const MultiVector& b, MultiVector& x) const { factorization_->solve(b, x); }

  /// For checkpoints. What was loaded counts from the next matrix on.
  void transfer(Record& record);

 private:
  Teuchos::RCP<const CrsMatrix> matrix_;
  std::unique_ptr<Factorization> factorization_;
  FactorizationMemory loaded_;
};

/// The list that chooses one: "Solver Type".
Teuchos::RCP<const Teuchos::ParameterList> factorization_parameters();

}  // namespace ixos
