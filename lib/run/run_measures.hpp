/// The measures that a run takes for its warnings.
#pragma once
#include "run/contact_watch.hpp"
#include "run/front_watch.hpp"
#include "run/history.hpp"
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
  /// Takes part in a recorded row of the present state, the first and the last one included.
  void row(const History& history);
  /// Takes part in a step that was rejected because a surface crossed its obstacle.
  void crossed() { ++crossings_; }
  /// Looks at the last state, and returns the facts of the whole run.
  RunFacts finish(const History& history);

  /// For checkpoints; the history's jumps are among them.
  void transfer(Record& record, History& history);

 private:
  void look_at_cells();

  const Simulation& simulation_;
  StrainWatch strains_;
  ContactWatch contact_;
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
