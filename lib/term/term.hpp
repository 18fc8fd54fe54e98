/// The contract of a physics term: what it keeps, and its life through stages and steps.
#pragma once
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "base/record.hpp"
#include "discretization/pattern.hpp"
#include "rule/rate_form.hpp"
#include "rule/row_on_states.hpp"
#include "rule/work_sum.hpp"
#include "state/place.hpp"

namespace ixos {

/// The beginning of a step: the accepted state, from which all attempts of the step start.
struct StepStart {
  KnownState state;
  double dt = 0;  ///< [T0]
  const TermHistories* histories = nullptr;

  Place place() const { return {state.u, state.time, histories, nullptr, state.v}; }
};

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
  const TermHistories* histories = nullptr;  ///< at the step's start
};

/// A step that is being accepted.
struct AcceptedStep {
  std::vector<KnownState> states;  ///< the step's start, then the ends of all stages
  const WorkSum* work = nullptr;
  double dt = 0;
  const StepMemories* step = nullptr;
};

/// This rank's shares of work in a step [E0 L0^D].
struct StepWork {
  double dissipated = 0;  ///< by the term
  double driven = 0;      ///< of driven ends of the term on the bodies, less that of their loads
};

/// One contribution to the model: a ForceTerm or a RateTerm.
///
/// A term holds no state of a motion. A TermHistory lasts from step to step, a StepMemory through one step; both are
/// arguments. A run begins with initialize(). begin_step() is told the accepted state,
/// begin_stage() what a stage's equation refers to; evaluations follow; accept() alone changes histories. A step that
/// is rejected ends with the next begin_step(). Hence it leaves no trace, and steps from several states can alternate.
/// Only which nodes two bodies couple in the matrix follows from the last search, whichever state it was for, see
/// Coupling. Arrays are local. None of the functions communicates, unless it says so.
class Term {
 public:
  virtual ~Term() = default;

  /// Returns the place of the term's history and memory among those of its model.
  std::size_t slot() const { return slot_; }
  /// Takes the next slot, and gives the following ones to the terms inside.
  void take_slot(std::size_t& next) {
    slot_ = next++;
    for (Term* inner : inside()) inner->take_slot(next);
  }
  /// Adds the histories, without a past, and the memories of this term and of those inside, in the order of their
  /// slots.
  void add_histories(std::vector<TermHistory>& all) const;
  void add_memories(std::vector<std::unique_ptr<StepMemory>>& all) const {
    all.push_back(create_memory());
    for (const Term* inner : inside()) inner->add_memories(all);
  }

  /// Finds the places of its matrix entries in a pattern that has changed.
  virtual void place(const Pattern& /*pattern*/) {}

  /// Sets the history of a state from which a run begins.
  virtual void initialize(const KnownState& /*start*/, TermHistories& /*histories*/) const {}
  virtual void begin_step(const StepStart& /*start*/, StepMemories& /*step*/) const {}
  virtual void begin_stage(const StageStart& /*start*/, StepMemories& /*step*/) const {}
  /// Returns whether accept() returns dissipated work that the model books under the term's name. Equal on all ranks.
  virtual bool dissipates() const { return false; }
  /// Accepts the step, whose last stage was the last one that began (explicit schemes begin none). `histories` are
  /// those of the step's start, and become those of its end.
  virtual StepWork accept(const AcceptedStep& /*step*/, TermHistories& /*histories*/) const { return {}; }

  /// Returns whether transfer() writes or reads something. Equal on all ranks.
  virtual bool has_state() const { return false; }
  /// Returns whether forces depend on the history: then a restart of another scene takes that over, too. Equal on all
  /// ranks.
  virtual bool has_history() const { return false; }
  /// Returns whether a restart of another scene takes over some of it. Equal on all ranks.
  virtual bool outlives_scene() const { return has_history(); }
  /// Writes or reads the history, and what else decides on later steps to the last bit. Collective.
  virtual void transfer(Record&, TermHistories& /*histories*/) {}

 protected:
  virtual TermHistory create_history() const;
  virtual std::unique_ptr<StepMemory> create_memory() const { return nullptr; }
  /// Returns the terms that this one is made of.
  virtual std::vector<Term*> inside() const { return {}; }

 private:
  std::size_t slot_ = 0;
};

/// Gives a term that no model has the first slots. Returns its histories, without a past.
TermHistories lone_histories(Term& term);

}  // namespace ixos
