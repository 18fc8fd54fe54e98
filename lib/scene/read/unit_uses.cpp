#include "scene/read/unit_uses.hpp"

#include <Teuchos_Array.hpp>

#include "parameters/parameter_entries.hpp"
#include "scene/read/scene_mesh.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// Returns a text of the list; that of the default list if there is none.
std::string text(const List& list, const std::string& name, const List& defaults) {
  return (list.isType<std::string>(name) ? list : defaults).get<std::string>(name);
}

/// Returns the texts of an array; none if the list has no such array.
std::vector<std::string> texts(const List& list, const std::string& name) {
  using Texts = Teuchos::Array<std::string>;
  return list.isType<Texts>(name) ? list.get<Texts>(name).toVector() : std::vector<std::string>();
}

/// Returns the sublist of that name; an empty list if there is none.
List sublist(const List& list, const std::string& name) { return list.isSublist(name) ? list.sublist(name) : List(); }

/// Returns the dimension of the mesh that a list chooses; 0 if it is not known. That of parts is the first one's.
int chosen_dimension(const List& mesh, const List& known) {
  const std::string type = text(mesh, meshes().choice(), known);
  for (const MeshEntry& entry : meshes().entries()) {
    if (entry.name != type) continue;
    if (entry.dimension != 0) return entry.dimension;
    const List own = sublist(mesh, type), valid = sublist(known, type);
    for (const List& list : {own, valid})
      if (list.isType<int>("Dimension")) return list.get<int>("Dimension");
    for (const auto& [name, part] : entries(own))
      if (part.isList() && valid.isSublist(any_name))
        return chosen_dimension(sublist(own, name), valid.sublist(any_name));
  }
  return 0;
}

/// Returns the dimension of the bodies of the mesh that the scene chooses; 0 if it is not known.
int mesh_dimension(const List& scene, const List& valid) {
  const List mesh = sublist(scene, "Mesh");
  return is_axisymmetric(mesh) ? 3 : chosen_dimension(mesh, valid.sublist("Mesh"));  // 3: units of the whole body
}

}  // namespace

UnitUses::UnitUses(const List& scene, const List& valid, int dimension)
    : condition_(valid.sublist("Boundary Conditions").sublist(any_name)),
      probe_(valid.sublist("Time Integrator").sublist("Stop").sublist(any_name).sublist("Probe")) {
  if (dimension == 0) dimension = mesh_dimension(scene, valid);
  if (dimension == 2 || dimension == 3) dimension_ = std::to_string(dimension) + "D";
  const List conditions = sublist(scene, "Boundary Conditions");
  for (const auto& [name, entry] : entries(conditions)) {
    const List condition = sublist(conditions, name);
    const bool motion = text(condition, "Type", condition_) == "Displacement";
    histories_[text(condition, "History", condition_)].insert(motion ? "motion" : "load");
  }
  const auto add_motion = [this](const List& motion) {
    if (motion.isType<std::string>("Rotation")) histories_[motion.get<std::string>("Rotation")].insert("angle");
    for (const std::string& history : texts(motion, "Translation")) histories_[history].insert("motion");
  };
  const List bodies = sublist(scene, "Rigid Bodies");
  for (const auto& [name, entry] : entries(bodies))
    for (const char* const history : {"Force History", "Moment History"})
      if (const List body = sublist(bodies, name); body.isType<std::string>(history))
        histories_[body.get<std::string>(history)].insert("load");
  for (const auto& [name, entry] : entries(bodies))
    for (const std::string& history : texts(sublist(bodies, name), "Base")) histories_[history].insert("motion");
  for (const auto& [name, entry] : entries(bodies)) add_motion(sublist(bodies, name));
  const List grips = sublist(scene, "Grips"), interactions = sublist(scene, "Interactions");
  for (const auto& [name, entry] : entries(grips)) add_motion(sublist(grips, name));
  for (const auto& [name, entry] : entries(interactions)) add_motion(sublist(sublist(interactions, name), "Motion"));
}

std::set<std::string> UnitUses::of(const std::vector<std::string>& path, const List& list) const {
  if (path.size() >= 2 && path[0] == "Histories") {
    const auto found = histories_.find(path[1]);
    return found == histories_.end() ? std::set<std::string>{"motion"} : found->second;
  }
  if (path.size() == 2 && path[0] == "Boundary Conditions") {
    const std::string type = text(list, "Type", condition_);
    return {type, type + " in " + dimension_};
  }
  if (path.size() == 2 && path[0] == "Rigid Bodies") return {"body in " + dimension_};
  if (path.size() == 2 && path[0] == "Grips") return {"grip in " + dimension_};
  if (path.size() == 4 && path[1] == "Stop" && path[3] == "Reaction") return {"set in " + dimension_};
  if (path.size() == 4 && path[1] == "Stop")
    return {text(list, "Quantity", probe_)[0] == 'v' ? "velocity" : "coordinate or displacement"};
  return {};
}

}  // namespace ixos
