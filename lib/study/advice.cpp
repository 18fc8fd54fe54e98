#include "study/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "study/advice_exploration.hpp"
#include "study/advice_runs.hpp"
#include "study/results_folder.hpp"

namespace ixos {
namespace {

constexpr double times_the_scene = 8;     ///< the default budget over the expected cost of the scene as it is
constexpr double least_budget = 20;       ///< seconds; a process takes half of one to start
constexpr std::size_t first_steps = 3;    ///< runs of the first sequence
constexpr std::size_t most_rounds = 100;  ///< of a search that would not end
constexpr double half = 0.5;              ///< of the tolerance: for the time step, and for the mesh
constexpr std::array<double, 5> other_tolerances{10, 3, 1, 1.0 / 3, 0.1};

class Search {
 public:
  Search(const AdviceQuestion& question, const AdviceOptions& options, Advice& advice)
      : question_(question),
        options_(options),
        advice_(advice),
        runs_(question, options, advice.directions),
        base_(scene_point(advice.directions)),
        noise_(question.quantities.size(), 0) {
    base_[time_direction].level = base_[mesh_direction].level = 0;
    for (const AskedQuantity& quantity : question.quantities) is_error_.push_back(quantity.is_error());
  }

  void run(const Teuchos::ParameterList& control) {
    try {
      set_budget(control);
      advice_.status = find();
    } catch (const AdviceRuns::Interrupted&) {
      advice_.status = AdviceStatus::Interrupted;
    }
    advice_.samples = runs_.samples();
    advice_.spent = runs_.spent();
    advice_.budget = runs_.budget();
  }

 private:
  AdviceErrors errors() const { return {advice_.directions, base_, runs_.samples(), is_error_, noise_}; }
  AdviceCosts costs() const { return {advice_.directions, runs_.samples()}; }
  void tell(const std::string& line) const {
    if (options_.tell) options_.tell(line);
  }

  /// Runs a few coarse steps, checks the quantities, and states the budget.
  void set_budget(const Teuchos::ParameterList& control) {
    const double start = control.get<double>("Initial Time"), end = control.get<double>("Final Time");
    const double seconds = runs_.probe(base_, start, end, control.get<double>("Time Step"));
    const AdviceDirection& mesh = advice_.directions.all[mesh_direction];
    const double cells = std::pow(2.0, advice_.directions.dimension * static_cast<double>(mesh.scene_level));
    const double scene =
        seconds * (end - start) / control.get<double>("Time Step") * std::pow(cells, CostModel().dof_power);
    const double budget = question_.budget > 0 ? question_.budget : std::max(times_the_scene * scene, least_budget);
    runs_.set_budget(budget);
    tell(fmt::format("Budget: {:.3g} s of processor time{}. The scene as it is takes about {:.2g} s.", budget,
                     question_.budget > 0 ? ""
                                          : fmt::format(", the larger of {:g} times the scene as it is and {:g} s",
                                                        times_the_scene, least_budget),
                     scene));
  }

  AdviceStatus find() {
    if (!first_sequence()) return AdviceStatus::NoRun;
    if (!measure_sensitivity()) return AdviceStatus::Chaotic;
    refine(time_direction, half);
    choose_base_step();
    refine(mesh_direction, half);
    const AdviceStatus status = settle();
    conclude();
    if (status == AdviceStatus::Advised && question_.verify) verify();
    return status;
  }

  std::size_t good_on(std::size_t d) const { return errors().tested(d, 0); }

  AdvicePoint with(std::size_t d, std::size_t level) const {
    AdvicePoint point = base_;
    point[d] = {0, level};
    return point;
  }

  /// Runs the coarsest steps on the coarsest mesh that allows any.
  bool first_sequence() {
    const std::size_t steps = advice_.directions.all[time_direction].branches[0].levels.size();
    const std::size_t meshes = advice_.directions.all[mesh_direction].branches[0].levels.size();
    for (; base_[mesh_direction].level < meshes; ++base_[mesh_direction].level) {
      std::vector<AdvicePoint> batch;
      for (std::size_t level = 0; level < std::min(first_steps, steps); ++level)
        batch.push_back(with(time_direction, level));
      runs_.carry_out(batch);
      for (std::size_t level = first_steps; level < steps && good_on(time_direction) < first_steps; ++level) {
        const AdvicePoint next = with(time_direction, level);
        if (!runs_.affords(costs().seconds(next))) break;
        runs_.carry_out({next});
      }
      if (good_on(time_direction) > 0) break;
      if (!runs_.affords(0)) break;
    }
    if (base_[mesh_direction].level < meshes && good_on(time_direction) > 0) {
      base_[time_direction].level = errors().finest(time_direction, 0);
      return true;
    }
    advice_.problem = "No run gave the quantities within the budget. The last one: " +
                      (runs_.samples().empty() ? "none" : runs_.samples().back().reason) + ".";
    return false;
  }

