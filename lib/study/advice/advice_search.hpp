/// The order of the runs of an advice.
#pragma once
#include <string>
#include <vector>

#include "study/advice/advice.hpp"
#include "study/advice/advice_exploration.hpp"
#include "study/advice/advice_runs.hpp"

namespace ixos {

/// Searches the cheapest settings within the tolerance. All directions are refined from one coarse base, each with
/// everything else at the base, so that only the recommended run itself is fine in all of them. That run then measures
/// how far the directions add up; if they do not, the base moves towards it.
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
  bool needs_perturbation(const AdvicePoint& point) const;
  void meets(const std::string& obstacle);
  bool extend(std::size_t d);
  bool extend_or_move(std::size_t d);
  bool has_line(std::size_t d) const;
  bool is_base_coarse(std::size_t d) const;
  bool is_negligible(const AdvicePoint& point, std::size_t d) const;
  bool spoils(std::size_t d, std::size_t other) const;
  AdvicePoint finer_base(std::size_t d) const;
  bool move_base(const std::vector<std::size_t>& directions);
  double finest_part(std::size_t d) const;
  bool refine_line(std::size_t d);
  bool sharpen();
  bool examine_suspects();
  AdviceStatus refine();
  void improve();
  AdvicePoint own_plan(const std::vector<AdviceCandidate>& all) const;
  bool try_best(std::vector<AdviceTrial> trials, const std::vector<double>& allowance);
  bool try_before(std::size_t d);
  bool confirm_order(const AdviceCandidate& plan, double least);
  bool pays(double seconds, const AdviceCandidate& plan) const;
  AdvicePoint moved(std::size_t d, std::size_t level) const;
  std::vector<AdvicePoint> missing_line(const AdvicePoint& base, std::size_t d) const;
  std::size_t own(std::size_t d) const { return base_[d].branch; }
  std::size_t levels(std::size_t d) const { return directions_.all[d].branches[own(d)].levels.size(); }
  bool adopt_better_cells();
  AdvicePoint twin_of(const AdvicePoint& plan) const;
  double cost_of_cells(std::size_t branch, std::size_t quantity, double limit) const;

  const AdviceQuestion& question_;
  const AdviceOptions& options_;
  const AdviceDirections& directions_;
  AdviceRuns runs_;
  AdvicePoint base_;
  std::size_t coarsest_mesh_ = 0;  ///< that ixos accepts
  std::vector<bool> is_error_;
  std::vector<double> noise_;
  std::vector<double> tried_;      ///< seconds of the trials of each direction
  std::vector<double> last_part_;  ///< of each direction: its part before the last refinement
  std::vector<Sensitivity> sensitivities_;
  std::vector<AdvicePoint> perturbed_;
  bool sought_better_cells_ = false;
  std::string problem_, obstacle_;
};

}  // namespace ixos
