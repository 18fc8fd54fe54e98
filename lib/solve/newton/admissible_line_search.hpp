/// NOX line search that stays in the admissible region and decreases the problem's potential.
#pragma once
#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>

#include "solve/newton/nonlinear_problem.hpp"

namespace ixos {

/// A line search that takes the full Newton step, shortened to the problem's admissible step, and halved if the
/// residual cannot be evaluated there all the same (an inverted element). If the residual is a gradient, the potential
/// must fall. A step is accepted if the slope along the direction at its end is between -0.9 and 0.2 times the start's
/// magnitude. Otherwise the potential is evaluated, and unless it has fallen (Armijo), the step is shortened to the
/// minimum of the cubic through values and slopes of both ends. If rounding hides the change of the potential, the
/// secant through the slopes shortens the step, at most six times, until |f| has halved or the slope at its end is at
/// most 0.9 of the start's magnitude. Good Newton steps therefore cost no evaluation of the potential.
///
/// A full step is lengthened, to at most 81 times, while the slope at its end has more than 0.2 of the start's
/// magnitude: as a body snaps off, the potential falls along many full steps, because the tangent that was made
/// positive definite is too stiff. The secant through the slopes at the last two places leads to the next, between 1.3
/// and 3 times as far; from behind the minimum it leads back once. Each place takes a residual, a small part of a
/// Newton iteration.
///
/// Where the gradient has kinks, as beside the corners of a faceted surface, steps zigzag along a ravine of the
/// potential, each shortened to the ravine's floor. After two of them the search takes the line from the start
/// of the first to the end of the second, at most 81 times as far. It stays there if the potential has fallen, or if
/// |f| has while rounding hides the change of the potential (parallel tangents: Shah, Buehler and Kempthorne 1964).
///
/// Where a problem has mixed steps, the search does not shorten a step whose potential rises but watches: if the
/// potential is below that of the first such step's start within five steps, they were good; if not, or if they end at
/// an equilibrium above it or far away, it returns there, and the rest of the solve has no mixed steps (the watchdog
/// technique: Chamberlain, Powell, Lemarechal and Pedersen 1982, Math. Program. Study 16). Without a potential the
/// first five steps are not shortened.
///
/// If the residual has kinks without being a gradient, secants shorten the step, at most six times, until the slope
/// along the direction is at most 0.8 of the start's magnitude.
class AdmissibleLineSearch final : public NOX::LineSearch::Generic {
 public:
  /// `tolerance`: that of |f|, see NonlinearProblem::convergence_bound().
  AdmissibleLineSearch(NonlinearProblem& problem, double tolerance) : problem_(problem), tolerance_(tolerance) {}
  bool compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;

 private:
  /// The line x = from + step along.
  struct Line {
    const Vector& from;
    const Vector& along;
  };
  /// Slopes of the potential along a line, at its start and at the end of a step.
  struct Slopes {
    double start, end;
  };
  /// `number`: of this iteration, from 1.
  bool search(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
              const NOX::Abstract::Group& old, int number);
  /// Takes the group to a place of the line and returns the slope of the potential there; NaN if that is not possible.
  double slope_at(NOX::Abstract::Group& group, const Line& line, double step) const;
  /// Lengthens a step of 1. Returns the step; the group is there.
  double lengthened(NOX::Abstract::Group& group, const Line& line, Slopes slopes) const;
  /// Goes on along the ravine from the group, where the last two steps, which were shortened, have led from `start`.
  void follow_ravine(NOX::Abstract::Group& group, const Vector& start) const;

  /// Ends the watch if the potential at the group is below where it began, or returns there.
  void watch(NOX::Abstract::Group& group);

  NonlinearProblem& problem_;
  double tolerance_;
  /// Where steps that raise the potential began.
  struct Watch {
    Teuchos::RCP<const Vector> start;  ///< null: none is watched
    double potential = 0;              ///< there
    int steps = 0;                     ///< since
  };
  Watch watch_;
  bool cut_ = false;                      ///< the step was shortened because the potential did not fall
  Teuchos::RCP<const Vector> cut_start_;  ///< where the last step began, if it was shortened so
};

/// A factory that gives NOX the line search for a problem.
class AdmissibleLineSearchFactory final : public NOX::LineSearch::UserDefinedFactory {
 public:
  AdmissibleLineSearchFactory(NonlinearProblem& problem, double tolerance) : problem_(problem), tolerance_(tolerance) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(const Teuchos::RCP<NOX::GlobalData>&,
                                                         Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new AdmissibleLineSearch(problem_, tolerance_));
  }

 private:
  NonlinearProblem& problem_;
  double tolerance_;
};

}  // namespace ixos