  /// Runs the middle one of the first steps once more, perturbed. Returns whether all quantities can be predicted.
  bool measure_sensitivity() {
    std::vector<const AdviceSample*> good;
    for (const AdviceSample& sample : runs_.samples())
      if (sample.good) good.push_back(&sample);
    const AdviceSample middle = *good[good.size() / 2];
    const std::vector<double> values = runs_.perturbed(middle.point);
    if (values.size() != middle.values.size()) return true;
    bool predictable = true;
    for (std::size_t q = 0; q < values.size(); ++q) {
      const Sensitivity found = sensitivity(middle.values[q], values[q], question_.tolerance);
      advice_.sensitivities.push_back(found);
      noise_[q] = is_error_[q] ? found.change * std::abs(values[q]) : found.change;
      if (found.kind != Predictability::Chaotic || is_error_[q]) continue;
      predictable = false;
      advice_.problem += fmt::format(
          "{}The scene is chaotic for {}: a change of the density by 1e-10 changes it by {:.2g} %. No step or mesh "
          "makes "
          "it converge. {}",
          advice_.problem.empty() ? "" : " ", question_.quantities[q].text(), 100 * found.change,
          question_.quantities[q].is_statistic() ? "A longer window gives a mean that varies less."
                                                 : "Means over a long window and the energy error can be predicted.");
    }
    return predictable;
  }

  /// Refines a direction until its finest run has at most a part of the tolerance, as far as half of the budget goes.
  void refine(std::size_t d, double part) {
    while (true) {
      const AdviceErrors known = errors();
      if (known.tested(d, 0) > 1 && known.finest_error(d, 0) <= part * question_.tolerance) return;
      if (!refine_once(d)) return;
    }
  }

  /// Runs the next finer level of a direction. Returns false if there is none that the budget affords, or if it fails.
  bool refine_once(std::size_t d) {
    const AdviceErrors known = errors();
    const std::size_t next = known.finest(d, 0) + 1;
    if (next >= advice_.directions.all[d].branches[0].levels.size()) return false;
    const AdvicePoint point = with(d, next);
    if (runs_.sample(point) != nullptr) return false;  // it failed
    if (!runs_.affords(costs().seconds(point))) return false;
    runs_.carry_out({point});
    return runs_.sample(point)->good;
  }

  /// Makes the coarsest step within its part of the tolerance the base of the other directions.
  void choose_base_step() {
    const AdviceErrors known = errors();
    for (std::size_t level = 0; level <= known.finest(time_direction, 0); ++level) {
      const AdvicePoint point = with(time_direction, level);
      const AdviceSample* sample = runs_.sample(point);
      if (sample == nullptr || !sample->good) continue;
      const AdviceEstimate estimate = known.estimate(point);
      bool small = true;
      for (const std::vector<double>& parts : estimate.parts)
        small = small && parts[time_direction] <= half * question_.tolerance;
      base_[time_direction].level = level;
      if (small) return;
    }
  }

  /// Tries other choices while that pays, and runs the cheapest settings within the tolerance.
  AdviceStatus settle() {
    for (std::size_t round = 0; round < most_rounds; ++round) {
      const AdviceErrors known = errors();
      const AdviceCosts cost = costs();
      const std::vector<AdviceCandidate> all = candidates(advice_.directions, known, cost, 1);
      const AdviceCandidate* plan = cheapest_within(all, question_.tolerance);
      if (plan == nullptr) {
        if (!refine_worst(candidates(advice_.directions, known, cost, 0))) return AdviceStatus::Unreachable;
        continue;
      }
      const AdvicePoint next = next_exploration(advice_.directions, base_, runs_.samples(), known, question_.tolerance);
      if (!next.empty()) {
        const double seconds = cost.seconds(next);
        if (runs_.affords(seconds) && seconds <= half * plan->seconds &&
            runs_.spent() + seconds + plan->seconds <= times_the_scene * plan->seconds) {
          runs_.carry_out({next});
          continue;
        }
      }
      advice_.best = *plan;
      const AdviceSample* sample = runs_.sample(plan->point);
      advice_.confirmed = sample != nullptr && sample->good;
      if (advice_.confirmed || !runs_.affords(plan->seconds)) return AdviceStatus::Advised;
      runs_.carry_out({plan->point});
    }
    return AdviceStatus::Advised;
  }

