#include "study/accuracy/accuracy_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

using Json = nlohmann::ordered_json;

/// The sources of error that the runs judge, and those that they do not.
struct Scope {
  std::string covered;
  std::vector<std::string> not_covered;
};
Scope scope_of(const AccuracyResult& result) {
  if (result.mesh_is_judged)
    return {"time steps, the tolerance of Newton's method and the mesh at the front",
            {"coarse cells", "surface points", "cutoffs"}};
  return {"time steps and the tolerance of Newton's method, not the mesh", {"mesh", "surface points", "cutoffs"}};
}

std::string percent(double part) {
  return std::isfinite(part) ? fmt::format("{:.2g} %", 100 * part) : "unknown, as the value may be 0";
}

Json read_summary(const std::string& folder) {
  std::ifstream file = open_text(folder + "/summary.json");
  Json summary = Json::parse(file, nullptr, false);
  if (!summary.is_object()) throw FileError(folder + "/summary.json: cannot be read");
  return summary;
}

Json to_json(const AccuracyRun& run) {
  Json json{{"tolerance", run.settings.tolerance},
            {"gap_ratio", run.settings.gap_ratio},
            {"longest_step", run.settings.longest_step},
            {"newton_tolerance", run.settings.newton_tolerance},
            {"steps", run.steps},
            {"seconds", run.seconds},
            {"values", run.values}};
  if (const MeshSettings& mesh = run.settings.mesh; mesh.levels > 0)
    json["mesh"] = {{"levels", mesh.levels}, {"part", mesh.part}, {"strain", mesh.strain}};
  if (!run.problem.empty()) json["problem"] = run.problem;
  return json;
}

}  // namespace

std::string run_text(const AccuracyQuestion& question, const AccuracyRun& run, std::size_t number) {
  std::string text = fmt::format("Run {}: local error {:.2g} L0", number, run.settings.tolerance);
  if (run.settings.gap_ratio > 0) text += fmt::format(", gap ratio {:.4g}", run.settings.gap_ratio);
  if (run.settings.mesh.levels > 0)
    text += fmt::format(", {} levels, part {:.3g}", run.settings.mesh.levels, run.settings.mesh.part);
  text += fmt::format(": {} steps, {:.2g} s", run.steps, run.seconds);
  if (!run.problem.empty()) text += ": " + run.problem;
  for (std::size_t q = 0; q < run.values.size(); ++q)
    text += fmt::format("{} {} = {:.7g}", q == 0 ? ":" : ",", question.quantities[q].text(), run.values[q]);
  return text + "\n";
}

std::string accuracy_text(const AccuracyQuestion& question, const AccuracyResult& result) {
  if (result.status == AccuracyStatus::Interrupted) return "";
  std::string text;
  const Scope scope = scope_of(result);
  const bool with_mesh = result.mesh_is_judged;
  if (result.status == AccuracyStatus::Kept)
    text = fmt::format("The accuracy {} is kept by the time steps{}; the {} were not examined:\n",
                       percent(question.accuracy), with_mesh ? " and the mesh at the front" : "",
                       fmt::join(scope.not_covered, ", "));
  else if (result.achieved.empty())
    return fmt::format("The accuracy {} cannot be judged: {}.\n", percent(question.accuracy), result.limit);
  else
    text = fmt::format("The accuracy {} is not reached, limited by: {}.\n", percent(question.accuracy), result.limit);
  if (!result.runs.back().problem.empty() && result.runs.back().outcome == AccuracyOutcome::Good)
    text += fmt::format("  The last run failed after the times that decide the quantities: {}.\n",
                        result.runs.back().problem);
  double seconds = 0;
  for (const AccuracyRun& run : result.runs) seconds += run.seconds;
  for (std::size_t q = 0; q < result.achieved.size(); ++q) {
    const AchievedAccuracy& own = result.achieved[q];
    text += fmt::format("  {} = {:.7g}, estimated error {} ({}{})\n", question.quantities[q].text(), own.value,
                        percent(own.error), own.reason,
                        with_mesh ? fmt::format("; of it {} by the mesh", percent(own.mesh_error)) : "");
  }
  return text + fmt::format(
                    "  The estimate covers {}; for the {}, use ixos-study --advise.\n"
                    "  {} runs took {:.2g} s, the last one {:.2g} s.\n",
                    scope.covered, scope.not_covered.front(), result.runs.size(), seconds, result.runs.back().seconds);
}

void add_accuracy(const AccuracyQuestion& question, const AccuracyResult& result, const std::string& folder) {
  Json json;
  json["asked"] = question.accuracy;
  json["kept"] = result.status == AccuracyStatus::Kept;
  json["limit"] = result.limit;
  const Scope scope = scope_of(result);
  json["covers"] = scope.covered;
  json["not_examined"] = scope.not_covered;
  json["quantities"] = Json::array();
  for (std::size_t q = 0; q < result.achieved.size(); ++q) {
    const AchievedAccuracy& own = result.achieved[q];
    json["quantities"].push_back({{"quantity", question.quantities[q].text()},
                                  {"value", own.value},
                                  {"error", own.error},  // an unknown one, which is infinite, is written as null
                                  {"error_by_mesh", result.mesh_is_judged ? Json(own.mesh_error) : Json()},
                                  {"kept", own.error <= question.accuracy},
                                  {"known_by", own.reason}});
  }
  json["settings"] = assignments(result.runs.back().settings);
  json["runs"] = Json::array();
  for (const AccuracyRun& run : result.runs) json["runs"].push_back(to_json(run));
  Json summary = read_summary(folder);
  summary["accuracy"] = json;
  write_whole_file(folder + "/summary.json", summary.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

bool holds_accuracy(const std::string& folder, const Teuchos::ParameterList& scene) {
  try {
    if (!std::filesystem::exists(folder + "/summary.json") || !read_summary(folder).contains("accuracy")) return false;
    Teuchos::ParameterList found = read_scene_file(folder + "/effective.xml"), now = scene;
    const auto follows = [](const Teuchos::ParameterList& list) {
      return list.isSublist("Mesh") && list.sublist("Mesh").isSublist("Adapt") &&
             list.sublist("Mesh").sublist("Adapt").isType<int>("Levels") &&
             list.sublist("Mesh").sublist("Adapt").get<int>("Levels") > 0;
    };
    const bool both_follow = follows(found) && follows(now);
    for (Teuchos::ParameterList* list : {&found, &now}) {
      Teuchos::ParameterList& control = list->sublist("Time Integrator").sublist("Time Step Control");
      control.set<std::string>("Type", "Fixed");
      control.remove("Adaptive", false);
      if (both_follow)
        for (const char* name : {"Levels", "Part", "Strain"})
          list->sublist("Mesh").sublist("Adapt").remove(name, false);
    }
    return changes_of_problem(found, now).empty();
  } catch (const InputError&) {
    return false;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace ixos
