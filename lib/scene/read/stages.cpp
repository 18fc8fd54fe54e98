#include "scene/read/stages.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/scene_node.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Strings = Teuchos::Array<std::string>;

const char* const list_name = "Stages";
const char* const clock_name = "Clock";
const char* const without_name = "Without";

/// The lists that are those of all stages.
bool is_common(const std::string& name) { return name == "Units" || name == "Mesh" || name == list_name; }

/// Puts the parameters of one list into another. A parameter that belongs to another word of a choice goes.
void change(List& list, const List& by, const List* valid) {
  for (const auto& [name, entry] : entries(by)) {
    if (!entry.isList()) {
      list.setEntry(name, entry);
      const bool chooses = valid != nullptr && valid->isParameter(name) && entry.isType<std::string>();
      if (chooses) discard_left_out(list, *valid, name);
      continue;
    }
    if (list.isParameter(name) && !list.isSublist(name)) list.remove(name);
    const List* below = valid == nullptr ? nullptr : valid_sublist(*valid, name, name);
    change(list.sublist(name), by.sublist(name), below);
  }
}

/// Removes the list or parameter at "Boundary Conditions/Foot". Throws InputError if there is none.
void remove(List& scene, const std::string& path) {
  if (const std::string first = path.substr(0, path.find('/')); is_common(first))
    throw InputError(fmt::format("{}: {} is the same in all stages", without_name, first));
  List* list = &scene;
  std::size_t start = 0;
  for (auto slash = path.find('/'); slash != std::string::npos && list != nullptr; slash = path.find('/', start)) {
    const std::string name = path.substr(start, slash - start);
    list = list->isSublist(name) ? &list->sublist(name) : nullptr;
    start = slash + 1;
  }
  const std::string name = path.substr(start);
  if (list != nullptr && list->remove(name, false)) return;
  std::string message = fmt::format("{}: the stage before has no \"{}\"", without_name, path);
  std::vector<std::string> names;
  if (list != nullptr)
    for (const auto& [other, entry] : entries(*list)) names.push_back(path.substr(0, start) + other);
  if (!names.empty()) message += fmt::format("; did you mean \"{}\"?", closest_name(path, names));
  throw InputError(message);
}

/// Returns the list "Time Step Control" of a scene, which it makes if there is none.
List& control(List& scene) { return scene.sublist("Time Integrator").sublist("Time Step Control"); }

/// Returns a number of a list in the units of the scene, which the validation has not seen.
double number(const List& list, const std::string& name, double otherwise) {
  if (list.isType<int>(name)) return list.get<int>(name);
  return list.isType<double>(name) ? list.get<double>(name) : otherwise;
}

/// Returns the validated list "Histories" of a scene in its units.
List complete_histories(const List& scene) {
  const List given = scene.isSublist("Histories") ? scene.sublist("Histories") : List();
  List outer, valid;
  outer.sublist("Histories") = given;
  valid.sublist("Histories") = scene_parameters().sublist("Histories");
  return validated(outer, valid).sublist("Histories");
}

/// A stage's own parameters, beside the lists that change the scene.
struct OwnParameters {
  bool counts_from_begin = true;
  std::vector<std::string> without;
};

OwnParameters own_parameters(const List& stage) {
  List user(stage), valid;
  for (const auto& [name, entry] : entries(stage))
    if (entry.isList()) user.remove(name);
  valid.setParameters(scene_parameters().sublist(list_name).sublist(any_name));  // without its mark
  const List own = validated(user, valid);
  return {own.get<std::string>(clock_name) == "Stage", own.get<Strings>(without_name).toVector()};
}

}  // namespace

void declare_stages(List& scene) {
  List& stages = scene.sublist(list_name, false,
                               "Runs that follow each other, in this order, in one history.csv: each begins with the "
                               "state in which the one before ended. If empty, the scene is one run.");
  List& stage = stages.sublist(
      any_name, false,
      "A stage. Its lists are those of a scene, except Units, Mesh and Stages; they change the scene of the stage "
      "before, the first stage's change the scene itself. A history that a stage gives replaces the one of that name. "
      "Initial Conditions and the criteria of Time Integrator/Stop hold for the stage that gives them: velocities are "
      "added to those that the bodies have, and a criterion ends the stage.");
  stage.set(
      clock_name, "Stage",
      "Beginning from which the times in the lists of a stage count. Stage: its own; Final Time is then its length, "
      "by default that of the stage before, and a history that it gives adds to the value that the history of that "
      "name had there. Run: that of the run, as elsewhere.",
      one_of({"Stage", "Run"}));
  stage.set(without_name, Strings(),
            "Paths of lists and parameters of the stage before that are left out, such as \"Boundary "
            "Conditions/Foot\".");
  mark_like_root(stage);
}

