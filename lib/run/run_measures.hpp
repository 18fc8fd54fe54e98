/// The measures that a run takes for its warnings.
#pragma once
#include "run/contact_watch.hpp"
#include "run/front_watch.hpp"
#include "run/history.hpp"
#include "run/jump_watch.hpp"
#include "run/relaxation_watch.hpp"
#include "run/run_warnings.hpp"
#include "run/strain_watch.hpp"

namespace ixos {

/// Gathers RunFacts over a run. Collective.
class RunMeasures {
 public:
  explicit RunMeasures(const Simulation& simulation);

  /// Takes part in a step of length dt that has been accepted; `steps`: their number so far.
  void step(long steps, double dt);
  /// Takes part in a recorded row of the present state, the first and the last one included, and settles it.
  void row(History& history);
  /// Counts on from the jumps of another simulation's part of the run.
  void go_on_from(const RunMeasures& before) { jumps_.go_on_from(before.jumps()); }
  /// Returns the jump of a quasi-static run before the last row, and all jumps so far.
  const Jump& jump() const { return jump_; }
  const JumpSums& jumps() const { return jumps_.jumps(); }
  /// Takes part in a step that was rejected because a surface crossed its obstacle.
  void crossed() { ++crossings_; }
  /// Looks at the last state, and returns the facts of the whole run.
  RunFacts finish(const History& history);

  /// For checkpoints.
  void transfer(Record& record);

 private:
  void look_at_cells();

  const Simulation& simulation_;
  StrainWatch strains_;
  ContactWatch contact_;
  JumpWatch jumps_;  ///< takes part in quasi-static runs
  Jump jump_;
  FrontWatch front_;
  RelaxationWatch relaxation_;
  long interval_;     ///< steps between looks at cells, which so cost less than 1 % of the run
  double scale_ = 0;  ///< see RunFacts
  double face_measure_ = 0;
  long steps_ = 0;
  double friction_work_ = 0, friction_lag_ = 0;  ///< see FrictionReport; sums over the rows
  long crossings_ = 0;
  double deepest_ = 0;
};

}  // namespace ixos