  /// Refines the direction that limits the most accurate candidate, or another if that cannot be refined.
  bool refine_worst(const std::vector<AdviceCandidate>& all) {
    const AdviceCandidate* best = most_accurate(all);
    const std::size_t worst = best == nullptr ? mesh_direction : best->estimate.worst_direction();
    if (worst <= mesh_direction && refine_once(worst)) return true;
    return refine_once(worst == time_direction ? mesh_direction : time_direction);
  }

  /// Fills in what the runs tell in the end.
  void conclude() {
    const AdviceErrors known = errors();
    const AdviceCosts cost = costs();
    const std::vector<AdviceCandidate> tested = candidates(advice_.directions, known, cost, 0);
    if (advice_.best.point.empty()) {
      if (const AdviceCandidate* best = most_accurate(tested)) advice_.best = *best;
      const AdviceSample* sample = advice_.best.point.empty() ? nullptr : runs_.sample(advice_.best.point);
      advice_.confirmed = sample != nullptr && sample->good;
    }
    advice_.trades = best_trades(tested);
    const std::vector<AdviceCandidate> further = candidates(advice_.directions, known, cost, 3);
    for (double factor : other_tolerances) {
      const AdviceCandidate* found = cheapest_within(further, factor * question_.tolerance);
      advice_.other_tolerances.emplace_back(factor * question_.tolerance,
                                            found == nullptr ? AdviceCandidate() : *found);
    }
    for (std::size_t q = 0; q < question_.quantities.size(); ++q) {
      advice_.exact.push_back(known.exact(q));
      advice_.interaction = std::max(advice_.interaction, known.interaction(q));
    }
    for (std::size_t d = 0; d < advice_.directions.all.size(); ++d) {
      std::vector<std::string>& reasons = advice_.reasons.emplace_back();
      for (std::size_t q = 0; q < question_.quantities.size(); ++q) reasons.push_back(known.reason(d, q));
    }
    if (advice_.best.point.empty()) advice_.problem = "The budget sufficed for no estimate of the errors.";
  }

  /// Runs half the step on the next finer mesh, and compares.
  void verify() {
    AdvicePoint finer = advice_.best.point;
    for (std::size_t d : {time_direction, mesh_direction})
      finer[d].level = std::min(finer[d].level + 1, branch_at(advice_.directions, finer, d).levels.size() - 1);
    runs_.set_budget(HUGE_VAL);  // the user asked for it
    runs_.carry_out({advice_.best.point, finer});
    const AdviceSample *coarse = runs_.sample(advice_.best.point), *fine = runs_.sample(finer);
    if (!coarse->good || !fine->good) return;
    advice_.verified = 0;
    for (std::size_t q = 0; q < coarse->values.size(); ++q) {
      const double scale = is_error_[q] ? 1 : std::abs(fine->values[q]);
      advice_.verified = std::max(advice_.verified, std::abs(fine->values[q] - coarse->values[q]) / scale);
    }
  }

  const AdviceQuestion& question_;
  const AdviceOptions& options_;
  Advice& advice_;
  AdviceRuns runs_;
  AdvicePoint base_;
  std::vector<bool> is_error_;
  std::vector<double> noise_;
};

}  // namespace

Advice advise(const AdviceQuestion& question, const AdviceOptions& options) {
  if (question.quantities.empty()) throw InputError("an advice needs a quantity. Quantities are:\n" + quantity_forms());
  const Teuchos::ParameterList scene = changed_scene(question.scene, question.common);
  std::error_code code;
  std::filesystem::create_directories(options.folder, code);
  if (code) throw FileError("the results folder cannot be used: " + options.folder + ": " + code.message());
  const std::string path = std::filesystem::absolute(question.scene).lexically_normal().string();
  const ResultsFolder held(options.folder, printable("the advice on " + path), options.overwrite);
  Advice advice;
  advice.directions = advice_directions(scene);
  Search(question, options, advice).run(scene.sublist("Time Integrator").sublist("Time Step Control"));
  return advice;
}

}  // namespace ixos
