#include "scene/unit_uses.hpp"

#include "parameters/parameter_entries.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// Returns a text of the list; `fallback` if there is none.
std::string text(const List& list, const std::string& name, const std::string& fallback) {
  return list.isType<std::string>(name) ? list.get<std::string>(name) : fallback;
}

/// Returns the sublist of that name; an empty list if there is none.
List sublist(const List& list, const std::string& name) { return list.isSublist(name) ? list.sublist(name) : List(); }

int mesh_dimension(const List& scene, const List& valid) {
  const List mesh = sublist(scene, "Mesh"), known = sublist(valid, "Mesh");
  const std::string type = text(mesh, "Type", text(known, "Type", ""));
  if (type == "Disk") return 2;
  if (type == "Spatula") return 3;
  for (const List& own : {sublist(mesh, type), sublist(known, type)})
    if (own.isType<int>("Dimension")) return own.get<int>("Dimension");
  return 0;
}

}  // namespace

UnitUses::UnitUses(const List& scene, const List& valid) {
  const int dimension = mesh_dimension(scene, valid);
  if (dimension == 2 || dimension == 3) dimension_ = std::to_string(dimension) + "D";
  const List conditions = sublist(scene, "Boundary Conditions");
  for (const auto& [name, entry] : entries(conditions)) {
    const List condition = sublist(conditions, name);
    const bool motion = text(condition, "Type", "Displacement") == "Displacement";
    histories_[text(condition, "History", "")].insert(motion ? "motion" : "load");
  }
}

std::set<std::string> UnitUses::of(const std::vector<std::string>& path, const List& list) const {
  if (path.size() >= 2 && path[0] == "Histories") {
    const auto found = histories_.find(path[1]);
    return found == histories_.end() ? std::set<std::string>{"motion"} : found->second;
  }
  if (path.size() == 2 && path[0] == "Boundary Conditions") {
    const std::string type = text(list, "Type", "Displacement");
    return {type, type + " in " + dimension_};
  }
  if (path.size() == 4 && path[1] == "Stop")
    return {text(list, "Quantity", "y")[0] == 'v' ? "velocity" : "coordinate or displacement"};
  return {};
}

}  // namespace ixos
