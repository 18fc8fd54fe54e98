/// A one-step scheme as a table.
#pragma once
#include <string>
#include <vector>

#include "rule/rate_form.hpp"
#include "rule/row.hpp"
#include "rule/rule.hpp"
#include "rule/work_sum.hpp"
#include "term/body/mass.hpp"
#include "term/support/loads.hpp"

namespace ixos {

/// One stage solves for one displacement u_s:
///   (1/dt^2) M inertia(u_s) + (1/dt) C damping(u_s) + rates + elastic rule + interaction rule = sum_i w_i f_ext(t_i),
/// the rules on the segment from the step's start to u_s. Then dt v_s = velocity(u_s), dt^2 a_s = acceleration(u_s).
/// `rates` are forces that depend on rates of strain, see RateForm. The left side is the gradient of an incremental
/// potential, sum_i (w_i/to_i) Pi(u(xi_i)) and quadratic forms in the inertia and damping rows, unless a rule is a
/// discrete gradient or the rates have the form Middle.
struct Stage {
  double end = 1;  ///< time of u_s in steps from the step's start
  Row velocity;
  Row acceleration;
  Row inertia;  ///< dt^2 times what M multiplies
  Row damping;  ///< dt times what C multiplies
  Rule elastic;
  Rule interaction;
  RateForm rate_form = RateForm::End;  ///< of terms that depend on rates of strain
  double rate_start = 0;               ///< End: weight of their force at the step's start
  std::vector<TimePoint> load;         ///< times t_i in steps from the step's start, and weights w_i
  /// If the rules have no potential: rules for elasticity and interaction that have one, with a solution nearby. If
  /// Newton's iteration fails, it restarts from that solution.
  std::vector<Rule> nearby{};
};

/// How the acceleration at the end of a step is found.
enum class Closing {
  Kinematic,  ///< from the last stage's row, which satisfies the balance at the end of the step; driven degrees of
              ///< freedom take the exact velocity and acceleration of their motion
  Collocate,  ///< from M a = f_ext - C v - f at the end of the step, if it is asked for; momentum-form schemes,
              ///< whose recursion rings; driven degrees of freedom take the scheme's own velocity
  Explicit    ///< the same with the velocity row for v, whereupon v = v_n + dt (a_n + a)/2; driven degrees of freedom
              ///< take the exact velocity and acceleration of their motion
};

/// The start of Newton's iteration: u_k + h v_k + h^2/2 a_k, cut after the first, second or third part, from the latest
/// known state k, h to the stage's end; Newmark's predictor for beta = 1/4, with h^2/4 a_k; or the straight line
/// through the starts of this step and the one before (Extrapolation); the parabola through these and the start of the
/// step before that (Quadratic); or, of the first two, the line and the parabola, the one that was nearest to the end
/// of the last step (Nearest, see guess_error()). Always clipped to admissible gaps.
enum class Predictor {
  LastDisplacement,
  ConstantVelocity,
  ConstantAcceleration,
  Newmark,
  Extrapolation,
  Quadratic,
  Nearest
};

/// Velocity and acceleration of driven degrees of freedom: those of their motion, or those of the scheme. Schemes in
/// momentum form take the scheme's in any case.
enum class DrivenRates { Exact, Own };

struct Table {
  std::string name;
  std::vector<Stage> stages;
  Closing closing = Closing::Kinematic;
  WorkSum work;
  Predictor predictor = Predictor::LastDisplacement;  ///< the one that takes the fewest iterations at an impact
  DrivenRates driven_rates = DrivenRates::Exact;
  Inertia mass = Inertia::Consistent;  ///< None if the table has no inertia
  /// The factor in the local error of displacements, error_constant dt^3 u''', in the limit of short steps; 0 if not
  /// known.
  double error_constant = 1.0 / 12;
  /// Gauss points of the interaction's mean along the straight path, if their number may change from step to step;
  /// otherwise 0.
  int interaction_points = 0;
  /// Largest change of the energy balance in a step, over the largest energy, that a scheme which conserves energy
  /// promises for rounding and for the elastic force's points in time; 0: it promises nothing. The interaction's points
  /// add quadrature_error().
  double energy_promise = 0;
  double safety = 1;  ///< explicit schemes: share of the stable step that a run uses
};

/// Returns whether the table has one stage, without an unknown in its forces. Its step is then a division by a lumped
/// mass, without Newton's method, NOX and matrices.
bool is_explicit(const Table& table);

/// Returns the mean over the path of an interaction: n Gauss points, or in closed form if n is 0 (linear path only;
/// throws std::invalid_argument).
Rule mean_rule(int n, Path path = Path::Linear);

/// Returns a bound of the error that n Gauss points make in the energy of an r^-8 law over a step in which gaps change
/// by the ratio q, as a share of the energy: 1e9 rho^(-2n), rho = (sqrt(q) + 1)/(sqrt(q) - 1). The pole at gap 0 lies
/// on that Bernstein ellipse of the path (Trefethen 2019, theorem 19.3). The factor lies above those of the measured
/// 1e-5 at 5, 8 and 16 points for ratios of 1.4, 2 and 5. Returns 0 for n = 0, the mean in closed form.
double quadrature_error(int n, double gap_ratio);

/// Returns a bound of the error that n Gauss points of the elastic force make in the energy over a step in which edges
/// of cells change by that share of their length (see edge_change()), as a share of the energy: 1e4 rho^(-2n). Elastic
/// laws have their pole where a cell collapses, det F = 0; an edge c long half-way, which changes by s c, would vanish
/// at a distance of 2/s half-steps from there, on the Bernstein ellipse rho = z + sqrt(z^2 - 1), z = 2/s. The factor
/// lies above those of the measured 4e-4, 5e-7, 7e-9 and 2e-11 at 2, 3, 4 and 5 points for changes of about 0.15.
/// Returns 0 for n = 0.
double elastic_quadrature_error(int n, double edge_change);

/// Returns n Gauss points over the step, 8 if n is 0.
std::vector<TimePoint> gauss_times(int n);

/// Returns whether the table has no inertia. Its rows for velocity are then du/dt, and those for acceleration, inertia
/// and damping zero.
bool is_static(const Table& table);

/// Returns whether driven degrees of freedom take the exact velocity and acceleration of their motion.
bool has_exact_rates(const Table& table);

/// Returns whether the tangents of two stages weigh mass, damping and forces alike, to a factor of 2. The inverse of
/// one is then a preconditioner of the other with a condition number of at most 4 (1.8 for Bathe's two halves).
bool have_like_tangents(const Stage& a, const Stage& b);

/// Throws std::invalid_argument, with the stage and the row, unless rule weights sum to 1 and the velocity,
/// acceleration, inertia and damping rows reproduce u = 1, t and t^2 (inertia and damping rows: the mean of u'' and u'
/// that the rules stand for; for t^2 the damping row may be off the stage's end, as u'(mean)).
void check(const Table& table);

}  // namespace ixos
