#include "scene/read/conditions.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "model/conditions.hpp"
#include "scene/read/grips.hpp"
#include "scene/read/rigid_body_settings.hpp"

namespace ixos {
namespace {

/// A parameter that the condition's type needs, or refuses.
void require_given(const SceneNode& node, const char* name, bool wanted) {
  const bool array = node.list().isType<Teuchos::Array<double>>(name);
  const bool given = array ? !node.numbers(name).empty() : !node.text(name).empty();
  const std::string& type = node.text("Type");
  if (wanted && !given) throw InputError(fmt::format("{} is missing: a {} needs it", node.path_of(name), type));
  if (!wanted && given) node.refuse(name, fmt::format("a {} has no {}; remove it", type, name));
}

void add_displacement(const SceneNode& node, const Histories& histories, Model& model) {
  const std::string &set = node.text("Node Set"), &components = node.text("Components"), &name = node.text("History");
  at(node.path_of("Node Set"), [&] { return model.mesh().node_set(set); });
  std::shared_ptr<const TimeFunction> motion;
  if (!name.empty()) motion = at(node.path_of("History"), [&] { return histories.get(name, HistoryUse::Motion); });
  at(node.path_of("Components"), [&] { return components_of(components, model.mesh().dimension); });
  at(node.path(), [&] { prescribe(model, set, components, motion); });
}

void add_load(const SceneNode& node, const Histories& histories, Model& model) {
  const auto vector = node.numbers("Vector", static_cast<std::size_t>(model.mesh().dimension), {});
  const auto& name = node.text("History");
  const auto history =
      name.empty() ? constant(1.0) : at(node.path_of("History"), [&] { return histories.get(name, HistoryUse::Load); });
  const auto& type = node.text("Type");
  const char* where = type == "Traction" ? "Side Set" : type == "Point Force" ? "Node Set" : "Block";
  const auto add = type == "Traction"      ? add_traction
                   : type == "Point Force" ? add_point_force
                   : type == "Gravity"     ? add_gravity
                                           : add_body_force;
  at(node.path_of(where), [&] { add(model, node.text(where), vector, history); });
}

}  // namespace

void add_conditions(const SceneNode& conditions, const Histories& histories, Model& model) {
  for (const SceneNode& node : conditions.sublists()) {
    const std::string& type = node.text("Type");
    const bool displacement = type == "Displacement", symmetry = type == "Symmetry";
    require_given(node, "Node Set", displacement || symmetry || type == "Point Force");
    require_given(node, "Side Set", type == "Traction");
    require_given(node, "Vector", !displacement && !symmetry);
    if (symmetry) {
      require_given(node, "History", false);
      if (node.text("Components") != "all")
        throw InputError(
            node.path_of("Components") +
            ": a Symmetry holds its nodes along the normal of their plane; leave Components out, or use Displacement");
    }
    if (type != "Body Force" && type != "Gravity") require_given(node, "Block", false);
    if (displacement)
      add_displacement(node, histories, model);
    else if (symmetry)
      at(node.path_of("Node Set"), [&] { hold_in_plane(model, node.text("Node Set")); });
    else
      add_load(node, histories, model);
  }
}

// A function of the program that nothing uses is presumably a name that is spelt differently.
void refuse_unused_histories(const SceneNode& scene, const std::vector<SceneInteraction>& interactions,
                             const Histories& histories) {
  std::vector<std::string> used;
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists())
    if (const std::string& name = node.text("History"); !name.empty()) used.push_back(name);
  for (const SceneNode& node : scene.sublist("Grips").sublists())
    for (const std::string& name : read_grip(node).histories()) used.push_back(name);
  for (const SceneInteraction& interaction : interactions)
    for (const std::string& name : interaction.motion.histories()) used.push_back(name);
  for (const SceneNode& node : scene.sublist("Rigid Bodies").sublists())
    for (const std::string& name : read_rigid_body(node).all_histories()) used.push_back(name);
  for (const auto& [name, function] : histories.given()) {
    if (std::find(used.begin(), used.end(), name) != used.end()) continue;
    const std::string hint = used.empty() ? "" : fmt::format("; did you mean \"{}\"?", closest_name(name, used));
    throw InputError(fmt::format("the program gives the history \"{}\", which no condition names{}", name, hint));
  }
}

}  // namespace ixos
