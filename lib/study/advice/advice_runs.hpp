/// The runs of an advice, one after the other.
#pragma once
#include <string>
#include <vector>

#include "study/advice/advice.hpp"
#include "study/common/run_pool.hpp"

namespace ixos {

/// Carries out the runs of points, keeps their samples, and counts what they cost.
class AdviceRuns {
 public:
  /// Thrown if the user interrupts the runs.
  struct Interrupted {};

  AdviceRuns(const AdviceQuestion& question, const AdviceOptions& options, const AdviceDirections& directions);

  /// Throws InputError if a quantity needs a column that the run of a point does not have.
  void check_columns(const AdvicePoint& point) const;

  /// Runs those points that were not run. Throws Interrupted.
  void carry_out(const std::vector<AdvicePoint>& points);

  /// Runs a good point once more with densities that differ by 1e-10, and returns the values; none if that run did not
  /// reach its end, or if there is no perturbation.
  std::vector<double> perturbed(const AdvicePoint& point);

  /// Runs another question's scene with these settings besides its own, and returns the sample, without a point. Its
  /// cost counts, too. `there`: the run's name and label. Throws Interrupted, and InputError if the run reached its end
  /// and does not have a quantity.
  AdviceSample in_another_scene(const AdviceQuestion& other, StudyRun there, const Assignments& settings);
  /// Counts the cost of runs that were carried out before.
  void count(double seconds) { spent_ += seconds; }

  const std::vector<AdviceSample>& samples() const { return samples_; }
  /// Returns the sample of a point; null if it was not run.
  const AdviceSample* sample(const AdvicePoint& point) const;
  double spent() const { return spent_; }

  /// Limits the processor time of all runs together.
  void set_budget(double seconds) { budget_ = seconds; }
  bool affords(double seconds) const { return spent_ + seconds <= budget_; }
  /// Returns whether a run that should take so many seconds may end within the budget: costs that are extrapolated to
  /// finer meshes and steps can be three times too high.
  bool may_afford(double seconds) const { return affords(seconds / 3); }
  double budget() const { return budget_; }

 private:
  StudyRun run_of(const AdvicePoint& point) const;
  AdviceSample sample_of(const AdvicePoint& point, const StudyRun& run) const;
  void run(const std::vector<StudyRun>& runs) { run(runs, pool_); }
  void run(const std::vector<StudyRun>& runs, RunPool& pool);
  RunPool pool_of(const std::string& scene) const;

  const AdviceQuestion& question_;
  const AdviceOptions& options_;
  const AdviceDirections& directions_;
  RunPool pool_;
  std::vector<AdviceSample> samples_;
  double spent_ = 0, budget_ = 0;
};

}  // namespace ixos