Stages::Stages(const List& scene, const GivenHistories& given) : scene_(scene), given_(given) {
  if (!scene_.isSublist(list_name)) return;
  for (const auto& [name, entry] : entries(scene_.sublist(list_name))) {
    if (!entry.isList()) throw InputError(fmt::format("{}/{} is a parameter, but a stage is a list", list_name, name));
    check(name);
    names_.push_back(name);
  }
}

void Stages::check(const std::string& name) const {
  const List& stage = scene_.sublist(list_name).sublist(name);
  at(fmt::format("{}/{}", list_name, name), [&] {
    std::vector<std::string> allowed;
    for (const auto& [list, entry] : entries(scene_parameters()))
      if (!is_common(list)) allowed.push_back(list);
    own_parameters(stage);
    for (const auto& [list, entry] : entries(stage))
      if (entry.isList() && std::find(allowed.begin(), allowed.end(), list) == allowed.end())
        throw InputError(is_common(list) ? fmt::format("{} is the same in all stages: give it in the scene", list)
                                         : no_such("list", list, allowed, "Allowed:"));
  });
}

const List& Stages::own(std::size_t stage) const { return scene_.sublist(list_name).sublist(names_[stage]); }

std::string Stages::path(std::size_t stage) const {
  return names_.empty() ? "" : fmt::format("{}/{}", list_name, names_[stage]);
}

bool Stages::gives_velocities(std::size_t stage) const { return own(stage).isSublist("Initial Conditions"); }

List Stages::scene(const std::vector<double>& begins) const {
  if (names_.empty()) return scene_;
  List scene = in_scene_units(scene_, scene_parameters());
  for (std::size_t stage = 0; stage <= begins.size(); ++stage)
    at(path(stage), [&] {
      const OwnParameters parameters = own_parameters(own(stage));
      const bool is_first = stage == 0;
      List histories;  // of the stage before, complete
      double length = 0;
      if (is_first) {
        if (!parameters.without.empty()) throw InputError("Without: the first stage has none before it");
      } else {
        histories = complete_histories(scene);
        length = number(control(scene), "Final Time", 0) - number(control(scene), "Initial Time", 0);
        scene.remove("Initial Conditions", false);
        scene.sublist("Time Integrator").remove("Stop", false);
        for (const std::string& left_out : parameters.without) remove(scene, left_out);
      }
      List changes(own(stage));
      changes.remove(clock_name, false);
      changes.remove(without_name, false);
      if (!is_first && changes.isSublist("Time Integrator") && control(changes).isParameter("Initial Time"))
        throw InputError(
            "Time Integrator/Time Step Control/Initial Time: a stage begins where the one before ends; remove it");
      if (changes.isSublist("Histories"))
        for (const auto& [name, entry] : entries(changes.sublist("Histories")))
          if (scene.isSublist("Histories")) scene.sublist("Histories").remove(name, false);
      change(scene, changes, &scene_parameters());
      scene = in_scene_units(scene, scene_parameters());
      if (is_first) return;
      scene.remove(list_name, false);
      const double begin = begins[stage - 1];
      List& times = control(scene);
      times.set("Initial Time", begin);
      if (!parameters.counts_from_begin) return;
      const bool gives_end = changes.isSublist("Time Integrator") && control(changes).isParameter("Final Time");
      if (gives_end) length = number(times, "Final Time", 0);
      times.set("Final Time", begin + length);
      if (!changes.isSublist("Histories")) return;
      const SceneNode earlier(histories, "Histories");
      for (const auto& [name, entry] : entries(changes.sublist("Histories"))) {
        if (!entry.isList()) continue;
        shift_history(scene.sublist("Histories").sublist(name), begin, history_at(earlier, given_, name, begin));
      }
    });
  return scene;
}

std::vector<double> Stages::planned_ends(std::vector<double> begins) const {
  while (begins.size() < count()) {
    List own = in_scene_units(scene(begins), scene_parameters());
    // Without one, the validation has a message.
    at(path(begins.size()), [&] {
      if (!control(own).isParameter("Final Time")) complete_scene(own);
    });
    begins.push_back(number(control(own), "Final Time", 0));
  }
  return begins;
}

}  // namespace ixos
