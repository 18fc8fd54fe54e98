/// The contract of a physics term: its life through stages and steps.
#pragma once
#include <vector>

#include "base/record.hpp"
#include "discretization/pattern.hpp"
#include "fem/rate_form.hpp"
#include "fem/row_on_states.hpp"
#include "fem/work_sum.hpp"

namespace ixos {

/// The beginning of a stage. Its arrays and rows must stay until the stage's solve is over.
struct StageStart {
  std::vector<KnownState> known;  ///< the step's start, then the ends of the stages before this one
  const Row* velocity = nullptr;  ///< dt u'_s at the stage's end
  const Row* damping = nullptr;   ///< dt times the rate that constant coefficients multiply
  RateForm rate_form = RateForm::End;
  /// End only: the force at the step's start has this weight, the one at the stage's end the rest.
  double start_weight = 0;
  double time = 0;    ///< of the step's start [T0]
  double length = 0;  ///< from the step's start to the stage's end [T0]
  /// Mean time from the step's start to the points of the elastic rule [T0]: the stage's length for a force at its end,
  /// half of it for a mean over the stage.
  double mean_time = 0;
  double dt = 0;  ///< the whole step, to which rows refer [T0]
  /// Degrees of freedom whose velocity at the stage's end is prescribed, and a local array of those velocities [L0/T0].
  /// Damping takes them in place of the row's; viscosity takes the row of strains throughout. Null if there are none.
  const std::vector<int>* driven = nullptr;
  const double* driven_velocity = nullptr;
};

/// A step that is being accepted.
struct AcceptedStep {
  std::vector<KnownState> states;  ///< the step's start, then the ends of all stages
  const WorkSum* work = nullptr;
  double dt = 0;
};

/// One contribution to the model: a ForceTerm or a RateTerm.
///
/// A term lives through steps. initialize() begins its history at a first state. begin_step() tells it the accepted
/// state, from which all attempts of the step start, and begin_stage() what a stage's equation refers to; evaluations
/// follow; accept() makes the state at the step's end the accepted one. A step that is rejected ends with the next
/// begin_step(). A term changes its kept state in accept() only, and names it in transfer(). Hence a rejected step
/// leaves no trace. Arrays are local. None of the functions communicates, unless it says so.
class Term {
 public:
  virtual ~Term() = default;

  /// Finds the places of its matrix entries in a pattern that has changed.
  virtual void place(const Pattern& /*pattern*/) {}
  /// Discards what earlier steps left, and begins anew at the given state.
  virtual void initialize(const KnownState& /*start*/) {}
  virtual void begin_step(const KnownState& /*start*/, double /*time*/, double /*dt*/) {}
  virtual void begin_stage(const StageStart& /*start*/) {}
  /// Returns whether accept() returns work that the model books under the term's name. Equal on all ranks.
  virtual bool dissipates() const { return false; }
  /// Accepts the step, whose last stage was the last one that began (explicit schemes begin none). Returns this rank's
  /// share of the work that the term dissipated in it [E0 L0^D].
  virtual double accept(const AcceptedStep& /*step*/) { return 0; }
  /// Returns whether the term keeps something from step to step, which transfer() writes or reads. Equal on all ranks.
  virtual bool has_state() const { return false; }
  /// Returns whether forces depend on what it keeps: then a restart of another scene takes that over, too. Equal on all
  /// ranks.
  virtual bool has_history() const { return false; }
  /// Collective.
  virtual void transfer(Record&) {}
};

}  // namespace ixos
