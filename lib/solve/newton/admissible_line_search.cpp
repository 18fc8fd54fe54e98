#include "solve/newton/admissible_line_search.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Solver_Generic.H>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Tpetra_Vector.hpp>

#include "solve/newton/nox_vector.hpp"

namespace ixos {

namespace {

/// A potential and its slope at one end of the step.
struct End {
  double value;
  double slope;
};

/// Number of times that a step is shortened at most if there is no potential.
constexpr int shortenings = 6;

/// Number of steps in which the potential may be above that of the first one's start.
constexpr int watched_steps = 5;

/// Number of times that a step is lengthened at most, the least and the largest factor, and the share of the first
/// slope above which it is.
constexpr int lengthenings = 4;
constexpr double least_factor = 1.3, largest_factor = 3, steep = 0.2;

/// Takes the group to a place.
void go(NOX::Abstract::Group& group, const Vector& place) {
  const auto x = group.getX().clone(NOX::ShapeCopy);
  tpetra(*x)->assign(place);
  group.setX(*x);
}

/// Returns the place in [0, 1] where the secant through the slopes at both ends is zero, kept within [0.1, 0.6].
double zero_between(double slope, double end_slope) { return std::clamp(slope / (slope - end_slope), 0.1, 0.6); }

/// Returns the place in [0, 1] of the minimum of the cubic through both ends, kept within [0.1, 0.6].
double valley(const End& start, const End& end) {
  const double a = start.slope + end.slope - 2 * (end.value - start.value);
  const double b = 3 * (end.value - start.value) - 2 * start.slope - end.slope;
  const double root = std::sqrt(std::max(b * b - 3 * a * start.slope, 0.0));
  const double place = -start.slope / (b + root);  // of 3 a s^2 + 2 b s + slope = 0, without cancellation
  return std::isfinite(place) && place > 0 ? std::clamp(place, 0.1, 0.6) : 0.5;
}

}  // namespace

bool AdmissibleLineSearch::compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
                                   const NOX::Solver::Generic& solver) {
  const NOX::Abstract::Group& old = solver.getPreviousSolutionGroup();
  if (solver.getNumIterations() <= 1) {
    cut_start_ = Teuchos::null;
    watch_ = {};
  }
  cut_ = false;
  if (!search(group, step, direction, old, solver.getNumIterations())) return false;
  if (nonnull(watch_.start)) watch(group);
  const Teuchos::RCP<const Vector> before = std::exchange(cut_start_, Teuchos::null);
  if (!cut_) return true;
  if (nonnull(before))
    follow_ravine(group, *before);
  else
    cut_start_ = Teuchos::rcp(new Vector(*tpetra(old.getX()), Teuchos::Copy));
  return true;
}

bool AdmissibleLineSearch::search(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
                                  const NOX::Abstract::Group& old, int number) {
  const auto along = tpetra(direction), from = tpetra(old.getX());
  const bool gradient = problem_.is_gradient();  // at the old iterate, the last that was evaluated
  const bool mixed = problem_.has_mixed_steps();
  const bool kinks = problem_.has_kinks() && !(mixed && number <= watched_steps);
  const double slope = gradient || kinks ? inner_product(*tpetra(old.getF()), *along) : 0.0;
  std::optional<Potential> start;
  int hidden_cuts = 0;
  step = problem_.admissible_step(*from, *along);
  for (int trial = 0; trial < 25 && step > 0; ++trial) {
    group.computeX(old, direction, step);
    // Thyra drops the mark of a failed evaluation on its way to NOX; the NaN in f stays.
    if (group.computeF() != NOX::Abstract::Group::Ok || !std::isfinite(group.getNormF())) {
      step /= 2;
      continue;
    }
    if (!(gradient || kinks) || !(slope < 0)) return true;
    const double end_slope = inner_product(*tpetra(group.getF()), *along);
    if (!gradient) {
      // The step must not end far beyond the place where f . direction vanishes (Matthies and Strang 1979).
      if (end_slope <= -0.8 * slope || trial >= shortenings) return true;
      step *= zero_between(slope, end_slope);
      continue;
    }
    if (trial == 0 && step == 1 && end_slope < steep * slope) {
      step = lengthened(group, {*from, *along}, {slope, end_slope});
      if (mixed) problem_.leave_mixed_steps(true);
      return true;
    }
    if (end_slope <= 0.2 * -slope && end_slope >= -0.9 * -slope) return true;
    if (nonnull(watch_.start)) return true;
    if (!start) start = problem_.potential(*from);
    const Potential end = problem_.potential(*tpetra(group.getX()));
    const double noise = 1e-14 * (start->magnitude + end.magnitude);
    const bool hidden = std::abs(end.value - start->value) <= noise;
    // A cycle never halves |f|.
    const bool done = end_slope <= -0.9 * slope || group.getNormF() <= 0.5 * old.getNormF();
    if (hidden ? done || ++hidden_cuts > shortenings : end.value <= start->value + 1e-4 * step * slope) return true;
    if (mixed && !hidden && !cut_) {
      watch_ = {Teuchos::rcp(new Vector(*from, Teuchos::Copy)), start->value, 0};
      return true;
    }
    step *=
        hidden ? zero_between(slope, end_slope) : valley({start->value, step * slope}, {end.value, step * end_slope});
    cut_ = true;
  }
  step = 0;  // tells NOX that the search failed
  return false;
}

