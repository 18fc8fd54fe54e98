/// Sparse factorisations behind the direct solver.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/record.hpp"
#include "base/tpetra.hpp"

namespace ixos {

/// The state that a factorisation keeps from matrix to matrix.
struct FactorizationMemory {
  bool indefinite = false;         ///< some matrix was not positive definite
  std::vector<double> pivots_for;  ///< on the first rank: the values that the order of pivots was chosen for
  bool operator==(const FactorizationMemory& other) const {
    return indefinite == other.indefinite && pivots_for == other.pivots_for;
  }
};

class FirstRankFactorization;

/// A factorisation of one matrix, whose sparsity stays: analyze() once, factor() for each set of values.
class Factorization {
 public:
  virtual ~Factorization() = default;
  /// Does the symbolic phase. Throws std::runtime_error if the sparsity is structurally singular.
  virtual void analyze(const Teuchos::RCP<const CrsMatrix>& matrix) = 0;
  /// Returns, after analyze(), whether another factorisation should not take its place. Same on all ranks.
  virtual bool suits() const { return true; }
  /// Does the numeric phase, from the matrix's present values. Throws std::runtime_error if a pivot vanishes.
  virtual void factor() = 0;
  /// Sets x = A^-1 b for each column.
  virtual void solve(const MultiVector& b, MultiVector& x) = 0;

  virtual const FactorizationMemory& memory() const = 0;
  /// Restores the memory of an earlier factorisation. Must be called before analyze().
  virtual void remember(FactorizationMemory memory) = 0;
};

/// Makes CHOLMOD (Chen, Davis, Hager and Rajamanickam 2008): symmetric matrices, on the first rank, which gathers them
/// from all; the row map's ranges must follow each other in rank order, as a DofSpace's do. Uses supernodal Cholesky
/// for large matrices. Uses simplicial L D L^T for small ones, and from the first matrix on that is not positive
/// definite. Takes the lower triangle of an unsymmetric matrix for both triangles: as a preconditioner, not as a
/// solver. In a build with IXOS_CHOLMOD only.
std::unique_ptr<Factorization> make_cholmod();

/// Makes L D L^T of a band (band_ldu.hpp): symmetric matrices, on the first rank likewise. It orders the rows as
/// Cuthill and McKee (1969) do. A slender body then has a narrow band, for which no other is as fast. It does
/// not suit wide bands. It reads one entry of each pair of an unsymmetric matrix: as a preconditioner,
/// not as a solver.
std::unique_ptr<Factorization> make_band();

/// Makes L D U of a band likewise: any matrix whose sparsity is symmetric. KLU factors those whose pivots get too
/// small.
std::unique_ptr<Factorization> make_band_lu();

/// Makes KLU (Davis and Palamadai Natarajan 2010): any matrix, on the first rank likewise. The pivots of one matrix
/// serve for the next as long as they can.
std::unique_ptr<FirstRankFactorization> make_klu();

/// Returns the names of the factorisations in this build: "CHOLMOD" (built with IXOS_CHOLMOD only), "Band",
/// "Band LU", "KLU", "MUMPS", "MUMPS Single".
std::vector<std::string> factorizations();

/// Returns the fastest of them for small symmetric matrices of any shape: CHOLMOD, or KLU in a build without it.
std::string first_rank_factorization();

/// Makes the factorisation of that name.
std::unique_ptr<Factorization> make_factorization(const std::string& type);

/// A factorisation and the matrix that it belongs to.
class KeptFactorization {
 public:
  /// Does the numeric phase for the matrix's present values. If the matrix is another object than last time, does the
  /// symbolic phase first, with a factorisation of that type. If that does not suit the matrix, KLU takes the place of
  /// "Band LU", first_rank_factorization() that of "Band". Throws std::runtime_error.
  void renew(const Teuchos::RCP<const CrsMatrix>& matrix, const std::string& type);
  /// Sets x = A^-1 b for each column.
  void solve(const MultiVector& b, MultiVector& x) const { factorization_->solve(b, x); }

  /// Returns the factorisation if the first rank applies it alone, else null. Not collective.
  FirstRankFactorization* on_first_rank() const;

  /// Writes or reads the state for checkpoints. A loaded state takes effect with the next matrix. The present
  /// factorisation stays if its state is the one that a record in memory has. Collective.
  void transfer(Record& record);

 private:
  Teuchos::RCP<const CrsMatrix> matrix_;
  std::unique_ptr<Factorization> factorization_;
  FactorizationMemory loaded_;
};

/// Returns the list that chooses one: "Solver Type".
Teuchos::RCP<const Teuchos::ParameterList> factorization_parameters();

}  // namespace ixos
