#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <filesystem>
#include <set>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"
#include "parameters/scene_node.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "study/compare/study.hpp"
#include "study/compare/study_errors.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Words = Teuchos::Array<std::string>;

Assignments assignments(const SceneNode& node) {
  Assignments result;
  for (const auto& [name, entry] : entries(node.list())) {
    if (entry.isList())
      throw InputError(node.path_of(name) +
                       " is a list; only parameters are allowed here, each named by its path in the scene");
    result.push_back(fmt::format("{}={}", name, value_text(entry)));
  }
  return result;
}

Axis read_axis(const SceneNode& node) {
  Axis axis{node.name(), {}};
  const std::string& parameter = node.text("Parameter");
  const Words& values = node.get<Words>("Values");
  const std::vector<SceneNode> settings = node.sublist("Settings").sublists();
  if (parameter.empty() != values.empty() || parameter.empty() == settings.empty())
    throw InputError(node.path() + ": give either Parameter and Values, or Settings with a list for each value");
  for (const std::string& value : values) axis.values.push_back({value, {fmt::format("{}={}", parameter, value)}});
  for (const SceneNode& setting : settings) axis.values.push_back({setting.name(), assignments(setting)});
  std::set<std::string> labels;
  for (const AxisValue& value : axis.values)
    if (!labels.insert(value.label).second) throw InputError(node.path() + ": \"" + value.label + "\" is given twice");
  return axis;
}

Question read_question(const SceneNode& list, const std::vector<Axis>& axes) {
  Question question{list.text("Connect"), list.text("Cost"), list.text("Measure"), list.number("Tolerance"),
                    list.number("Budget")};
  if (question.tolerance == 0 && question.budget == 0)
    throw InputError("Question: Tolerance and Budget are both 0; at least one must be greater than 0");
  if (question.connect.empty()) question.connect = axes.back().name;
  std::vector<std::string> names;
  names.reserve(axes.size());
  for (const Axis& axis : axes) names.push_back(axis.name);
  if (std::find(names.begin(), names.end(), question.connect) == names.end())
    throw InputError("Question/Connect: " + no_such("axis", question.connect, names, "There are"));
  return question;
}

ErrorOptions read_errors(const SceneNode& list) {
  ErrorOptions options;
  const Words &force = list.get<Words>("Force"), &position = list.get<Words>("Position");
  options.force.assign(force.begin(), force.end());
  options.position.assign(position.begin(), position.end());
  options.energy_scale = list.number("Energy Scale");
  const auto interval = list.numbers("Interval", 2, {});
  if (interval.empty()) return options;
  if (!(interval[0] < interval[1]))
    throw InputError(
        fmt::format("Errors/Interval: the start {} must be less than the end {}", interval[0], interval[1]));
  options.from = interval[0];
  options.to = interval[1];
  return options;
}

/// Returns the names of study.csv's columns, but for the axes.
std::set<std::string> columns() {
  std::set<std::string> names{"run",
                              "status",
                              "reason",
                              "wall_seconds",
                              "cpu_seconds",
                              "steps",
                              "rejected_steps",
                              "newton_iterations",
                              "linear_iterations",
                              "end_time",
                              "peak_memory_bytes",
                              "peak",
                              "work"};
  for (const Measure& measure : measures()) names.insert(measure.column);
  return names;
}

std::string beside(const std::string& study, const std::string& path) {
  const std::filesystem::path given(path);
  return given.is_absolute() ? path : (std::filesystem::path(study).parent_path() / given).string();
}

/// Returns the check of the reference without the step that only the scene tells.
ReferenceCheck read_check(const SceneNode& reference) {
  const Assignments settings = assignments(reference.sublist("Check Settings"));
  const bool computed = reference.text("Folder").empty();
  if (!settings.empty() && !(computed && reference.get<bool>("Check")))
    throw InputError("Reference: Check Settings need Settings, not Folder, and Check true");
  if (!computed) return {{}, "Reference/Folder is given"};
  if (!reference.get<bool>("Check")) return {{}, "Reference/Check is false"};
  if (settings.empty()) return {};
  return {settings, fmt::format("a run with {}", fmt::join(settings, "; "))};
}

Study read(const std::string& path) {
  const List complete = validated(read_scene_file(path), study_parameters());
  const SceneNode list(complete, "");
  Study study;
  study.name = complete.name().empty() || complete.name() == "ANONYMOUS" ? "Study" : complete.name();
  study.scene = beside(path, list.text("Scene"));
  study.jobs = list.count("Jobs");
  study.time_limit = list.number("Time Limit");
  study.common = assignments(list.sublist("Common"));
  const std::set<std::string> taken = columns();
  for (const SceneNode& axis : list.sublist("Axes").sublists()) {
    if (taken.count(axis.name()) > 0)
      throw InputError(axis.path() + ": this is the name of a column of study.csv; choose another name");
    study.axes.push_back(read_axis(axis));
  }
  if (study.axes.empty()) throw InputError("Axes is empty; a study needs at least one axis");
  const SceneNode reference = list.sublist("Reference");
  study.reference = assignments(reference.sublist("Settings"));
  study.reference_folder = reference.text("Folder");
  if (study.reference.empty() == study.reference_folder.empty())
    throw InputError("Reference: give either Folder or Settings");
  if (!study.reference_folder.empty()) {
    study.reference_folder = beside(path, study.reference_folder);
    if (!std::filesystem::exists(study.reference_folder + "/history.csv"))
      throw InputError("Reference/Folder: " + study.reference_folder + " has no history.csv");
  }
  study.check = read_check(reference);
  study.errors = read_errors(list.sublist("Errors"));
  study.question = read_question(list.sublist("Question"), study.axes);
  study.runs = combinations(study.axes, study.common, {"reference", "reference-check"});
  return study;
}

/// Returns a check with twice the time step of the reference, whose complete scene is given.
ReferenceCheck twice_the_step(const List& reference) {
  const List& control = reference.sublist("Time Integrator").sublist("Time Step Control");
  if (control.get<std::string>("Type") != "Fixed")
    return {{}, "its time steps are not fixed; to judge it, give coarser settings in Reference/Check Settings"};
  return {{fmt::format("Time Integrator/Time Step Control/Time Step={}", 2 * control.get<double>("Time Step"))},
          "a run with twice its time step"};
}

}  // namespace

std::string scene_text(const Study& study, const Assignments& settings) {
  return changed_scene_text(study.scene, settings);
}

Study read_study(const std::string& path) {
  Study study;
  List scene;
  try {
    study = read(path);
    scene = read_scene_file(study.scene);
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(what.rfind(path, 0) == 0 ? what : path + ": " + what);
  }
  const auto check = [&](const std::string& run, const Assignments& settings) {
    try {
      return complete_scene(with_settings(scene, settings));
    } catch (const InputError& error) {
      throw InputError(path + ": run " + run + ": " + error.what());
    }
  };
  if (study.reference_folder.empty()) {
    Assignments all = study.common;
    all.insert(all.end(), study.reference.begin(), study.reference.end());
    const List reference = check("reference", all);
    if (study.check.description.empty()) study.check = twice_the_step(reference);
    all.insert(all.end(), study.check.settings.begin(), study.check.settings.end());
    if (!study.check.settings.empty()) check("reference-check", all);
  }
  for (const StudyRun& run : study.runs) check(run.name, run.settings);
  return study;
}

}  // namespace ixos
