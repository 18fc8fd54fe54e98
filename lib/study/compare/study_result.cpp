#include "study/compare/study_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/disk_file.hpp"
#include "study/common/csv_cell.hpp"
#include "study/compare/recommendation.hpp"

namespace ixos {
namespace {

constexpr std::size_t first_measures = 4;  ///< that stand before the costs

std::string table(const Study& study, const std::vector<StudyResult>& results) {
  std::string text = "run";
  for (const Axis& axis : study.axes) text += "," + csv_cell(axis.name);
  // The first columns keep their places: readers may count them.
  text += ",status,reason";
  for (std::size_t i = 0; i < first_measures; ++i) text += std::string(",") + measures()[i].column;
  text +=
      ",wall_seconds,cpu_seconds,steps,rejected_steps,newton_iterations,linear_iterations,peak_memory_bytes,end_time";
  for (std::size_t i = first_measures; i < measures().size(); ++i) text += std::string(",") + measures()[i].column;
  text += ",peak,work\n";
  for (const StudyResult& result : results) {
    const StudyErrors errors = result.reached_its_end() ? result.errors : StudyErrors();
    text += csv_cell(result.run.name);
    for (const std::string& label : result.run.labels) text += "," + csv_cell(label);
    text += "," + result.status + "," + csv_cell(result.reason);
    for (std::size_t i = 0; i < first_measures; ++i) text += "," + csv_number(errors.*measures()[i].error);
    for (double value : {result.wall_seconds, result.cpu_seconds}) text += "," + csv_number(value);
    for (long value : {result.steps, result.rejected_steps, result.newton_iterations, result.linear_iterations})
      text += fmt::format(",{}", value);
    text += "," + csv_number(result.peak_memory_bytes) + "," + csv_number(result.end_time);
    for (std::size_t i = first_measures; i < measures().size(); ++i)
      text += "," + csv_number(errors.*measures()[i].error);
    text += "," + csv_number(errors.peak_force) + "," + csv_number(errors.external_work) + "\n";
  }
  return text;
}

/// Returns the reference as study.json holds it.
nlohmann::ordered_json described(const Study& study, const ReferenceQuality& quality) {
  const bool computed = study.reference_folder.empty();
  nlohmann::ordered_json json = {
      {"description", computed ? fmt::format("{}", fmt::join(study.reference, "; ")) : std::string("given")},
      {"folder", computed ? std::string("runs/reference") : study.reference_folder}};
  json["judgement"] = quality.origin.empty() ? fmt::format("Its own errors are unknown: {}.", quality.unknown)
                                             : fmt::format("Its own errors are taken from {}.", quality.origin);
  json["own_errors"] = nlohmann::ordered_json::object();
  for (const Measure& measure : measures())
    if (std::isfinite(quality.own.*measure.error)) json["own_errors"][measure.column] = quality.own.*measure.error;
  json["notes"] = nlohmann::ordered_json::array();
  for (const auto& [column, note] : quality.notes) json["notes"].push_back(note);
  return json;
}

}  // namespace

double StudyResult::error(const std::string& column) const { return errors.*measure(column).error; }

double StudyResult::cost(const std::string& name) const {
  if (name == "wall_seconds") return wall_seconds;
  if (name == "cpu_seconds") return cpu_seconds;
  if (name == "newton_iterations") return static_cast<double>(newton_iterations);
  throw std::invalid_argument("no such cost: " + name);
}

void write_study(const Study& study, const std::vector<StudyResult>& results, const ReferenceQuality& reference,
                 const std::string& folder, const std::string& command, const std::string& version) {
  nlohmann::ordered_json json;
  json["name"] = study.name;
  json["scene"] = study.scene;
  json["command"] = command;
  json["version"] = version;
  json["axes"] = nlohmann::ordered_json::array();
  for (const Axis& axis : study.axes) {
    nlohmann::ordered_json labels = nlohmann::ordered_json::array();
    for (const AxisValue& value : axis.values) labels.push_back(value.label);
    json["axes"].push_back({{"name", axis.name}, {"values", labels}});
  }
  json["connect"] = study.question.connect;
  json["cost"] = study.question.cost;
  json["measure"] = study.question.measure;
  json["tolerance"] = nullptr;
  if (study.question.tolerance > 0) json["tolerance"] = study.question.tolerance;
  json["reference"] = described(study, reference);
  json["pareto"] = nlohmann::ordered_json::object();
  for (const Measure& measure : measures()) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const StudyResult* result : pareto(results, study.question.cost, measure.column))
      names.push_back(result->run.name);
    json["pareto"][measure.column] = names;
  }
  const Recommendation answer = recommend(study, results, reference);
  json["recommendation"] = {{"run", nullptr}, {"settings", Assignments()}, {"sentence", answer.sentence}};
  if (answer.run != nullptr) {
    json["recommendation"]["run"] = answer.run->run.name;
    json["recommendation"]["settings"] = answer.run->run.settings;
  }
  json["common"] = study.common;
  write_whole_file(folder + "/study.csv", table(study, results));
  write_whole_file(folder + "/study.json", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace ixos
