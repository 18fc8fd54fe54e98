#include "scene/read/newton_options.hpp"

#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

const Options<NewtonOptions>& options() {
  static const Options<NewtonOptions> all =
      Options<NewtonOptions>()
          .add("Tolerance", &NewtonOptions::tolerance,
               "Convergence tolerance: the norm of the residual over the largest of the norms of inertia, elastic, "
               "interaction and external forces [-]. Ixos does not go below the rounding of these forces: in a scene "
               "with large rigid motions or a stiff contact, all smaller tolerances give the same results.",
               greater_and_less_than(0, 1))
          .add("Linear Tolerance", &NewtonOptions::linear_tolerance,
               "Relative residual of iterative linear solves [-]. With 0, Eisenstat and Walker's forcing terms choose "
               "it, at most 1e-3.",
               at_least(0))
          .add("Maximum Iterations", &NewtonOptions::maximum_iterations,
               "Largest number of Newton iterations. A step that needs more fails; with Static see Snap Iterations.",
               between(1, 10000))
          .add("Snap Iterations", &NewtonOptions::snap_iterations,
               "Static: number of Newton iterations that a step may take after Maximum Iterations, because a body that "
               "snaps has a long way to go to its next equilibrium.",
               between(0, 100000))
          .add("Mixed Steps", &NewtonOptions::mixed_steps,
               "In a nearly incompressible body (Poisson's ratio above 0.45) tangents take the stress of the change of "
               "volume as the iteration before predicted it, as Newton's method for displacement and pressure does. "
               "That takes some iterations in place of tens or hundreds; the solution is the same. Enhanced cells take "
               "no such steps.")
          .free_form("NOX", &NewtonOptions::nox,
                     "Overrides lists of NOX: Printing, Direction, Line Search, ... Another Line Search replaces the "
                     "one that keeps gaps positive; another Direction replaces the one that corrects tangents that are "
                     "not positive definite.");
  return all;
}

}  // namespace

void declare_newton(Teuchos::ParameterList& list) { options().declare(list); }

NewtonOptions read_newton(const SceneNode& nonlinear_solver) { return options().read(nonlinear_solver); }

}  // namespace ixos
