#include "study/advice/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "study/advice/advice_plane.hpp"
#include "study/advice/advice_search.hpp"
#include "study/common/results_folder.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// Returns what the places off the recommended point contribute to the errors: of step and mesh, other branches at
/// their finest tested level.
std::vector<AdviceChoice> choices(const AdviceDirections& directions, const AdvicePoint& best,
                                  const AdviceErrors& known, const AdviceCosts& cost) {
  std::vector<AdviceChoice> all;
  for (std::size_t d = 0; d < best.size(); ++d)
    for (std::size_t b = 0; b < directions.all[d].branches.size(); ++b) {
      if (known.tested(d, b) == 0 || (d <= mesh_direction && b == best[d].branch)) continue;
      std::vector<std::size_t> levels = known.levels(d, b);
      if (d <= mesh_direction) levels = {levels.back()};
      for (std::size_t level : levels) {
        AdvicePoint point = best;
        point[d] = {b, level};
        if (point == best) continue;
        AdviceChoice found{directions.all[d].name, place_label(directions, point, d), {}, cost.seconds(point)};
        for (const std::vector<double>& parts : known.estimate(point).parts) found.errors.push_back(parts[d]);
        if (std::isfinite(found.errors.front())) all.push_back(found);
      }
    }
  return all;
}

/// Fills in the answer, and what the runs tell beside it.
void conclude(const AdviceQuestion& question, AdviceSearch& search, Advice& advice) {
  const AdviceErrors known = search.errors();
  const AdviceCosts cost = search.costs();
  const std::vector<AdviceCandidate> tested = candidates(advice.directions, known, cost, 0);
  const AdviceCandidate* best =
      advice.status == AdviceStatus::Advised ? cheapest_within(tested, question.tolerance) : most_accurate(tested);
  if (best == nullptr) {
    advice.problem = "The runs are too few to estimate errors." + (advice.problem.empty() ? "" : " " + advice.problem);
    for (const AdviceSample& sample : search.runs().samples())
      if (!sample.good)
        advice.problem += fmt::format(" {}: {}.", description_of(advice.directions, sample.point), sample.reason);
    advice.status = AdviceStatus::Unreachable;
    return;
  }
  advice.best = *best;
  for (const AdviceSample& each : search.runs().samples())
    advice.sample_errors.push_back(known.estimate(each.point).largest());
  advice.choices = choices(advice.directions, best->point, known, cost);
  const AdviceSample* sample = search.runs().sample(best->point);
  advice.confirmed = sample != nullptr && sample->good;
  if (sample != nullptr && sample->failed_later) advice.fails_later = sample->reason;
  advice.trades = best_trades(tested);
  const std::vector<AdviceCandidate> further = candidates(advice.directions, known, cost, tuning::extrapolated_levels);
  for (double factor : tuning::other_tolerances) {
    const AdviceCandidate* found = cheapest_within(further, factor * question.tolerance);
    advice.other_tolerances.emplace_back(factor * question.tolerance, found == nullptr ? AdviceCandidate() : *found);
  }
  if (const AdviceCandidate* hoped = cheapest_within(further, question.tolerance);
      hoped != nullptr && advice.status == AdviceStatus::Unreachable)
    advice.sufficient_budget = search.runs().spent() + tuning::runs_on_the_way * hoped->seconds;
  for (std::size_t q = 0; q < question.quantities.size(); ++q) {
    advice.exact.push_back(known.exact(q));
    advice.interaction = std::max(advice.interaction, known.interaction(best->point, q));
  }
  for (std::size_t d = 0; d < advice.directions.all.size(); ++d) {
    std::vector<std::string>& reasons = advice.reasons.emplace_back();
    std::vector<bool>& examined = advice.examined.emplace_back();
    for (std::size_t q = 0; q < question.quantities.size(); ++q) {
      reasons.push_back(known.reason(d, q));
      examined.push_back(known.is_examined(best->point, d, q));
    }
  }
}

/// Runs half the step on the next finer mesh, as far as there are, whatever it costs, and compares.
void verify(const AdviceQuestion& question, AdviceRuns& runs, Advice& advice) {
  AdviceVerification& found = advice.verification;
  AdvicePoint finer = advice.best.point;
  for (std::size_t d : {time_direction, mesh_direction}) {
    if (finer[d].level + 1 >= branch_at(advice.directions, finer, d).levels.size()) continue;
    ++finer[d].level;
    (d == time_direction ? found.step : found.mesh) = true;
  }
  if (finer == advice.best.point) {
    found.problem = "there is neither a shorter step nor a finer mesh";
    return;
  }
  const double budget = runs.budget();
  runs.set_budget(0);
  runs.carry_out({advice.best.point, finer});
  runs.set_budget(budget);
  const AdviceSample *coarse = runs.sample(advice.best.point), *fine = runs.sample(finer);
  for (const AdviceSample* sample : {fine, coarse})
    if (!sample->good)
      found.problem = fmt::format("{} failed: {}", description_of(advice.directions, sample->point), sample->reason);
  if (!found.problem.empty()) return;
  found.change = 0;
  for (std::size_t q = 0; q < coarse->values.size(); ++q) {
    const double difference = std::abs(fine->values[q] - coarse->values[q]);
    const double scale = question.quantities[q].is_error() ? 1 : std::abs(fine->values[q]);
    found.change = std::max(found.change, difference == 0 ? 0 : difference / scale);
  }
}

