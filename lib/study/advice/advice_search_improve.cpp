#include <algorithm>

#include "study/advice/advice_search.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
/// Returns the coarsest settings with the base's scheme and elements within the tolerance, or the finest tested.
AdvicePoint AdviceSearch::own_plan(const std::vector<AdviceCandidate>& all) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const AdviceCandidate& each) {
    return each.error <= question_.tolerance && each.point[time_direction].branch == base_[time_direction].branch &&
           each.point[mesh_direction].branch == base_[mesh_direction].branch;
  });
  if (found != all.end()) return found->point;
  const AdviceErrors known = errors();
  AdvicePoint corner = base_;
  for (std::size_t d = 0; d < corner.size(); ++d) corner[d].level = known.finest(d, own(d));
  return corner;
}

/// Carries out the best of trials, as many as run at a time: each for itself must take at most its allowance in
/// seconds, and so must all that a direction had so far, unless the trial promises much. Returns whether there were
/// some.
bool AdviceSearch::try_best(std::vector<AdviceTrial> trials, const std::vector<double>& allowance) {
  const AdviceCosts cost = costs();
  const auto value = [&](const AdviceTrial& trial) {
    return trial.promise * allowance[trial.direction] / cost.seconds(trial.point);
  };
  std::stable_sort(trials.begin(), trials.end(),
                   [&](const AdviceTrial& a, const AdviceTrial& b) { return value(a) > value(b); });
  std::vector<AdviceTrial> batch;
  std::vector<AdvicePoint> points;
  std::vector<double> planned = tried_;
  double total = 0;
  for (const AdviceTrial& trial : trials) {
    const double seconds = cost.seconds(trial.point);
    const double before = trial.promise < tuning::promising ? planned[trial.direction] : 0;
    if (before + seconds > allowance[trial.direction] || !runs_.affords(total + seconds)) continue;
    total += seconds;
    planned[trial.direction] += seconds;
    batch.push_back(trial);
    points.push_back(trial.point);
    if (batch.size() == static_cast<std::size_t>(options_.jobs)) break;
  }
  runs_.carry_out(points);
  for (const AdviceTrial& trial : batch) tried_[trial.direction] += runs_.sample(trial.point)->seconds;
  return !batch.empty();
}

/// Tries other branches of a direction before a dear refinement.
bool AdviceSearch::try_before(std::size_t d) {
  std::vector<double> allowance(directions_.all.size(), 0);
  const std::size_t next = std::min(errors().finest(d, own(d)) + 1, levels(d) - 1);
  allowance[d] = costs().seconds(moved(d, next));
  const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
  std::vector<AdviceTrial> trials =
      explorations(directions_, base_, own_plan(all), runs_.samples(), errors(), question_.tolerance);
  const auto is_poorer = [&](const AdviceTrial& trial) {
    return !branch_at(directions_, trial.point, d).may_be_better;
  };
  trials.erase(std::remove_if(trials.begin(), trials.end(), is_poorer), trials.end());
  return try_best(trials, allowance);
}

/// Refines a line once more if the order that this may confirm would allow for cheaper settings. Returns whether a run
/// was carried out.
bool AdviceSearch::confirm_order(const AdviceCandidate& plan, double least) {
  const AdviceErrors known = errors();
  for (std::size_t d : {time_direction, mesh_direction}) {
    const AdvicePoint next = moved(d, known.finest(d, own(d)) + 1);
    if (next[d].level >= levels(d) || runs_.sample(next) != nullptr) continue;
    const AdviceCosts cost = costs();
    const std::vector<AdviceCandidate> hoped = candidates(directions_, known.hopeful(d), cost, 0);
    const AdviceCandidate* better = cheapest_within(hoped, question_.tolerance);
    if (better == nullptr) continue;
    const double seconds = cost.seconds(next), saving = plan.seconds - std::max(better->seconds, least);
    if (seconds > tuning::worthwhile_trial * saving || !pays(seconds, plan)) continue;
    runs_.carry_out({next});
    return true;
  }
  return false;
}

/// Returns whether a run leaves enough for the plan, of the budget and of a multiple of the plan's cost.
bool AdviceSearch::pays(double seconds, const AdviceCandidate& plan) const {
  const double total = seconds + plan.seconds;
  return runs_.spent() + total <= tuning::times_the_plan * plan.seconds && runs_.affords(total);
}

/// Tries other choices, and confirms orders, while the runs cost little beside what they may save in one run.
void AdviceSearch::improve() {
  for (std::size_t round = 0; round < tuning::most_rounds; ++round) {
    const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
    const AdviceCandidate* plan = cheapest_within(all, question_.tolerance);
    if (plan == nullptr) return;
    double least = plan->seconds;
    for (const AdviceSample& sample : runs_.samples())
      if (sample.good) least = std::min(least, sample.seconds);
    if (confirm_order(*plan, least)) continue;
    std::vector<AdviceTrial> trials =
        explorations(directions_, base_, own_plan(all), runs_.samples(), errors(), question_.tolerance);
    std::vector<double> allowance(directions_.all.size(), 0);
    for (const AdviceTrial& trial : trials)
      allowance[trial.direction] =
          std::max(allowance[trial.direction], std::min(trial.saving * plan->seconds, plan->seconds - least));
    const AdviceCosts cost = costs();
    trials.erase(std::remove_if(trials.begin(), trials.end(),
                                [&](const AdviceTrial& trial) { return !pays(cost.seconds(trial.point), *plan); }),
                 trials.end());
    if (!try_best(trials, allowance)) return;
  }
}

}  // namespace ixos
