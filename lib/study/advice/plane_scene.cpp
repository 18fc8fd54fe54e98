#include "study/advice/plane_scene.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <array>
#include <vector>

#include "parameters/parameter_entries.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// Entries that hold vectors of space, and numbers by direction.
const std::array<const char*, 14> vectors{"Lower",       "Upper",         "Lengths",  "Divisions", "Plane Normal",
                                          "Plane Point", "Sphere Center", "Normal",   "Point",     "Center",
                                          "Direction",   "Vector",        "Velocity", "Origin"};

/// Returns the names of all sublists.
std::vector<std::string> sublist_names(const List& lists) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries(lists))
    if (entry.isList()) names.push_back(name);
  return names;
}

std::vector<double> numbers(const List& list, const char* name) {
  return list.get<Teuchos::Array<double>>(name).toVector();
}

/// Returns whether a vector lies in the plane; empty ones stand for defaults, which do.
bool is_in_plane(const List& list, const char* name) {
  const std::vector<double> vector = numbers(list, name);
  return vector.empty() || (vector.size() == 3 && vector[1] == 0);
}

/// Returns the vector's second component, or that value if it is empty.
double second(const List& list, const char* name, double otherwise) {
  const std::vector<double> vector = numbers(list, name);
  return vector.size() == 3 ? vector[1] : otherwise;
}

/// Returns whether a set holds sides or nodes of the faces front and back.
bool is_across(const std::string& set) { return set == "front" || set == "back" || set == "surface"; }

bool holds_y_alone(const List& condition) {
  return condition.get<std::string>("Type") == "Displacement" && condition.get<std::string>("Components") == "y" &&
         condition.get<std::string>("History").empty();
}

/// A set of sides from the whole boundary must leave out those of front and back.
std::string why_set_is_spatial(const List& set, double low, double high) {
  const double slack = 1e-9 * (high - low);
  if (second(set, "Lower", low) > low + slack || second(set, "Upper", high) < high - slack)
    return "its box ends within the depth";
  if (!is_in_plane(set, "Plane Normal") || !is_in_plane(set, "Normal")) return "its normal points along y";
  if (set.get<double>("Sphere Radius") > 0) return "it has a sphere";
  const std::string& from = set.get<std::string>("From");
  if (is_across(from)) return "it is a part of " + from;
  const bool looks_along = !numbers(set, "Normal").empty() && set.get<double>("Normal Angle") < 90;
  const bool leaves_out =
      set.get<std::string>("Kind") == "Nodes" || !from.empty() || looks_along || !numbers(set, "Plane Normal").empty();
  return leaves_out ? "" : "it may have sides of front and back";
}

std::string why_wall_is_spatial(const List& wall) {
  if (!wall.get<std::string>("Primary Side Set").empty()) return "it has two surfaces";
  if (is_across(wall.get<std::string>("Side Set"))) return "it acts on " + wall.get<std::string>("Side Set");
  if (!wall.get<std::string>("Factor").empty() || !wall.get<std::string>("Factor Field").empty())
    return "it has a factor";
  const List& motion = wall.sublist("Motion");
  if (!motion.get<Teuchos::Array<std::string>>("Translation").empty() || !motion.get<std::string>("Rotation").empty())
    return "its obstacle moves";
  const std::string& obstacle = wall.get<std::string>("Obstacle");
  if (obstacle == "Half-Space") return is_in_plane(wall, "Normal") ? "" : "its wall looks along y";
  if (obstacle != "Cylinder") return "its obstacle is a " + obstacle;
  const std::vector<double> axis = numbers(wall.sublist(obstacle), "Axis");
  return axis.size() == 3 && axis[0] == 0 && axis[2] == 0 ? "" : "its cylinder does not lie along y";
}

std::string why_condition_is_spatial(const List& condition) {
  const std::string& type = condition.get<std::string>("Type");
  if (type == "Point Force") return "it acts on points";
  if (type == "Symmetry") return "it is a plane of symmetry";
  if (type != "Displacement") {
    if (type == "Traction" && is_across(condition.get<std::string>("Side Set")))
      return "it acts on " + condition.get<std::string>("Side Set");
    return is_in_plane(condition, "Vector") ? "" : "its vector points along y";
  }
  const std::string &set = condition.get<std::string>("Node Set"), &moved = condition.get<std::string>("Components");
  if (is_across(set)) return holds_y_alone(condition) ? "" : "it moves " + set + " otherwise than along y";
  const bool along = moved == "all" || moved.find('y') != std::string::npos;
  return along && !condition.get<std::string>("History").empty() ? "it moves along y" : "";
}

/// Returns the first reason that why(sublist) has, with the sublist's path.
template <class Why>
std::string first_reason(const List& lists, const std::string& path, const Why& why) {
  for (const std::string& name : sublist_names(lists))
    if (const std::string reason = why(lists.sublist(name)); !reason.empty())
      return fmt::format("{}/{}: {}", path, name, reason);
  return "";
}

bool is_held(const List& conditions, const std::string& face) {
  const std::vector<std::string> names = sublist_names(conditions);
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    const List& condition = conditions.sublist(name);
    return condition.get<std::string>("Node Set") == face && holds_y_alone(condition);
  });
}