/// Whether to go on after the first run.
using GoesOn = std::function<bool(const AdviceDirections&, AdviceRuns&)>;

/// Answers a question; returns nothing if goes_on() does not want it. `spent`: on runs before [s].
std::optional<Advice> answer(const AdviceQuestion& question, const AdviceOptions& options, double spent,
                             const GoesOn& goes_on) {
  const Teuchos::ParameterList scene = changed_scene(question.scene, question.common);
  Advice advice;
  advice.directions = advice_directions(scene);
  AdviceSearch search(question, options, advice.directions);
  search.runs().count(spent);
  try {
    search.begin(scene.sublist("Time Integrator").sublist("Time Step Control"));
    if (!goes_on(advice.directions, search.runs())) return std::nullopt;
    advice.status = search.find();
    advice.problem = search.problem();
    advice.sensitivities = search.sensitivities();
    const bool has_errors = advice.status == AdviceStatus::Advised || advice.status == AdviceStatus::Unreachable;
    if (has_errors) conclude(question, search, advice);
    if (advice.status == AdviceStatus::Advised && question.verify) verify(question, search.runs(), advice);
  } catch (const AdviceRuns::Interrupted&) {
    advice.status = AdviceStatus::Interrupted;
  }
  advice.samples = search.runs().samples();
  advice.sample_errors.resize(advice.samples.size(), std::numeric_limits<double>::infinity());
  advice.spent = search.runs().spent();
  advice.budget = search.runs().budget();
  return advice;
}

/// Answers a question on a scene in space in two dimensions, if the first runs of both agree. `spent`: set to what
/// the first runs cost [s].
std::optional<Advice> answer_in_plane(const AdviceQuestion& question, const AdviceOptions& options, double& spent) {
  std::optional<AdvicePlane> plane = plane_question(question, options.folder + "/plane.xml");
  if (!plane) return std::nullopt;
  write_plane_scene(question, *plane);
  const auto agree = [&](const AdviceDirections& directions, AdviceRuns& runs) {
    plane->difference = difference_from_space(question, *plane, directions, runs, runs.samples().back().point);
    spent = runs.spent();
    return plane->difference <= tuning::most_of_plane * question.tolerance;
  };
  std::optional<Advice> advice;
  std::string why;
  try {
    advice = answer(plane->question, options, 0, agree);
  } catch (const InputError& error) {
    why = error.what();
  }
  if (advice) {
    if (std::isfinite(plane->difference)) advice->plane = std::move(plane);
    return advice;
  }
  std::filesystem::remove(plane->question.scene);
  if (why.empty())
    why = std::isfinite(plane->difference)
              ? fmt::format("the quantities or their columns differ by {:.2g} %", 100 * plane->difference)
              : "one of the first runs failed, or a quantity is 0";
  if (options.log) options.log("Two dimensions will not do: " + why + ".");
  return std::nullopt;
}

}  // namespace

Advice advise(const AdviceQuestion& question, const AdviceOptions& options) {
  if (question.quantities.empty())
    throw InputError(
        "an advice needs a quantity: --quantity \"FORM\", or Output/Quantities of the scene. Forms are:\n" +
        quantity_forms());
  const Teuchos::ParameterList scene = changed_scene(question.scene, question.common);  // before anything is written
  if (scene.sublist("Stages").numParams() > 0)
    throw InputError(
        question.scene +
        ": an advice does not vary the steps of Stages, which the scene has: use --scan, or a scene of one "
        "stage");
  std::error_code code;
  std::filesystem::create_directories(options.folder, code);
  if (code) throw FileError("the results folder cannot be used: " + options.folder + ": " + code.message());
  const std::string path = std::filesystem::absolute(question.scene).lexically_normal().string();
  const ResultsFolder held(options.folder, printable("the advice on " + path), options.overwrite);
  double spent = 0;
  if (std::optional<Advice> advice = answer_in_plane(question, options, spent)) return std::move(*advice);
  return *answer(question, options, spent, [](const AdviceDirections&, AdviceRuns&) { return true; });
}

}  // namespace ixos
