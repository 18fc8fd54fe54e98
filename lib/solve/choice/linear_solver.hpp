/// Linear solvers, chosen by a Stratimikos list.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>

#include "base/tpetra.hpp"
#include "solve/linear_statistics.hpp"

namespace Thyra {
template <class Scalar>
class LinearOpWithSolveFactoryBase;
}

namespace ixos {

class Model;
class OperatorPreconditioner;

/// A factory of solvers from a scene's "Linear Solver" list: a Stratimikos list, with three additions. "Linear Solver
/// Type" is "Direct", "Belos" or "Amesos2". "Direct" belongs to Ixos: it keeps the symbolic factorisation, and its
/// list, "Linear Solver Types/Direct", has the one entry "Solver Type" (see make_factorization). Preconditioners are
/// MueLu's (null space and coordinates are given to it), Ifpack2's and three of Ixos: "Direct", a factorisation with
/// the same list, "Chebyshev" (see ChebyshevPreconditionerFactory) and "Two-Level", for matrix-free tangents of
/// quadratic cells or linear ones with coarse cells (see TwoLevelPreconditionerFactory). They outlive the matrix that
/// they were made from, as the list "Reuse" says: its "Setup Cost" is the price of a new preconditioner in Krylov
/// iterations, 0 renews it for every matrix (see LaggedSolverFactory). "Operator" is "Assembled" or "Matrix-Free": then
/// a matrix is made only for a new preconditioner.
class LinearSolverFactory {
 public:
  /// The list must be complete (see completed_linear_solver). Without a model MueLu gets neither null space nor
  /// coordinates. Preconditioners that are not `restartable` save the memory of the matrices that they came from.
  /// Throws InputError, with Stratimikos' message, if the list is not valid. Collective.
  explicit LinearSolverFactory(const Teuchos::ParameterList& list, const Model* model = nullptr,
                               bool restartable = true);
  ~LinearSolverFactory();
  LinearSolverFactory(const LinearSolverFactory&) = delete;
  LinearSolverFactory& operator=(const LinearSolverFactory&) = delete;

  /// Returns a new Thyra factory at each call, so that each caller owns the state of its operators (see StateKeeper).
  /// It may outlive this.
  Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> strategy() const;
  /// Returns a new preconditioner of the list's type, which does not renew itself; null if the list has none. It may
  /// outlive this.
  Teuchos::RCP<OperatorPreconditioner> preconditioner() const;
  const LinearStatistics& statistics() const;
  /// Returns whether tangents are to be applied without a matrix.
  bool matrix_free() const;

 private:
  struct Implementation;
  std::shared_ptr<Implementation> implementation_;  ///< also of all that is handed out
};

/// One operator and its solver, outside Newton's method: initial accelerations, collocated accelerations.
class LinearSystem {
 public:
  /// A matrix must be fill-complete; its values are read at the first solve and after every refresh().
  LinearSystem(const LinearSolverFactory& factory, const Teuchos::RCP<const Operator>& op);
  ~LinearSystem();
  LinearSystem(const LinearSystem&) = delete;
  LinearSystem& operator=(const LinearSystem&) = delete;

  /// Sets x = A^-1 b, to a relative residual of 1e-12 if the solver is iterative. Returns false if the solve failed.
  /// Collective.
  bool solve(const Vector& b, Vector& x);
  void refresh();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
