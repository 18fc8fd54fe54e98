#include "study/advice_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr double times_the_scene = 8;    ///< the budget over the expected cost of the scene, or of the recommended run
constexpr double least_budget = 60;      ///< seconds; a process takes a part of one to start
constexpr std::size_t least_points = 3;  ///< of a line that settings are recommended by
constexpr std::size_t most_points = 3;   ///< of a line that moves with the base
/// Power of the number of cells in the expected cost of the scene: less than that of large runs, because a part of the
/// cost of the coarsest run does not grow.
constexpr double budget_power = 0.85;
constexpr double worthwhile = 0.5;  ///< cost of a trial over what it may save in one run
/// Change by a perturbation of 1e-10 below which finer runs are not perturbed, too: they will not amplify it as much
/// as a tolerance needs.
constexpr double calm = 1e-8;
constexpr double helpful = 0.9;  ///< largest part of an error that a refinement which helps leaves of it
constexpr std::size_t most_rounds = 100;

/// Returns the largest error of a base. Two relative errors interact by about their product, which should be a part of
/// the tolerance.
double largest_base_error(double tolerance) { return std::sqrt(tolerance) / 2; }

}  // namespace

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
  // Lines have a level finer than the base.
  const std::vector<std::size_t> steps = errors().levels(time_direction, 0);
  base_[time_direction].level = steps[steps.size() - std::min<std::size_t>(steps.size(), 2)];
  for (std::size_t round = 0; round < most_rounds; ++round) {
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
    if (!needs_perturbation(plan->point)) break;
    if (!is_predictable(plan->point)) return AdviceStatus::Chaotic;
  }
  return AdviceStatus::Advised;
}

/// Runs coarse steps until some reach their end, on the coarsest mesh on which any do, and chooses the base.
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

bool AdviceSearch::needs_perturbation(const AdvicePoint& point) const {
  const bool is_calm = std::all_of(sensitivities_.begin(), sensitivities_.end(),
                                   [](const Sensitivity& found) { return found.change <= calm; });
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
        "{}The scene is chaotic for {}: a change of the density by 1e-10 changes it by {:.2g} %. No step or mesh makes "
        "it converge. {}",
        problem_.empty() ? "" : " ", question_.quantities[q].text(), 100 * found.change,
        question_.quantities[q].is_statistic() ? "A longer window gives a mean that varies less."
                                               : "Means over a long window and the energy error can be predicted.");
  }
  return predictable;
}

/// Runs the next finer level of a direction at the base. Returns whether it reached its end.
bool AdviceSearch::extend(std::size_t d) {
  const std::size_t level = errors().finest(d, 0) + 1;
  if (level >= levels(d)) return false;
  const AdvicePoint next = moved(d, level);
  if (const AdviceSample* known = runs_.sample(next); known != nullptr) return false;  // it failed
  if (!runs_.affords(costs().seconds(next))) return false;
  runs_.carry_out({next});
  return runs_.sample(next)->good;
}

/// Returns whether the line of a direction has enough points, as far as there are levels.
bool AdviceSearch::has_line(std::size_t d) const {
  const std::size_t first = d == mesh_direction ? coarsest_mesh_ : 0;
  return errors().tested(d, 0) >= std::min(least_points, levels(d) - first);
}

/// Returns whether the error of a direction at the base is so large that it may change those of other directions.
bool AdviceSearch::is_base_coarse(std::size_t d) const {
  for (const std::vector<double>& parts : errors().estimate(base_).parts)
    if (!(parts[d] <= largest_base_error(question_.tolerance))) return true;
  return false;
}

/// Returns the runs that the line of a direction through another base needs, and that were not carried out: the base
/// and the finest levels that the present line has.
std::vector<AdvicePoint> AdviceSearch::missing_line(const AdvicePoint& base, std::size_t d) const {
  std::vector<std::size_t> wanted = errors().levels(d, 0);
  wanted.erase(wanted.begin(), wanted.end() - static_cast<long>(std::min(most_points, wanted.size())));
  wanted.push_back(base[d].level);
  std::vector<AdvicePoint> missing;
  for (std::size_t level : wanted) {
    AdvicePoint point = base;
    point[d].level = level;
    if (runs_.sample(point) == nullptr) missing.push_back(point);
  }
  return missing;
}

