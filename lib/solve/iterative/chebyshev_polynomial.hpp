/// Chebyshev's polynomial of an operator.
#pragma once
#include <vector>

#include "base/record.hpp"
#include "base/tpetra.hpp"

namespace ixos {

/// p(D^-1 W) D^-1, D the diagonal of W and p Chebyshev's polynomial for the upper part of the spectrum of D^-1 W (Saad
/// 2003, algorithm 12.1). Ten steps of Lanczos' method estimate the spectrum. If W outgrows the estimate, p stays
/// positive definite for odd degrees.
class ChebyshevPolynomial {
 public:
  struct Settings {
    int degree = 3;     ///< applications of D^-1; one product with W less
    double ratio = 20;  ///< at most, of the largest eigenvalue to the least that p covers
    double margin = 1;  ///< factor of the largest eigenvalue's estimate
  };

  /// Takes the diagonal and the spectrum of W, an AssemblableOperator or a CrsMatrix; D has the magnitudes of the
  /// diagonal. Those that transfer() loaded take their place once. Throws std::runtime_error if an entry of the
  /// diagonal is zero or not a number, InputError if a loaded diagonal is not of W's size or not positive. Collective.
  void initialize(const Teuchos::RCP<const Operator>& op, const Settings& settings);
  /// Returns p(D^-1 W) D^-1 b, valid until the next call.
  const MultiVector& operator()(const MultiVector& b) const;

  /// Writes or reads the diagonal and the spectrum. Throws InputError if the spectrum is not valid.
  void transfer(Record& record);
  /// Returns whether transfer() has loaded what the next initialize() will take.
  bool waits() const { return waits_; }

 private:
  struct Spectrum {
    double least = 0;    ///< an estimate, too large
    double largest = 0;  ///< an estimate that is seldom exceeded
  };
  static Spectrum spectrum_of(std::vector<double> diagonal, std::vector<double> beside, double next);
  Spectrum estimate_spectrum() const;
  void restore();
  void invert_diagonal();

  Teuchos::RCP<const Operator> op_;
  Settings settings_;
  Spectrum spectrum_;
  Teuchos::RCP<Vector> inverse_diagonal_;
  bool waits_ = false;
  std::vector<double> loaded_;                               ///< inverse diagonal
  mutable Teuchos::RCP<MultiVector> residual_, step_, sum_;  ///< scratch
};

}  // namespace ixos
