#include "study/study_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/disk_file.hpp"

namespace ixos {
namespace {

constexpr const char* measures[] = {"error_energy", "error_momentum", "error_force", "error_position"};

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string text = "\"";
  for (char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

std::string table(const Study& study, const std::vector<StudyResult>& results) {
  std::string text = "run";
  for (const Axis& axis : study.axes) text += "," + quoted(axis.name);
  text +=
      ",status,reason,error_energy,error_momentum,error_force,error_position,wall_seconds,cpu_seconds,steps,"
      "rejected_steps,newton_iterations,linear_iterations,peak_memory_bytes,end_time\n";
  for (const StudyResult& result : results) {
    text += quoted(result.run.name);
    for (const std::string& label : result.run.labels) text += "," + quoted(label);
    text += "," + result.status + "," + quoted(result.reason);
    for (const char* measure : measures)
      text += "," + number(result.reached_its_end() ? result.error(measure) : std::nan(""));
    for (double value : {result.wall_seconds, result.cpu_seconds}) text += "," + number(value);
    for (long value : {result.steps, result.rejected_steps, result.newton_iterations, result.linear_iterations})
      text += fmt::format(",{}", value);
    text += "," + number(result.peak_memory_bytes) + "," + number(result.end_time) + "\n";
  }
  return text;
}

/// Returns a run's labels as "Scheme Newmark, Time Step 0.001".
std::string described(const Study& study, const StudyRun& run) {
  std::string text;
  for (std::size_t i = 0; i < study.axes.size(); ++i)
    text += (i > 0 ? ", " : "") + study.axes[i].name + " " + run.labels[i];
  return text;
}

/// Returns "error_force" as "error of the force".
std::string error_text(const std::string& measure) { return "error of the " + measure.substr(measure.find('_') + 1); }

std::string cost_text(const std::string& cost, double value) {
  if (cost == "newton_iterations") return fmt::format("{:.0f} Newton iterations", value);
  return fmt::format("{:.3g} s {}", value, cost == "cpu_seconds" ? "of processor time" : "of wall-clock time");
}

std::string sentence(const Study& study, const StudyResult& result) {
  const Question& asked = study.question;
  return fmt::format("{} has a relative {} of {:.3g} for {}", described(study, result.run), error_text(asked.measure),
                     result.error(asked.measure), cost_text(asked.cost, result.cost(asked.cost)));
}

}  // namespace

double StudyResult::error(const std::string& measure) const {
  if (measure == "error_energy") return errors.energy;
  if (measure == "error_momentum") return errors.momentum;
  if (measure == "error_force") return errors.force;
  if (measure == "error_position") return errors.position;
  throw std::invalid_argument("no such error: " + measure);
}

double StudyResult::cost(const std::string& name) const {
  if (name == "wall_seconds") return wall_seconds;
  if (name == "cpu_seconds") return cpu_seconds;
  if (name == "newton_iterations") return static_cast<double>(newton_iterations);
  throw std::invalid_argument("no such cost: " + name);
}

std::vector<const StudyResult*> pareto(const std::vector<StudyResult>& results, const std::string& cost,
                                       const std::string& measure) {
  std::vector<const StudyResult*> sound, best;
  for (const StudyResult& result : results)
    if (result.reached_its_end() && std::isfinite(result.error(measure))) sound.push_back(&result);
  std::sort(sound.begin(), sound.end(), [&](const StudyResult* a, const StudyResult* b) {
    return std::pair(a->cost(cost), a->error(measure)) < std::pair(b->cost(cost), b->error(measure));
  });
  for (const StudyResult* result : sound)
    if (best.empty() || result->error(measure) < best.back()->error(measure)) best.push_back(result);
  return best;
}

Recommendation recommend(const Study& study, const std::vector<StudyResult>& results) {
  const Question& asked = study.question;
  const auto best = pareto(results, asked.cost, asked.measure);  // cheaper first, more accurate last
  Recommendation answer;
  if (best.empty()) {
    answer.sentence = "No run that reached its end has a known " + error_text(asked.measure) + ".";
    return answer;
  }
  if (asked.tolerance > 0) {
    const auto within = std::find_if(best.begin(), best.end(), [&](const StudyResult* result) {
      return result->error(asked.measure) <= asked.tolerance;
    });
    if (within != best.end()) {
      answer.run = *within;
      answer.sentence =
          fmt::format("The cheapest run within the tolerance {:.3g}: {}.", asked.tolerance, sentence(study, **within));
    } else {
      answer.sentence = fmt::format("No run is within the tolerance {:.3g}. The most accurate run: {}.",
                                    asked.tolerance, sentence(study, *best.back()));
    }
  }
  if (asked.budget > 0) {
    const StudyResult* affordable = nullptr;
    for (const StudyResult* result : best)
      if (result->cost(asked.cost) <= asked.budget) affordable = result;
    const std::string budget = cost_text(asked.cost, asked.budget);
    answer.sentence += answer.sentence.empty() ? "" : " ";
    answer.sentence += affordable == nullptr ? "No run costs at most " + budget + "."
                                             : fmt::format("The most accurate run for at most {}: {}.", budget,
                                                           sentence(study, *affordable));
    if (asked.tolerance == 0) answer.run = affordable;
  }
  return answer;
}

void write_study(const Study& study, const std::vector<StudyResult>& results, const std::string& folder,
                 const std::string& command, const std::string& version) {
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
  const bool computed = study.reference_folder.empty();
  json["reference"] = {
      {"description", computed ? fmt::format("{}", fmt::join(study.reference, "; ")) : std::string("given")},
      {"folder", computed ? std::string("runs/reference") : study.reference_folder}};
  json["pareto"] = nlohmann::ordered_json::object();
  for (const char* measure : measures) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const StudyResult* result : pareto(results, study.question.cost, measure)) names.push_back(result->run.name);
    json["pareto"][measure] = names;
  }
  const Recommendation answer = recommend(study, results);
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