void AdmissibleLineSearch::watch(NOX::Abstract::Group& group) {
  const Potential here = problem_.potential(*tpetra(group.getX()));
  if (here.value <= watch_.potential + 1e-14 * here.magnitude) {
    watch_.start = Teuchos::null;
    return;
  }
  const bool ends = group.getNormF() <= problem_.convergence_bound(tolerance_) || problem_.is_lost();
  if (++watch_.steps < watched_steps && !ends) return;
  go(group, *watch_.start);
  group.computeF();
  problem_.leave_mixed_steps(false);
  watch_.start = Teuchos::null;
}

double AdmissibleLineSearch::slope_at(NOX::Abstract::Group& group, const Line& line, double step) const {
  Vector way(line.along, Teuchos::Copy);
  way.scale(step);
  if (problem_.admissible_step(line.from, way) < 1) return std::numeric_limits<double>::quiet_NaN();
  way.update(1.0, line.from, 1.0);
  go(group, way);
  const bool done = group.computeF() == NOX::Abstract::Group::Ok && std::isfinite(group.getNormF());
  return done ? inner_product(*tpetra(group.getF()), line.along) : std::numeric_limits<double>::quiet_NaN();
}

double AdmissibleLineSearch::lengthened(NOX::Abstract::Group& group, const Line& line, Slopes slopes) const {
  double step = 1, before = 0, reached = 1;
  double slope_before = slopes.start, slope = slopes.end;
  for (int i = 0; i < lengthenings && slope < steep * slopes.start; ++i) {
    double next = largest_factor * step;
    if (slope > slope_before)
      next = std::clamp(step - slope * (step - before) / (slope - slope_before), least_factor * step, next);
    double next_slope = slope_at(group, line, reached = next);
    if (next_slope > -0.2 * slopes.start) {  // beyond the minimum
      next = step + (next - step) * std::clamp(slope / (slope - next_slope), 0.1, 0.9);
      next_slope = slope_at(group, line, reached = next);
      if (std::isfinite(next_slope)) return next;
    }
    if (!std::isfinite(next_slope)) break;
    before = step;
    slope_before = slope;
    step = next;
    slope = next_slope;
  }
  if (reached != step) slope_at(group, line, step);
  return step;
}

void AdmissibleLineSearch::follow_ravine(NOX::Abstract::Group& group, const Vector& start) const {
  const Vector here(*tpetra(group.getX()), Teuchos::Copy);
  Vector along(here, Teuchos::Copy);
  along.update(-1.0, start, 1.0);
  const Line line{here, along};
  const double slope = inner_product(*tpetra(group.getF()), along);
  if (!(slope < 0)) return;
  const Potential before = problem_.potential(here);
  const double norm = group.getNormF();
  const double end_slope = slope_at(group, line, 1);
  if (std::isfinite(end_slope)) {
    if (end_slope < steep * slope)
      lengthened(group, line, {slope, end_slope});
    else if (end_slope > -0.2 * slope)
      slope_at(group, line, slope / (slope - end_slope));
    if (std::isfinite(group.getNormF()) && problem_.is_gradient()) {
      const Potential after = problem_.potential(*tpetra(group.getX()));
      const double fall = before.value - after.value, noise = 1e-14 * (before.magnitude + after.magnitude);
      if (fall > noise || (fall >= -noise && group.getNormF() < norm)) return;
    }
  }
  go(group, here);
  group.computeF();
}

}  // namespace ixos
