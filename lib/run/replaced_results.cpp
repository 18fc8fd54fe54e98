#include "run/replaced_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <string_view>
#include <vector>

#include "base/agreement.hpp"
#include "io/disk_file.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Returns the text between `start` and `end`; empty if the name has no such start or end.
std::string_view between(std::string_view name, std::string_view start, std::string_view end) {
  if (name.size() < start.size() + end.size() || name.substr(0, start.size()) != start ||
      name.substr(name.size() - end.size()) != end)
    return {};
  return name.substr(start.size(), name.size() - start.size() - end.size());
}

bool is_result(const std::string& name) {
  for (const char* fixed : {"history.csv", "summary.json", "checkpoint.h5"})
    if (name == fixed) return true;
  const NumberedResult numbered = numbered_result(name);
  return numbered.frames > 0 || numbered.scene > 0 || is_number(between(name, "checkpoint-", ".h5"));
}

/// Returns the names in a folder that a run writes or removes, sorted.
std::vector<std::string> names_of_results(const std::string& folder) {
  std::vector<std::string> names;
  for (const std::string& name : names_in(folder))
    if (is_result(name)) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns in what the scene of the results differs from the present one; empty if it does not.
std::string difference(const Simulation& simulation, const std::string& folder) {
  // effective.xml has the scene of the first stage.
  const Teuchos::ParameterList first =
      simulation.stage() == 0 ? simulation.parameters() : complete_scene(simulation.stages().scene({}));
  const std::vector<SceneChange> changes = changes_of_problem(read_scene_file(folder + "/effective.xml"), first);
  if (changes.size() > 1) return fmt::format("{}; and {} more", changes.front().text(), changes.size() - 1);
  if (!changes.empty()) return changes.front().text();
  std::ifstream file = open_text(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  const auto differs = [&summary](const char* key, auto now) {
    return summary.is_object() && summary.contains(key) && summary[key] != now;
  };
  const Model& model = simulation.model();
  const bool follows = simulation.adaptation().on();  // the numbers are those of the last mesh
  if (differs("mesh_fingerprint", simulation.fingerprint_of_results()) ||
      (!follows && (differs("elements", model.mesh().global_cells) || differs("dofs", model.space().global()))))
    return "the mesh has changed";
  return "";
}

ReplacedResults look(const Simulation& simulation, const std::string& folder, bool overwrite) {
  const std::vector<std::string> names = names_of_results(folder);
  if (names.empty()) return {};
  std::string found;
  try {
    if (!is_file(folder + "/effective.xml"))
      found = fmt::format("{}, but no effective.xml that tells their scene", fmt::join(names, ", "));
    else if (const std::string change = difference(simulation, folder); !change.empty())
      found = fmt::format("results of another scene ({})", change);
  } catch (const InputError& error) {
    found = fmt::format("{}, and the scene of effective.xml cannot be read ({})", fmt::join(names, ", "), error.what());
  }
  if (found.empty()) return {folder + ": this run replaces the results of the same scene.", false};
  if (overwrite) return {fmt::format("{}: this run replaces {}.", folder, found), true};
  throw InputError(
      fmt::format("{}: the folder holds {}; choose another --output, or replace them with --overwrite", folder, found));
}

}  // namespace

NumberedResult numbered_result(const std::string& name) {
  static const std::regex scene(R"(effective(?:-(\d{1,8}))?\.xml)"),
      frames(R"(fields(?:-(\d{1,8})\.e|\.e-s\.(\d{1,8})|\.e)(?:\.\d+\.\d+)?)");
  std::smatch found;
  const auto number = [&found] {
    for (std::size_t group = 1; group < found.size(); ++group)
      if (found[group].matched) return std::stol(found[group]);
    return 1L;
  };
  if (std::regex_match(name, found, scene)) return {0, number()};
  if (std::regex_match(name, found, frames)) return {number(), 0};
  return {};
}

ReplacedResults replaced_results(const Simulation& simulation, const std::string& folder, bool overwrite) {
  const Comm& comm = simulation.model().space().comm();
  ReplacedResults found;
  on_first_rank(comm, [&] { found = look(simulation, folder, overwrite); });
  found.note = from_first_rank(comm, found.note);
  found.of_another = !from_first_rank(comm, found.of_another ? "yes" : "").empty();
  return found;
}

}  // namespace ixos
