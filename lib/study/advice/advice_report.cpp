#include "study/advice/advice_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/disk_file.hpp"
#include "scene/scene_file.hpp"
#include "study/common/absolute_paths.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

using Json = nlohmann::ordered_json;
using List = Teuchos::ParameterList;

std::string percent(double part) { return std::isfinite(part) ? fmt::format("{:.2g} %", 100 * part) : "unknown"; }

const char* word(AdviceStatus status) {
  switch (status) {
    case AdviceStatus::Advised:
      return "advised";
    case AdviceStatus::Chaotic:
      return "chaotic";
    case AdviceStatus::Unreachable:
      return "unreachable";
    case AdviceStatus::NoRun:
      return "no run";
    default:
      return "interrupted";
  }
}

/// Returns the direction that contributes most to the error of the best settings.
const AdviceDirection& limiting(const Advice& advice) {
  return advice.directions.all[advice.best.estimate.worst_direction()];
}

/// Returns what is known of a part that was not examined, in brackets.
std::string remark(const std::string& reason) { return reason == not_examined ? "" : " (" + reason + ")"; }

/// Returns names as "step, mesh and cutoff".
std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// Returns the names of the directions whose parts the error of a quantity contains, or of those that it does not
/// contain because the runs did not examine them. Choices that are the scene's own are in neither.
std::vector<std::string> parts_of(const Advice& advice, std::size_t q, bool examined) {
  std::vector<std::string> names;
  for (std::size_t d = 0; d < advice.directions.all.size(); ++d) {
    const AdviceDirection& direction = advice.directions.all[d];
    const bool counts = direction.converges || advice.best.estimate.parts[q][d] > 0;
    if (counts && advice.examined[d][q] == examined) names.push_back(direction.name);
  }
  return names;
}

/// Returns which of step and mesh was not examined for some quantity.
std::vector<std::string> open_parts(const Advice& advice) {
  std::vector<std::string> names;
  for (std::size_t d : {time_direction, mesh_direction}) {
    const std::vector<bool>& examined = advice.examined[d];
    if (std::find(examined.begin(), examined.end(), false) != examined.end())
      names.push_back(advice.directions.all[d].name);
  }
  return names;
}

/// Returns the lines on each quantity's error and its parts.
std::string error_lines(const AdviceQuestion& question, const Advice& advice) {
  std::string text;
  for (std::size_t q = 0; q < question.quantities.size(); ++q) {
    const AdvicePoint& point = advice.best.point;
    const std::string open = joined(parts_of(advice, q, false));
    text += fmt::format("  {}: about {:.6g}, error at most {} of {}{}\n", question.quantities[q].text(),
                        advice.exact[q], percent(advice.best.estimate.errors[q]), joined(parts_of(advice, q, true)),
                        open.empty() ? "" : "; not examined: " + open);
    for (std::size_t d = 0; d < point.size(); ++d) {
      const double part = advice.best.estimate.parts[q][d];
      const AdviceDirection& direction = advice.directions.all[d];
      if (!advice.examined[d][q])
        text += fmt::format("    {}: not examined{}\n", direction.name, remark(advice.reasons[d][q]));
      else if (direction.converges || part > 0)
        text += fmt::format("    {}: {} ({})\n", direction.name, percent(part), advice.reasons[d][q]);
    }
  }
  if (advice.interaction > 0)
    text += fmt::format("  Runs that combine changes differ from the sum of the changes by at most {}.\n",
                        percent(advice.interaction));
  for (std::size_t q = 0; q < advice.sensitivities.size(); ++q)
    if (advice.sensitivities[q].kind == Predictability::Sensitive)
      text += fmt::format("  {} is sensitive: a change of the density by {} changes it by {}.\n",
                          question.quantities[q].text(), tuning::perturbation_size,
                          percent(advice.sensitivities[q].change));
  if (!advice.directions.mesh_note.empty())
    text += fmt::format("  The mesh was not examined: {}.\n", advice.directions.mesh_note);
  return text;
}

/// Returns the question that settings and quantities of the advice belong to.
const AdviceQuestion& question_of(const AdviceQuestion& asked, const Advice& advice) {
  return advice.plane ? advice.plane->question : asked;
}

