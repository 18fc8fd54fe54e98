#include "study/advice_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "study/advice_exploration.hpp"

namespace ixos {
namespace {

constexpr double times_the_scene = 8;    ///< the budget over the expected cost of the scene, or of the recommended run
constexpr double least_budget = 60;      ///< seconds; a process takes a part of one to start
constexpr std::size_t coarser_runs = 3;  ///< of each line through the base
constexpr std::size_t least_points = 3;  ///< of a line that settings are recommended by
/// Power of the number of cells in the expected cost of the scene: less than that of large runs, because a part of the
/// cost of the coarsest run does not grow.
constexpr double budget_power = 0.85;
constexpr double cross_cost = 1.75;  ///< of a new base with the coarser runs around it, over that of the base
constexpr double worthwhile = 0.5;   ///< cost of a trial over that of the settings that it may improve
constexpr std::size_t most_rounds = 100;

}  // namespace

AdviceSearch::AdviceSearch(const AdviceQuestion& question, const AdviceOptions& options,
                           const AdviceDirections& directions)
    : question_(question),
      options_(options),
      directions_(directions),
      runs_(question, options, directions),
      base_(scene_point(directions)),
      noise_(question.quantities.size(), 0) {
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
                       std::pow(cells, budget_power);
  const bool given = question_.budget > 0;
  runs_.set_budget(given ? question_.budget : std::max(times_the_scene * scene, least_budget));
  const std::string origin =
      fmt::format(", the larger of {:g} times the scene as it is and {:g} s", times_the_scene, least_budget);
  if (options_.tell)
    options_.tell(fmt::format("Budget: {:.3g} s of processor time{}. The scene as it is takes about {:.2g} s.",
                              runs_.budget(), given ? "" : origin, scene));
}

AdviceStatus AdviceSearch::find() {
  if (!start()) return AdviceStatus::NoRun;
  if (!is_predictable(base_)) return AdviceStatus::Chaotic;
  for (std::size_t round = 0; round < most_rounds; ++round) {
    const AdviceStatus status = refine();
    if (status != AdviceStatus::Advised) return status;
    explore();
    const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
    const AdviceCandidate* plan = cheapest_within(all, question_.tolerance);
    if (plan == nullptr) continue;
    if (!runs_.affords(plan->seconds)) break;
    if (runs_.sample(plan->point) == nullptr) {
      runs_.carry_out({plan->point});
      continue;
    }
    if (std::find(perturbed_.begin(), perturbed_.end(), plan->point) != perturbed_.end()) break;
    if (!is_predictable(plan->point)) return AdviceStatus::Chaotic;
  }
  return AdviceStatus::Advised;
}

/// Runs coarse steps until one reaches its end, on the coarsest mesh on which any does, and a few finer ones.
bool AdviceSearch::start() {
  for (; base_[mesh_direction].level < levels(mesh_direction); ++base_[mesh_direction].level) {
    std::vector<AdvicePoint> batch;
    for (std::size_t level = 0; level < std::min(least_points, levels(time_direction)); ++level)
      batch.push_back(moved(time_direction, level));
    runs_.carry_out(batch);
    for (std::size_t level = least_points; level < levels(time_direction); ++level) {
      const AdvicePoint next = moved(time_direction, level);
      if (errors().tested(time_direction, 0) > 0 || !runs_.affords(costs().seconds(next))) break;
      runs_.carry_out({next});
    }
    const AdviceErrors known = errors();
    if (known.tested(time_direction, 0) > 0) {
      base_[time_direction].level = known.finest(time_direction, 0);
      coarsest_mesh_ = base_[mesh_direction].level;
      return true;
    }
    if (!runs_.affords(0)) break;
  }
  problem_ = "No run gave the quantities within the budget. The last one: " + runs_.samples().back().reason + ".";
  return false;
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
        "{}The scene is chaotic for {}: a change of the density by 1e-10 changes it by {:.2g} %. No step or mesh makes "
        "it converge. {}",
        problem_.empty() ? "" : " ", question_.quantities[q].text(), 100 * found.change,
        question_.quantities[q].is_statistic() ? "A longer window gives a mean that varies less."
                                               : "Means over a long window and the energy error can be predicted.");
  }
  return predictable;
}

