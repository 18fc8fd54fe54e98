/// Linear solvers, chosen by a Stratimikos list.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>

#include "base/tpetra.hpp"

namespace Thyra {
template <class Scalar>
class LinearOpWithSolveFactoryBase;
}

namespace ixos {

class Model;

/// What the iterative solvers of a factory did so far.
struct LinearStatistics {
  long iterations = 0;
  long setups = 0;  ///< of preconditioners
};

/// Builds solvers from a scene's "Linear Solver" list: a Stratimikos list, with three additions. "Linear Solver Type"
/// is "Direct", "Belos" or "Amesos2"; "Direct" is ours: it keeps the symbolic factorisation, and its list, "Linear
/// Solver Types/Direct", has the one entry "Solver Type" (see make_factorization). Preconditioners are MueLu's (null
/// space and coordinates are given to it), Ifpack2's and our own "Direct", a factorisation with the same list, and
/// "Chebyshev" (see ChebyshevPreconditionerFactory); they outlive the matrix that they were made from, as the list
/// "Reuse" says: its "Setup Cost" is the price of a new preconditioner in Krylov iterations, 0 renews it for every
/// matrix (see LaggedSolverFactory). "Operator" is "Assembled" or "Matrix-Free": then a matrix is made only for a new
/// preconditioner.
class LinearSolverFactory {
 public:
  /// The list must be complete (see completed_linear_solver). Without a model MueLu gets neither null space nor
  /// coordinates. Preconditioners that are not `restartable` save the memory of the matrices that they came from.
  /// Throws InputError, with Stratimikos' own words, where the list is not valid. Collective.
  explicit LinearSolverFactory(const Teuchos::ParameterList& list, const Model* model = nullptr,
                               bool restartable = true);
  ~LinearSolverFactory();
  LinearSolverFactory(const LinearSolverFactory&) = delete;
  LinearSolverFactory& operator=(const LinearSolverFactory&) = delete;

  /// A Thyra factory of its own for each caller, so that what its operators keep is the caller's (see StateKeeper).
  Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> strategy() const;
  const LinearStatistics& statistics() const;
  /// Are tangents to be applied without a matrix?
  bool matrix_free() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// One operator and its solver, outside Newton's method: initial accelerations, collocated accelerations.
class LinearSystem {
 public:
  /// A matrix must be fill-complete; its values are read at the first solve and after every refresh().
  LinearSystem(const LinearSolverFactory& factory, const Teuchos::RCP<const Operator>& op);
  ~LinearSystem();
  LinearSystem(const LinearSystem&) = delete;
  LinearSystem& operator=(const LinearSystem&) = delete;

  /// x = A^-1 b, to a relative residual of 1e-12 where the solver is iterative. False where the solve failed.
  /// Collective.
  bool solve(const Vector& b, Vector& x);
  void refresh();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