std::string plane_line(const AdvicePlane& plane) {
  return fmt::format(
      "Two dimensions will do: nothing acts along y. On the coarsest mesh they change the quantities by {}. Settings "
      "and numbers below are for a depth of 1 L0, where the scene has {:.6g} L0; z is called y.\n",
      percent(plane.difference), plane.depth);
}

/// Returns a sentence on the verification; empty if nobody asked for one.
std::string verification_sentence(const AdviceVerification& found) {
  if (!found.problem.empty()) return fmt::format("Not verified: {}.", found.problem);
  if (found.change < 0) return "";
  const char* const changes = "changes the quantities by at most";
  if (found.step && found.mesh)
    return fmt::format("Verified: half the step on the next finer mesh {} {}.", changes, percent(found.change));
  if (found.step)
    return fmt::format("Verified for the step alone: half the step {} {}; there is no finer mesh.", changes,
                       percent(found.change));
  return fmt::format("Verified for the mesh alone: the next finer mesh {} {}; there is no shorter step.", changes,
                     percent(found.change));
}

std::string tolerance_lines(const Advice& advice) {
  std::string text = "Costs of other tolerances:\n";
  for (const auto& [tolerance, candidate] : advice.other_tolerances) {
    text += fmt::format("  {:>8}  ", percent(tolerance));
    if (candidate.point.empty())
      text += "no settings that the runs tell of\n";
    else
      text += fmt::format("{:.2g} s  {}{}\n", candidate.seconds, description_of(advice.directions, candidate.point),
                          candidate.estimate.beyond > 0 ? " (extrapolated)" : "");
  }
  return text;
}

std::string choice_lines(const Advice& advice) {
  std::string text;
  for (const AdviceChoice& choice : advice.choices) {
    const double error = *std::max_element(choice.errors.begin(), choice.errors.end());
    text += fmt::format("  {}: error {}, {:.2g} s\n", choice.label, percent(error), choice.seconds);
  }
  return text.empty() ? "" : "Other choices, each alone, and what the recommended run would take with it:\n" + text;
}

Json json_of(const Advice& advice, const AdviceCandidate& candidate) {
  if (candidate.point.empty()) return nullptr;
  return {{"settings", settings_of(advice.directions, candidate.point)},
          {"description", description_of(advice.directions, candidate.point)},
          {"error", candidate.error},
          {"seconds", candidate.seconds},
          {"extrapolated", candidate.estimate.beyond > 0}};
}

void write_scene(const AdviceQuestion& question, const Advice& advice, const std::string& path) {
  Assignments settings = question.common;
  for (const std::string& more : settings_of(advice.directions, advice.best.point)) settings.push_back(more);
  List scene = user_scene(question.scene, settings);
  make_paths_absolute(scene, question.scene);
  write_scene_file(scene, path);
}

}  // namespace

std::string advice_text(const AdviceQuestion& asked, const Advice& advice) {
  const AdviceQuestion& question = question_of(asked, advice);
  std::string text;
  const bool known = !advice.best.point.empty();
  const std::string best = known ? description_of(advice.directions, advice.best.point) : "";
  if (advice.plane) text += plane_line(*advice.plane);
  if (advice.status == AdviceStatus::Advised) {
    const std::string open = joined(open_parts(advice));
    text +=
        fmt::format("Recommended within the tolerance {}{}: {}, {} {:.2g} s\n", percent(question.tolerance),
                    open.empty() ? "" : " but for the " + open + ", which the runs did not examine", best,
                    advice.confirmed ? "which took" : "which was not run and should take about", advice.best.seconds);
    if (!advice.fails_later.empty())
      text += "That run fails after the times that decide the quantities: " + advice.fails_later + ".\n";
  } else if (advice.status == AdviceStatus::Unreachable && known) {
    text += fmt::format(
        "No settings were found within the tolerance {}. The smallest error seen is {}, limited by the {}: {}, {:.2g} "
        "s\n",
        percent(question.tolerance), percent(advice.best.error), limiting(advice).name, best, advice.best.seconds);
  }
  if (!advice.problem.empty()) text += advice.problem + "\n";
  if (advice.sufficient_budget > advice.budget)
    text +=
        fmt::format("If errors and costs go on as they did, a budget of {:.2g} s will do.\n", advice.sufficient_budget);
  else if (advice.status == AdviceStatus::Unreachable && known)
    text += "The runs do not tell what budget would do.\n";
  if (known) {
    text += error_lines(question, advice);
    if (advice.status == AdviceStatus::Advised)
      text += fmt::format("The accuracy{} is limited by the {}.\n",
                          open_parts(advice).empty() ? "" : ", as far as it was examined,", limiting(advice).name);
    if (const std::string verified = verification_sentence(advice.verification); !verified.empty())
      text += verified + "\n";
    text += choice_lines(advice) + tolerance_lines(advice);
  }
  return text + fmt::format("The advice took {:.3g} s of processor time, of a budget of {:.3g} s.\n", advice.spent,
                            advice.budget);
}

