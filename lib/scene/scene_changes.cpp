#include "scene/scene_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/digest.hpp"
#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

const char* const absent = "absent";

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

Bearing bearing(const std::string& path) {
  const std::string control = "Time Integrator/Time Step Control/";
  if (starts_with(path, "Initial Conditions/") || path == control + "Initial Time") return Bearing::State;
  if (starts_with(path, "Mesh/Adapt/")) return Bearing::Solution;
  // The fingerprint tells whether the mesh is another one.
  for (const char* list : {"Units/", "Mesh/", "Stages/", "Time Integrator/Stop/"})
    if (starts_with(path, list)) return Bearing::None;
  // It tells of an obstacle's file, too, whatever its name.
  if (starts_with(path, "Interactions/") && ends_with(path, "/File")) return Bearing::None;
  if (path == control + "Final Time") return Bearing::None;
  // Steps end at time intervals of output.
  if (starts_with(path, "Output/")) return ends_with(path, " Time Interval") ? Bearing::Solution : Bearing::None;
  if (starts_with(path, "Linear Solver/") || starts_with(path, "Nonlinear Solver/")) return Bearing::Solution;
  if (path == control + "Maximum Cuts" || path == control + "Minimum Time Step") return Bearing::Solution;
  return Bearing::Motion;
}

/// Returns whether another value of the parameter makes another problem. A restart recognises its mesh by other means,
/// and its state by numbers without units.
bool defines_problem(const std::string& path) {
  const Bearing effect = bearing(path);
  return effect == Bearing::Motion || effect == Bearing::State || starts_with(path, "Mesh/") ||
         starts_with(path, "Units/") || starts_with(path, "Stages/");
}

std::string text(const Teuchos::ParameterEntry* entry) {
  if (entry == nullptr) return absent;
  return entry->isType<std::string>() ? '"' + short_text(*entry) + '"' : short_text(*entry);
}

/// Returns the text of a value, of a file its name alone: a scene may move with its files, and the fingerprint tells
/// what they hold.
std::string compared_text(const std::string& path, const Teuchos::ParameterEntry* entry) {
  if (entry == nullptr || !ends_with(path, "/File") || !entry->isType<std::string>()) return text(entry);
  return std::filesystem::path(short_text(*entry)).filename().string();
}

/// The differences of the lists at `path`; either may be missing.
void compare(const Teuchos::ParameterList* before, const Teuchos::ParameterList* now, const std::string& path,
             std::vector<SceneChange>& changes) {
  std::vector<std::string> names;
  for (const Teuchos::ParameterList* list : {now, before})
    if (list != nullptr)
      for (const auto& [name, entry] : entries(*list))
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  for (const std::string& name : names) {
    const auto entry = [&name](const Teuchos::ParameterList* list) {
      return list == nullptr ? nullptr : list->getEntryPtr(name);
    };
    const auto sublist = [&](const Teuchos::ParameterList* list) {
      return entry(list) != nullptr && list->isSublist(name) ? &list->sublist(name) : nullptr;
    };
    std::string here = path;
    if (!path.empty()) here += '/';
    here += name;
    if (sublist(before) != nullptr || sublist(now) != nullptr) {
      compare(sublist(before), sublist(now), here, changes);
      continue;
    }
    if (compared_text(here, entry(before)) != compared_text(here, entry(now)))
      changes.push_back({here, text(entry(before)), text(entry(now)), bearing(here)});
  }
}

/// Adds a line for each parameter of the list at `path` that defines the problem.
void describe(const Teuchos::ParameterList& list, const std::string& path, std::string& lines) {
  for (const auto& [name, entry] : entries(list)) {
    std::string here = path;
    if (!path.empty()) here += '/';
    here += name;
    if (entry.isList()) {
      describe(list.sublist(name), here, lines);
      continue;
    }
    if (defines_problem(here)) lines += here + " = " + compared_text(here, &entry) + '\n';
  }
}

}  // namespace

Teuchos::ParameterList with_defaults(const Teuchos::ParameterList& scene) {
  try {
    return complete_scene(scene);
  } catch (const InputError&) {
    return scene;
  }
}

std::string scene_digest(const Teuchos::ParameterList& scene, const std::string& mesh_fingerprint) {
  std::string lines = "mesh " + mesh_fingerprint + '\n';
  describe(scene, "", lines);
  const Checksum sum = checksum(lines.data(), lines.size());
  return fmt::format("{:016x}{:016x}", sum[0], sum[1]);
}

std::string SceneChange::text() const { return path + ": " + before + ", now " + now; }

std::vector<SceneChange> scene_changes(const Teuchos::ParameterList& before, const Teuchos::ParameterList& now) {
  std::vector<SceneChange> changes;
  compare(&before, &now, "", changes);
  return changes;
}

std::vector<SceneChange> changes_of_problem(const Teuchos::ParameterList& before, const Teuchos::ParameterList& now) {
  // As it would be read back, so that both are spelt alike.
  std::vector<SceneChange> changes =
      scene_changes(with_defaults(before), read_scene_text(scene_text(now), "the scene"));
  const auto same = [](const SceneChange& change) { return !defines_problem(change.path); };
  changes.erase(std::remove_if(changes.begin(), changes.end(), same), changes.end());
  return changes;
}

}  // namespace ixos
