#include "study/advice/advice_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "study/common/tuning.hpp"

namespace ixos {

AdviceSearch::AdviceSearch(const AdviceQuestion& question, const AdviceOptions& options,
                           const AdviceDirections& directions)
    : question_(question),
      options_(options),
      directions_(directions),
      runs_(question, options, directions),
      base_(scene_point(directions)),
      noise_(question.quantities.size(), 0),
      tried_(directions.all.size(), 0),
      last_part_(directions.all.size(), std::numeric_limits<double>::infinity()) {
  base_[time_direction].level = base_[mesh_direction].level = 0;
  for (const AskedQuantity& quantity : question.quantities) is_error_.push_back(quantity.is_error());
}

AdvicePoint AdviceSearch::moved(std::size_t d, std::size_t level) const {
  AdvicePoint point = base_;
  point[d].level = level;
  return point;
}

void AdviceSearch::begin(const Teuchos::ParameterList& control) {
  const double start = control.get<double>("Initial Time"), end = control.get<double>("Final Time");
  for (const AskedQuantity& quantity : question_.quantities) quantity.check_times(start, end);
  const std::size_t scene_level = directions_.all[mesh_direction].scene_level;
  runs_.set_budget(question_.budget);
  runs_.carry_out({base_});
  while (runs_.samples().back().refused) {
    if (base_[mesh_direction].level == scene_level) throw InputError(runs_.samples().back().reason);
    coarsest_mesh_ = ++base_[mesh_direction].level;
    runs_.carry_out({base_});
  }
  runs_.check_columns(base_);
  const double finer = static_cast<double>(scene_level) - static_cast<double>(coarsest_mesh_);
  const double cells = std::pow(2.0, directions_.dimension * finer);
  const double scene = runs_.samples().back().seconds_per_step * (end - start) / control.get<double>("Time Step") *
                       std::pow(cells, tuning::budget_power);
  const bool given = question_.budget > 0;
  runs_.set_budget(given ? question_.budget : std::max(tuning::times_the_scene * scene, tuning::least_budget));
  const std::string origin = fmt::format(", the larger of {:g} times the scene as it is and {:g} s",
                                         tuning::times_the_scene, tuning::least_budget);
  if (options_.log)
    options_.log(fmt::format("Budget: {:.3g} s of processor time{}. The scene as it is takes about {:.2g} s.",
                             runs_.budget(), given ? "" : origin, scene));
}

AdviceStatus AdviceSearch::find() {
  if (!start()) return AdviceStatus::NoRun;
  if (!is_predictable(base_)) return AdviceStatus::Chaotic;
  // Lines have a level finer than the base. The longest step that causes no error to speak of is the cheapest.
  const std::vector<std::size_t> steps = errors().levels(time_direction, own(time_direction));
  std::size_t first = 0;
  while (first + 2 < steps.size() && !is_negligible(moved(time_direction, steps[first]), time_direction)) ++first;
  base_[time_direction].level = steps[first];
  for (std::size_t round = 0; round < tuning::most_rounds; ++round) {
    const AdviceStatus status = refine();
    if (status != AdviceStatus::Advised) return status;
    improve();
    const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
    const AdviceCandidate* plan = cheapest_within(all, question_.tolerance);
    if (plan == nullptr) continue;
    if (!runs_.affords(plan->seconds)) break;
    if (runs_.sample(plan->point) == nullptr) {
      runs_.carry_out({plan->point});
      continue;
    }
    if (const AdvicePoint twin = twin_of(plan->point); !twin.empty()) {
      runs_.carry_out({twin});
      continue;
    }
    if (!needs_perturbation(plan->point)) break;
    if (!is_predictable(plan->point)) return AdviceStatus::Chaotic;
  }
  return AdviceStatus::Advised;
}

/// Returns the plan with twice the step, if that run is to be carried out: a step may cause more error on the plan's
/// mesh than on a much coarser base.
AdvicePoint AdviceSearch::twin_of(const AdvicePoint& plan) const {
  const bool near = plan[mesh_direction].branch == own(mesh_direction) &&
                    plan[mesh_direction].level < base_[mesh_direction].level + tuning::far_from_base;
  if (near || plan[time_direction].level == 0) return {};
  AdvicePoint twin = plan;
  --twin[time_direction].level;
  return runs_.sample(twin) != nullptr || !runs_.affords(costs().seconds(twin)) ? AdvicePoint() : twin;
}

/// Runs coarse steps until some reach their end, on the coarsest mesh on which any do, and chooses the base.
bool AdviceSearch::start() {
  bool is_spent = false;
  for (; base_[mesh_direction].level < levels(mesh_direction); ++base_[mesh_direction].level) {
    std::vector<AdvicePoint> batch;
    double seconds = 0;
    for (std::size_t level = 0; level < std::min(tuning::least_points_of_a_line, levels(time_direction)); ++level) {
      batch.push_back(moved(time_direction, level));
      seconds += runs_.sample(batch.back()) == nullptr ? costs().seconds(batch.back()) : 0;
    }
    is_spent = !runs_.affords(seconds);
    if (is_spent) break;
    runs_.carry_out(batch);
    const bool lack_quantities = std::all_of(batch.begin(), batch.end(), [&](const AdvicePoint& point) {
      const AdviceSample* sample = runs_.sample(point);
      return sample->reached_end && !sample->good;
    });
    if (lack_quantities) {
      problem_ = "The runs end as they should, but do not give the quantities: " + runs_.sample(batch.back())->reason;
      return false;
    }
    for (std::size_t level = tuning::least_points_of_a_line; level < levels(time_direction); ++level) {
      const AdvicePoint next = moved(time_direction, level);
      if (errors().tested(time_direction, own(time_direction)) > 0 || !runs_.affords(costs().seconds(next))) break;
      runs_.carry_out({next});
    }
    const std::vector<std::size_t> good = errors().levels(time_direction, own(time_direction));
    if (good.empty()) continue;
    base_[time_direction].level = good.back();
    coarsest_mesh_ = base_[mesh_direction].level;
    return true;
  }
  const AdviceSample& last = runs_.samples().back();
  if (last.good && is_spent)
    problem_ = fmt::format(
        "The runs that show how the quantities change with the steps exceed what the budget has left, {:.2g} s of "
        "{:.2g} s.",
        std::max(0.0, runs_.budget() - runs_.spent()), runs_.budget());
  else if (last.good)
    problem_ = "Too few runs gave the quantities to show how they change with the steps.";
  else
    problem_ = "No run gave the quantities within the budget. The last one: " + last.reason + ".";
  return false;
}

bool AdviceSearch::needs_perturbation(const AdvicePoint& point) const {
  const bool is_calm = std::all_of(sensitivities_.begin(), sensitivities_.end(),
                                   [](const Sensitivity& found) { return found.change <= tuning::calm; });
  return !is_calm && std::find(perturbed_.begin(), perturbed_.end(), point) == perturbed_.end();
}

/// Runs a point once more, perturbed. Returns whether all quantities can be predicted.
bool AdviceSearch::is_predictable(const AdvicePoint& point) {
  perturbed_.push_back(point);
  const std::vector<double> values = runs_.sample(point)->values, others = runs_.perturbed(point);
  if (others.size() != values.size()) return true;
  bool predictable = true;
  sensitivities_.resize(values.size());
  for (std::size_t q = 0; q < values.size(); ++q) {
    const Sensitivity found = sensitivity(values[q], others[q], question_.tolerance);
    if (found.change >= sensitivities_[q].change) sensitivities_[q] = found;
    noise_[q] = std::max(noise_[q], is_error_[q] ? found.change * std::abs(values[q]) : found.change);
    if (found.kind != Predictability::Chaotic || is_error_[q]) continue;
    predictable = false;
    problem_ += fmt::format(
        "{}The scene is chaotic for {}: a change of the density by {} changes it by {:.2g} %. No step or mesh makes "
        "it converge. {}",
        problem_.empty() ? "" : " ", question_.quantities[q].text(), tuning::perturbation_size, 100 * found.change,
        question_.quantities[q].is_statistic() ? "A longer window gives a mean that varies less."
                                               : "Means over a long window and the energy error can be predicted.");
  }
  return predictable;
}

}  // namespace ixos