void write_advice(const AdviceQuestion& asked, const Advice& advice, const std::string& folder,
                  const std::string& command, const std::string& version) {
  const AdviceQuestion& question = question_of(asked, advice);
  Json json = {{"scene", asked.scene}, {"command", command}, {"version", version}, {"status", word(advice.status)}};
  json["tolerance"] = question.tolerance;
  json["budget_seconds"] = advice.budget;
  json["spent_seconds"] = advice.spent;
  json["sufficient_budget_seconds"] = advice.sufficient_budget > 0 ? Json(advice.sufficient_budget) : Json(nullptr);
  json["problem"] = advice.problem;
  json["plane"] = nullptr;
  if (advice.plane)
    json["plane"] = {
        {"scene", question.scene}, {"depth", advice.plane->depth}, {"difference", advice.plane->difference}};
  json["recommended"] = advice.status == AdviceStatus::Advised ? json_of(advice, advice.best) : Json(nullptr);
  json["most_accurate"] = advice.status == AdviceStatus::Unreachable ? json_of(advice, advice.best) : Json(nullptr);
  json["confirmed"] = advice.confirmed;
  json["fails_later"] = advice.fails_later;
  json["verified_change"] = advice.verification.change >= 0 ? Json(advice.verification.change) : Json(nullptr);
  json["verification"] = verification_sentence(advice.verification);
  json["quantities"] = Json::array();
  for (std::size_t q = 0; q < question.quantities.size(); ++q) {
    Json one = {{"name", question.quantities[q].text()}};
    if (q < advice.exact.size()) one["estimate"] = advice.exact[q];
    if (q < advice.sensitivities.size()) one["change_by_perturbation"] = advice.sensitivities[q].change;
    if (!advice.best.point.empty()) {
      one["error"] = advice.best.estimate.errors[q];
      one["error_of"] = parts_of(advice, q, true);
      one["not_examined"] = parts_of(advice, q, false);
      for (std::size_t d = 0; d < advice.directions.all.size(); ++d) {
        const bool examined = advice.examined[d][q];
        one["parts"][advice.directions.all[d].name] = {
            {"error", examined ? Json(advice.best.estimate.parts[q][d]) : Json(nullptr)},
            {"examined", examined},
            {"reason", advice.reasons[d][q]}};
      }
    }
    json["quantities"].push_back(one);
  }
  json["pareto"] = Json::array();
  for (const AdviceCandidate& each : advice.trades) json["pareto"].push_back(json_of(advice, each));
  json["other_tolerances"] = Json::array();
  for (const auto& [tolerance, candidate] : advice.other_tolerances)
    json["other_tolerances"].push_back({{"tolerance", tolerance}, {"settings", json_of(advice, candidate)}});
  json["runs"] = Json::array();  // an unknown error, which is infinite, is written as null
  for (std::size_t i = 0; i < advice.samples.size(); ++i) {
    const AdviceSample& sample = advice.samples[i];
    json["runs"].push_back(
        {{"name", name_of(advice.directions, sample.point)},
         {"description", description_of(advice.directions, sample.point)},
         {"good", sample.good},
         {"failed_later", sample.failed_later},
         {"reason", sample.reason},
         {"values", sample.values},
         {"seconds", sample.seconds},
         {"error", i < advice.sample_errors.size() ? Json(advice.sample_errors[i]) : Json(nullptr)}});
  }
  json["choices"] = Json::array();
  for (const AdviceChoice& choice : advice.choices)
    json["choices"].push_back({{"direction", choice.direction},
                               {"choice", choice.label},
                               {"errors", choice.errors},
                               {"seconds", choice.seconds}});
  if (advice.status == AdviceStatus::Advised)
    write_scene(question, advice, folder + "/advised.xml");
  else
    std::filesystem::remove(folder + "/advised.xml");
  write_whole_file(folder + "/advice.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace ixos