/// Returns the next finer base in a direction; none if the line does not reach it.
AdvicePoint AdviceSearch::finer_base(std::size_t d) const {
  const AdvicePoint next = moved(d, base_[d].level + 1);
  if (next[d].level > errors().finest(d, 0)) return {};
  const AdviceSample* sample = runs_.sample(next);
  return sample != nullptr && sample->good ? next : AdvicePoint();
}

/// Moves the base to the next finer level of one of some directions, whichever needs the cheaper runs. Returns whether
/// it moved.
bool AdviceSearch::move_base(const std::vector<std::size_t>& directions) {
  const AdviceCosts cost = costs();
  std::vector<AdvicePoint> cheapest;
  AdvicePoint best;
  double least = 0;
  for (std::size_t d : directions) {
    const AdvicePoint next = finer_base(d);
    if (next.empty()) continue;
    const std::vector<AdvicePoint> missing = missing_line(next, d == time_direction ? mesh_direction : time_direction);
    double seconds = 0;
    for (const AdvicePoint& point : missing) seconds += cost.seconds(point);
    if (!best.empty() && seconds >= least) continue;
    best = next;
    cheapest = missing;
    least = seconds;
  }
  if (best.empty() || !runs_.affords(least)) return false;
  runs_.carry_out(cheapest);
  base_ = best;
  return true;
}

/// Returns the largest part of the error that a direction has at its finest level.
double AdviceSearch::finest_part(std::size_t d) const {
  const AdviceErrors known = errors();
  double most = 0;
  for (const std::vector<double>& parts : known.estimate(moved(d, known.finest(d, 0))).parts)
    most = std::max(most, parts[d]);
  return most;
}

/// Refines a direction once more. If the last refinement did not help, its sequence does not converge at this base:
/// then it is measured at a base that is finer in the other direction.
bool AdviceSearch::refine_line(std::size_t d) {
  const double part = finest_part(d);
  const bool futile = part > helpful * last_part_[d];
  if (futile && d <= mesh_direction && move_base({d == time_direction ? mesh_direction : time_direction})) {
    last_part_[d] = std::numeric_limits<double>::infinity();
    return true;
  }
  last_part_[d] = part;
  return extend(d);
}

/// Reduces the largest part of the error that the finest settings of all lines have. Returns whether anything changed.
bool AdviceSearch::sharpen() {
  const AdviceErrors known = errors();
  AdvicePoint corner = base_;
  for (std::size_t d = 0; d < corner.size(); ++d) corner[d].level = known.finest(d, 0);
  const AdviceEstimate estimate = known.estimate(corner);
  const std::size_t q = estimate.worst_quantity();
  const std::vector<double>& parts = estimate.parts[q];
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return parts[a] > parts[b]; });
  if (known.interaction(corner, q) > parts[order.front()] && move_base({time_direction, mesh_direction})) return true;
  for (std::size_t d : order) {
    if (!directions_.all[d].converges) continue;
    if (d <= mesh_direction && try_before(d)) return true;
    if (refine_line(d)) return true;
    if (parts[d] > question_.tolerance) return false;
  }
  return false;
}

/// Runs the next level of a direction whose error must be measured. Returns whether there was one.
bool AdviceSearch::examine_suspects() {
  const AdviceErrors known = errors();
  for (std::size_t d = mesh_direction + 1; d < directions_.all.size(); ++d)
    if (directions_.all[d].suspect && known.finest(d, 0) == directions_.all[d].scene_level && extend(d)) return true;
  return false;
}

/// Refines until settings keep the tolerance.
AdviceStatus AdviceSearch::refine() {
  for (std::size_t round = 0; round < most_rounds; ++round) {
    // Chaos may show on finer meshes, or with some steps, only.
    if (needs_perturbation(base_) && !is_predictable(base_)) return AdviceStatus::Chaotic;
    if (!has_line(time_direction) || !has_line(mesh_direction)) {
      if (extend(has_line(time_direction) ? mesh_direction : time_direction)) continue;
      return AdviceStatus::Unreachable;
    }
    if (examine_suspects()) continue;
    if (is_base_coarse(mesh_direction) && move_base({mesh_direction})) continue;
    if (is_base_coarse(time_direction) && move_base({time_direction})) continue;
    const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
    if (cheapest_within(all, question_.tolerance) != nullptr) return AdviceStatus::Advised;
    if (!sharpen()) break;
  }
  return AdviceStatus::Unreachable;
}

