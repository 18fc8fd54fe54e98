/// The order of the runs of an advice.
#pragma once
#include <string>
#include <vector>

#include "study/advice.hpp"
#include "study/advice_runs.hpp"

namespace ixos {

/// Searches the cheapest settings within the tolerance. A base of a step and a mesh moves from coarse to fine, each
/// time in the direction that limits its accuracy; coarser runs around the base give its error. Most runs therefore
/// cost little beside the last ones.
class AdviceSearch {
 public:
  AdviceSearch(const AdviceQuestion& question, const AdviceOptions& options, const AdviceDirections& directions);

  /// Runs the coarsest step on the coarsest mesh that ixos accepts, checks the quantities, and states the budget.
  /// `control` is the list Time Step Control. Throws InputError.
  void begin(const Teuchos::ParameterList& control);

  /// Searches until settings are found or the budget is spent.
  AdviceStatus find();

  AdviceErrors errors() const { return {directions_, base_, runs_.samples(), is_error_, noise_}; }
  AdviceCosts costs() const { return {directions_, runs_.samples()}; }
  AdviceRuns& runs() { return runs_; }
  const std::vector<Sensitivity>& sensitivities() const { return sensitivities_; }
  const std::string& problem() const { return problem_; }

 private:
  bool start();
  bool is_predictable(const AdvicePoint& point);
  void complete_cross();
  bool has_lines() const;
  bool move_base();
  bool move_base(std::size_t d);
  AdviceStatus refine();
  void explore();
  AdvicePoint moved(std::size_t d, std::size_t level) const;
  std::size_t levels(std::size_t d) const { return directions_.all[d].branches[0].levels.size(); }

  const AdviceQuestion& question_;
  const AdviceOptions& options_;
  const AdviceDirections& directions_;
  AdviceRuns runs_;
  AdvicePoint base_;
  std::size_t coarsest_mesh_ = 0;  ///< that ixos accepts
  std::vector<bool> is_error_;
  std::vector<double> noise_;
  std::vector<Sensitivity> sensitivities_;
  std::vector<AdvicePoint> perturbed_;
  std::string problem_;
};

}  // namespace ixos
