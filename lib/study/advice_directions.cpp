#include "study/advice_directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/parameter_entries.hpp"
#include "parameters/validation.hpp"
#include "scene/parameters.hpp"
#include "study/advice_mesh.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

constexpr double fewest_steps = 60;
constexpr int coarser_steps = 4, finer_steps = 5;
constexpr double perturbation_size = 1e-10;

const char* const control_path = "Time Integrator/Time Step Control/";
const char* const linear_material = "Linear Elastic";

/// Returns the names of the sublists whose paths a setting can name.
std::vector<std::string> names_of(const List& lists) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries(lists))
    if (entry.isList() && name.find_first_of("=/") == std::string::npos) names.push_back(name);
  return names;
}

/// Returns the setting of a parameter in all of these lists.
Assignments in_all(const std::string& path, const std::vector<std::string>& names, const std::string& setting) {
  Assignments result;
  result.reserve(names.size());
  for (const std::string& name : names) result.push_back(fmt::format("{}/{}/{}", path, name, setting));
  return result;
}

/// Returns whether a text has the same value in all of these lists, and that value is one of the words.
bool all_are(const List& lists, const std::vector<std::string>& names, const char* entry,
             const std::vector<std::string>& words) {
  return !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const std::string value = lists.sublist(name).get<std::string>(entry);
    return value == lists.sublist(names.front()).get<std::string>(entry) &&
           std::find(words.begin(), words.end(), value) != words.end();
  });
}

AdviceDirection time_steps(const List& integrator, bool& adaptive) {
  const List& control = integrator.sublist("Time Step Control");
  const double duration = control.get<double>("Final Time") - control.get<double>("Initial Time");
  const double tolerance = control.isSublist("Adaptive") ? control.sublist("Adaptive").get<double>("Tolerance") : 0;
  adaptive = control.get<std::string>("Type") == "Adaptive" && tolerance > 0;
  const double size = adaptive ? tolerance : control.get<double>("Time Step");
  const int factor = adaptive ? 4 : 2;
  AdviceDirection direction{adaptive ? "step tolerance" : "time step", {}, 0, true};
  std::vector<AdviceLevel> levels;
  for (int k = coarser_steps; k >= -finer_steps; --k) {
    const double here = size * std::pow(factor, k);
    if (k > 0 && !adaptive && duration / here < fewest_steps) continue;
    if (k == 0) direction.scene_level = levels.size();
    const std::string path = std::string(control_path) + (adaptive ? "Adaptive/Tolerance" : "Time Step");
    levels.push_back({fmt::format("{:.6g}", here), here, {fmt::format("{}={}", path, here)}});
  }
  const std::string& own = integrator.get<std::string>("Type");
  direction.branches.push_back({own, {}, levels});
  if (own == "Static" || own == "Central Difference" || own == "Custom") return direction;
  for (const char* name : {"Newmark", "Bathe Composite", "Generalized-Alpha", "Average Vector Field", "Energy-Momentum",
                           "Gautam-Sauer Composite", "Static"})
    if (name != own)
      direction.branches.push_back({name, {std::string("Time Integrator/Type=") + scheme(name).name}, levels});
  return direction;
}

/// Returns the mesh direction: the meshes with the scene's elements, then with others.
AdviceDirection meshes(const List& scene, const MeshLevels& found) {
  AdviceDirection direction{"mesh", {}, found.scene_level, true};
  const List &interactions = scene.sublist("Interactions"), &materials = scene.sublist("Materials");
  const std::vector<std::string> walls = names_of(interactions), bodies = names_of(materials);
  const std::vector<std::string> elements{"Q1C1", "Q1C2", "Q1C4", "Q1CH"};
  const bool linear = scene.sublist("Mesh").get<int>("Cell Order") == 1;
  const bool contact = linear && all_are(interactions, walls, "Contact Element", elements);
  const bool formulation = linear && all_are(materials, bodies, "Element Formulation", {"Standard", "Enhanced"});
  const std::string own = contact ? interactions.sublist(walls.front()).get<std::string>("Contact Element") : "";
  const std::string own_formulation =
      formulation ? materials.sublist(bodies.front()).get<std::string>("Element Formulation") : "";
  direction.branches.push_back({own, {}, found.levels});
  if (contact)
    for (const std::string& element : elements)
      if (element != own)
        direction.branches.push_back(
            {element, in_all("Interactions", walls, "Contact Element=" + element), found.levels});
  if (formulation) {
    const std::string other = own_formulation == "Standard" ? "Enhanced" : "Standard";
    direction.branches.push_back(
        {other + " cells", in_all("Materials", bodies, "Element Formulation=" + other), found.levels});
  }
  if (contact && own_formulation == "Standard") {
    Assignments quadratic = in_all("Interactions", walls, "Contact Element=Q2C2");
    quadratic.emplace_back("Mesh/Cell Order=2");
    direction.branches.push_back({"quadratic cells", quadratic, found.levels});
  }
  return direction;
}

/// Returns a direction whose branches have one level each: the scene's own, then others.
AdviceDirection choice(const std::string& name, const std::string& own, const std::vector<AdviceBranch>& others) {
  AdviceDirection direction{name, {{own, {}, {{"", 1, {}}}}}, 0, false};
  for (const AdviceBranch& other : others) direction.branches.push_back({other.label, other.settings, {{"", 1, {}}}});
  return direction;
}

}  // namespace

AdviceDirections advice_directions(const List& complete) {
  AdviceDirections result;
  result.all.push_back(time_steps(complete.sublist("Time Integrator"), result.adaptive));
  const MeshLevels found = mesh_levels(complete.sublist("Mesh"));
  result.dimension = found.dimension;
  result.mesh_note = found.note;
  result.all.push_back(meshes(complete, found));
  const List &materials = complete.sublist("Materials"), &interactions = complete.sublist("Interactions");
  const std::vector<std::string> bodies = names_of(materials), walls = names_of(interactions);
  for (const std::string& body : bodies)
    result.perturbation.push_back(fmt::format(
        "Materials/{}/Density={}", body, materials.sublist(body).get<double>("Density") * (1 + perturbation_size)));
  const double tolerance = complete.sublist("Nonlinear Solver").get<double>("Tolerance");
  std::vector<AdviceBranch> looser;
  for (double value : {1e-8, 1e-6})
    if (value > 2 * tolerance)
      looser.push_back({fmt::format("{:g}", value), {fmt::format("Nonlinear Solver/Tolerance={:g}", value)}, {}});
  if (!looser.empty()) result.all.push_back(choice("Newton tolerance", fmt::format("{:g}", tolerance), looser));
  if (all_are(materials, bodies, "Model", {"Neo-Hooke", "Saint Venant-Kirchhoff"}))
    result.all.push_back(
        choice("material", materials.sublist(bodies.front()).get<std::string>("Model"),
               {{linear_material, in_all("Materials", bodies, std::string("Model=") + linear_material), {}}}));
  if (!walls.empty())
    result.all.push_back(
        choice("surface points", "as given", {{"3 per side", in_all("Interactions", walls, "Surface Points=3"), {}}}));
  return result;
}

}  // namespace ixos