/// Returns the coarsest settings with the scene's own scheme and elements within the tolerance, or the finest tested.
AdvicePoint AdviceSearch::own_plan(const std::vector<AdviceCandidate>& all) const {
  const auto own = std::find_if(all.begin(), all.end(), [&](const AdviceCandidate& each) {
    return each.error <= question_.tolerance && each.point[time_direction].branch == 0 &&
           each.point[mesh_direction].branch == 0;
  });
  if (own != all.end()) return own->point;
  const AdviceErrors known = errors();
  AdvicePoint corner = base_;
  for (std::size_t d = 0; d < corner.size(); ++d) corner[d].level = known.finest(d, 0);
  return corner;
}

/// Returns the trials of a direction that still pay: each for itself, and all of them together at most `allowance`
/// seconds.
bool AdviceSearch::try_one(const std::vector<AdviceTrial>& trials, const std::vector<double>& allowance) {
  const AdviceCosts cost = costs();
  const AdviceTrial* best = nullptr;
  double best_return = 0;
  for (const AdviceTrial& trial : trials) {
    const double seconds = cost.seconds(trial.point), left = allowance[trial.direction] - tried_[trial.direction];
    if (seconds > left || !runs_.affords(seconds)) continue;
    const double value = trial.promise * allowance[trial.direction] / seconds;
    if (best != nullptr && value <= best_return) continue;
    best = &trial;
    best_return = value;
  }
  if (best == nullptr) return false;
  const double before = runs_.spent();
  runs_.carry_out({best->point});
  tried_[best->direction] += runs_.spent() - before;
  return true;
}

/// Tries other branches of a direction before a dear refinement.
bool AdviceSearch::try_before(std::size_t d) {
  std::vector<double> allowance(directions_.all.size(), 0);
  const std::size_t next = std::min(errors().finest(d, 0) + 1, levels(d) - 1);
  allowance[d] = costs().seconds(moved(d, next));
  const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
  std::vector<AdviceTrial> trials =
      explorations(directions_, base_, own_plan(all), runs_.samples(), errors(), question_.tolerance);
  const auto is_poorer = [&](const AdviceTrial& trial) {
    return !branch_at(directions_, trial.point, d).may_be_better;
  };
  trials.erase(std::remove_if(trials.begin(), trials.end(), is_poorer), trials.end());
  return try_one(trials, allowance);
}

/// Refines a line once more if the order that this may confirm would allow for cheaper settings. Returns whether a run
/// was carried out.
bool AdviceSearch::confirm_order(const AdviceCandidate& plan, double least) {
  const AdviceErrors known = errors();
  for (std::size_t d : {time_direction, mesh_direction}) {
    const AdvicePoint next = moved(d, known.finest(d, 0) + 1);
    if (next[d].level >= levels(d) || runs_.sample(next) != nullptr) continue;
    const AdviceCosts cost = costs();
    const std::vector<AdviceCandidate> hoped = candidates(directions_, known.hopeful(d), cost, 0);
    const AdviceCandidate* better = cheapest_within(hoped, question_.tolerance);
    if (better == nullptr) continue;
    const double seconds = cost.seconds(next), saving = plan.seconds - std::max(better->seconds, least);
    if (seconds > worthwhile * saving || !pays(seconds, plan)) continue;
    runs_.carry_out({next});
    return true;
  }
  return false;
}

/// Returns whether a run leaves enough for the plan, of the user's budget or a multiple of the plan's cost.
bool AdviceSearch::pays(double seconds, const AdviceCandidate& plan) const {
  const double most = question_.budget > 0 ? runs_.budget() : times_the_scene * plan.seconds;
  const double total = seconds + plan.seconds;
  return runs_.spent() + total <= most && runs_.affords(total);
}

/// Tries other choices, and confirms orders, while the runs cost little beside what they may save in one run.
void AdviceSearch::improve() {
  for (std::size_t round = 0; round < most_rounds; ++round) {
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
    if (!try_one(trials, allowance)) return;
  }
}

}  // namespace ixos
