/// Time rules on a segment: how a force is averaged over a stage of a scheme.
#pragma once
#include <vector>

namespace ixos {

/// How a displacement moves between the known state and the stage's unknown.
enum class Path {
  Linear,    ///< u(xi) = u_from + xi (u_s - u_from)
  Kinematic  ///< u(xi) = u_from + xi h v_from + xi^2 (u_s - u_from - h v_from), h the length of the stage
};

/// One time point: u(xi) = from u_from + velocity h v_from + to u_s. The force counts with `weight`, the tangent with
/// weight times du(xi)/du_s = `to`.
struct RulePoint {
  double weight;
  double from;
  double velocity;
  double to;
  double time = 1;  ///< xi, the share of the segment's time that has passed
};

/// The kind of mean. Exact and DiscreteGradient have neither points nor a kept part:
/// - Exact, F = int_0^1 f(u(xi)) dxi over the straight path in closed form: for interactions whose law has one;
/// - DiscreteGradient, a force with F . (u_s - u_from) = Pi(u_s) - Pi(u_from) exactly, objective, F = f(u) if both ends
///   are u. Its tangent is unsymmetric. For interactions with a flat wall it is the exact mean.
enum class Mean { Points, Exact, DiscreteGradient };

/// F = sum_i weight_i f(u(xi_i)) + kept_weight f(u_from), or another Mean. Points at xi = 0 do not depend on the
/// unknown: `kept_weight` gathers them.
struct Rule {
  std::vector<RulePoint> points;
  double kept_weight = 0;
  Mean mean = Mean::Points;

  /// Returns whether the force depends on the displacement at the start of the segment.
  bool uses_start() const;
  /// Returns whether some point uses the velocity of the known state.
  bool uses_velocity() const;
  /// Returns whether the end of the segment is one of the points.
  bool has_end() const;
  /// Returns whether the force is a gradient in u_s, and hence its tangent symmetric.
  bool is_gradient() const { return mean != Mean::DiscreteGradient; }
  /// Returns whether the force is a mean over the straight path, by at least two points that are exact for quadratic
  /// functions, or in closed form.
  bool is_path_mean() const;
  /// Returns the sum of all weights: 1 for a consistent rule.
  double total_weight() const;
  /// Returns the derivative of the points' mean displacement by u_s: the share of the stiffness in the tangent.
  double end_weight() const;
  /// Returns the mean time of the points, a share of the segment's; 1/2 for a mean over the path, 1 without points.
  double mean_time() const;
};

/// Returns the rule for the force at the end of the segment, times `weight`.
Rule end_rule(double weight = 1);

/// Returns the rule with points xi in [0, 1] and these weights.
Rule point_rule(const std::vector<double>& xi, const std::vector<double>& weights, Path path = Path::Linear);

/// Returns the exact mean over the straight path.
Rule exact_rule();

/// Returns the discrete gradient of the energy.
Rule discrete_gradient_rule();

/// Returns the mean by n Gauss-Legendre points. Throws InputError unless 1 <= n <= 64.
Rule gauss_rule(int n, Path path = Path::Linear);

}  // namespace ixos