std::string why_mesh_is_spatial(const List& mesh) {
  if (mesh.get<std::string>("Type") != "Box") return "Mesh: it is no box";
  const List& box = mesh.sublist("Box");
  if (box.get<int>("Dimension") != 3) return "Mesh: it has two dimensions";
  for (const char* formula : {"X", "Y", "Z"})
    if (!mesh.sublist("Map").get<std::string>(formula).empty()) return "Mesh: it is mapped";
  const double low = second(box, "Lower", 0), high = low + second(box, "Lengths", 1);
  return first_reason(mesh.sublist("Sets"), "Mesh/Sets",
                      [&](const List& set) { return why_set_is_spatial(set, low, high); });
}

/// Drops the second one of three numbers.
template <class T>
void drop_second(List& list, const std::string& name) {
  Teuchos::Array<T> values = list.get<Teuchos::Array<T>>(name);
  if (values.size() == 3) values.erase(values.begin() + 1);
  list.set(name, values);
}

void flatten_vectors(List& list) {
  for (const std::string& name : sublist_names(list)) flatten_vectors(list.sublist(name));
  for (const char* name : vectors) {
    if (list.isType<Teuchos::Array<double>>(name)) drop_second<double>(list, name);
    if (list.isType<Teuchos::Array<int>>(name)) drop_second<int>(list, name);
  }
}

void flatten_conditions(List& conditions) {
  for (const std::string& name : sublist_names(conditions)) {
    List& condition = conditions.sublist(name);
    const bool moves = !condition.isParameter("Type") || condition.get<std::string>("Type") == "Displacement";
    if (!moves || !condition.isParameter("Components")) continue;
    std::string moved = condition.get<std::string>("Components");
    if (moved != "all") {
      moved.erase(std::remove(moved.begin(), moved.end(), 'y'), moved.end());
      std::replace(moved.begin(), moved.end(), 'z', 'y');
    }
    if (moved.empty())
      conditions.remove(name);
    else
      condition.set("Components", moved);
  }
}

void flatten_output(List& output) {
  if (!output.isParameter("Reactions")) return;
  Teuchos::Array<std::string> kept;
  for (const std::string& set : output.get<Teuchos::Array<std::string>>("Reactions"))
    if (set != "front" && set != "back") kept.push_back(set);
  output.set("Reactions", kept);
}

}  // namespace

std::string why_spatial(const List& complete) {
  if (std::string why = why_mesh_is_spatial(complete.sublist("Mesh")); !why.empty()) return why;
  const List& conditions = complete.sublist("Boundary Conditions");
  for (const char* face : {"front", "back"})
    if (!is_held(conditions, face)) return fmt::format("the face {} may leave its plane", face);
  if (std::string why = first_reason(conditions, "Boundary Conditions", why_condition_is_spatial); !why.empty())
    return why;
  if (std::string why = first_reason(complete.sublist("Interactions"), "Interactions", why_wall_is_spatial);
      !why.empty())
    return why;
  if (!sublist_names(complete.sublist("Grips")).empty()) return "it has grips";
  if (!sublist_names(complete.sublist("Rigid Bodies")).empty()) return "it has rigid bodies";
  if (!sublist_names(complete.sublist("Time Integrator").sublist("Stop")).empty()) return "it has conditions to stop";
  const List& start = complete.sublist("Initial Conditions");
  const bool is_simple = sublist_names(start).empty() && numbers(start, "Velocity Gradient").empty() &&
                         numbers(start, "Angular Velocity").empty();
  return is_simple && is_in_plane(start, "Velocity") ? "" : "Initial Conditions: the body turns or moves along y";
}

List plane_scene(List scene) {
  List& mesh = scene.sublist("Mesh");
  mesh.sublist("Box").set("Dimension", 2);
  flatten_conditions(scene.sublist("Boundary Conditions"));
  flatten_output(scene.sublist("Output"));
  List& walls = scene.sublist("Interactions");
  for (const std::string& name : sublist_names(walls))
    if (walls.sublist(name).isSublist("Cylinder")) walls.sublist(name).sublist("Cylinder").remove("Axis", false);
  for (const char* part : {"Mesh", "Interactions", "Boundary Conditions", "Initial Conditions", "Output"})
    flatten_vectors(scene.sublist(part));
  scene.sublist("Output").remove("Quantities", false);
  return scene;
}

std::optional<std::string> plane_column(const std::string& column) {
  const auto ends = [&](const char* end) {
    const std::size_t size = std::string(end).size();
    return column.size() > size && column.compare(column.size() - size, size, end) == 0;
  };
  // Turns about y become turns about z, the other way round.
  const bool turns = column.find("angular_momentum") != std::string::npos || column.rfind("contact_moment", 0) == 0;
  if (turns || ends("_y") || ends("_uy") || ends("_vy")) return std::nullopt;
  std::string result = column;
  if (ends("_z") || ends("_uz") || ends("_vz")) result.back() = 'y';
  return result;
}

bool grows_with_depth(const std::string& column, const List& probes) {
  const auto begins = [&](const std::string& start) { return column.rfind(start, 0) == 0; };
  for (const std::string& name : sublist_names(probes))
    if (begins(name + "_u") || begins(name + "_v")) return false;
  if (begins("norm_") || begins("min_gap") || begins("mean_slip")) return false;
  const std::array<const char*, 7> words{"energy", "work", "dissipated", "momentum", "force", "reaction", "measure"};
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return column.find(word) != std::string::npos; });
}

}  // namespace ixos