/// Runs the coarser steps and meshes around the base, as far as the budget goes.
void AdviceSearch::complete_cross() {
  std::vector<AdvicePoint> batch;
  double seconds = 0;
  const AdviceCosts cost = costs();
  for (std::size_t d : {time_direction, mesh_direction})
    for (std::size_t k = 1; k <= coarser_runs && k <= base_[d].level; ++k) {
      const AdvicePoint point = moved(d, base_[d].level - k);
      if (runs_.sample(point) != nullptr || (d == mesh_direction && point[d].level < coarsest_mesh_)) continue;
      seconds += cost.seconds(point);
      if (runs_.affords(seconds)) batch.push_back(point);
    }
  runs_.carry_out(batch);
}

/// Returns whether the lines through the base have enough points, where the directions have as many levels.
bool AdviceSearch::has_lines() const {
  const AdviceErrors known = errors();
  return known.tested(time_direction, 0) >= std::min(least_points, levels(time_direction)) &&
         known.tested(mesh_direction, 0) >= std::min(least_points, levels(mesh_direction) - coarsest_mesh_);
}

bool AdviceSearch::move_base(std::size_t d) {
  if (base_[d].level + 1 >= levels(d)) return false;
  const AdvicePoint next = moved(d, base_[d].level + 1);
  const AdviceSample* known = runs_.sample(next);
  if (known == nullptr) {
    if (!runs_.affords(cross_cost * costs().seconds(next))) return false;
    runs_.carry_out({next});
    known = runs_.sample(next);
  }
  if (!known->good) return false;
  base_ = next;
  return true;
}

/// Moves the base to the next finer level of the direction that limits its accuracy, or of the other one if that may
/// help.
bool AdviceSearch::move_base() {
  const AdviceErrors known = errors();
  if (known.tested(mesh_direction, 0) < std::min(least_points, levels(mesh_direction) - coarsest_mesh_))
    return move_base(mesh_direction) || move_base(time_direction);
  const AdviceEstimate estimate = known.estimate(base_);
  const std::size_t worst = estimate.worst_direction();
  const bool lines = known.tested(time_direction, 0) >= std::min(least_points, levels(time_direction));
  if (!lines || worst > mesh_direction) return move_base(time_direction) || move_base(mesh_direction);
  if (move_base(worst)) return true;
  const bool alone = estimate.parts[estimate.worst_quantity()][worst] > question_.tolerance;
  return !alone && move_base(worst == time_direction ? mesh_direction : time_direction);
}

/// Refines until settings keep the tolerance.
AdviceStatus AdviceSearch::refine() {
  AdvicePoint known = base_;  // the last one whose errors are known
  for (std::size_t round = 0; round < most_rounds; ++round) {
    complete_cross();
    if (has_lines()) {
      known = base_;
      const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
      if (cheapest_within(all, question_.tolerance) != nullptr) return AdviceStatus::Advised;
    }
    if (!move_base()) break;
  }
  base_ = known;
  return AdviceStatus::Unreachable;
}

/// Tries other choices while their runs cost little beside the settings found, and all runs at most the budget: the
/// user's, or a multiple of the cost of these settings.
void AdviceSearch::explore() {
  for (std::size_t round = 0; round < most_rounds; ++round) {
    const AdviceErrors known = errors();
    const AdviceCosts cost = costs();
    const std::vector<AdviceCandidate> all = candidates(directions_, known, cost, 0);
    const AdviceCandidate* plan = cheapest_within(all, question_.tolerance);
    const AdvicePoint next = next_exploration(directions_, base_, runs_.samples(), known, question_.tolerance);
    if (plan == nullptr || next.empty()) return;
    const double seconds = cost.seconds(next);
    const double most = question_.budget > 0 ? runs_.budget() : times_the_scene * plan->seconds;
    if (seconds > worthwhile * plan->seconds || runs_.spent() + seconds + plan->seconds > most ||
        !runs_.affords(seconds + plan->seconds))
      return;
    runs_.carry_out({next});
  }
}

}  // namespace ixos
