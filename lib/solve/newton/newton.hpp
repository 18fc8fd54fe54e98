/// Newton's method: NOX on a NonlinearProblem.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <memory>
#include <string>

#include "base/record.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/newton/nonlinear_problem.hpp"

namespace ixos {

/// Where Newton's method stands.
struct NewtonIterate {
  int iteration = 0;    ///< 0: the guess
  double residual = 0;  ///< |f| [-]
  double bound = 0;     ///< below which the method has converged
};

struct NewtonOptions {
  double tolerance = 1e-11;      ///< relative: see NonlinearProblem::convergence_bound
  int maximum_iterations = 100;  ///< NOX iterations; more is a failed solve, see also snap_iterations
  Teuchos::ParameterList nox;    ///< overrides of NOX's own list
  double linear_tolerance = 0;   ///< relative residual of the linear solves; 0: a ForcingTerm sets it
  /// After convergence, solve once more with the last residual and the last tangent, if a factorisation is kept. The
  /// iteration ends just below its bound, always on the same side: over a million steps such errors add up to a drift.
  bool corrects = false;
  /// Further iterations of an Integrator without inertia: a body that snaps goes a long way down the potential to its
  /// next equilibrium.
  int snap_iterations = 1000;
  bool mixed_steps = true;                            ///< see NonlinearProblem::has_mixed_steps()
  std::function<void(const NewtonIterate&)> watch{};  ///< called for each iterate, on every rank; may be empty
};

/// Returns whether a problem may have mixed steps: another line search or direction of NOX knows nothing of them.
bool allows_mixed_steps(const NewtonOptions& options);

/// The result of a solve. A failure is a status, not an exception.
struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  std::string reason;    ///< of a failure, for the user
  bool ran_out = false;  ///< the failure is that the iterations were used up
};

/// One solver for one problem, kept for the whole run and reset for each solve.
class NewtonSolver {
 public:
  /// Throws InputError if NOX refuses its list.
  NewtonSolver(NonlinearProblem& problem, const LinearSolverFactory& linear_solver, const NewtonOptions& options);
  ~NewtonSolver();
  NewtonSolver(const NewtonSolver&) = delete;
  NewtonSolver& operator=(const NewtonSolver&) = delete;

  /// Solves f(x) = 0 from the guess x. On failure x is the last iterate. Collective.
  NewtonResult solve(Vector& x);

  /// Writes or reads, between solves, the state that the linear solver keeps from one matrix to the next. Collective.
  void transfer(Record& record);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
