#include "study/advice/advice_directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "study/advice/advice_choices.hpp"
#include "study/advice/advice_lists.hpp"
#include "study/advice/advice_mesh.hpp"
#include "study/common/tuning.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

const char* const control_path = "Time Integrator/Time Step Control/";

AdviceDirection time_steps(const List& integrator, bool& adaptive) {
  const List& control = integrator.sublist("Time Step Control");
  const double duration = control.get<double>("Final Time") - control.get<double>("Initial Time");
  const double tolerance = control.isSublist("Adaptive") ? control.sublist("Adaptive").get<double>("Tolerance") : 0;
  adaptive = control.get<std::string>("Type") == "Adaptive" && tolerance > 0;
  const double size = adaptive ? tolerance : control.get<double>("Time Step");
  const int factor = adaptive ? 4 : 2;
  AdviceDirection direction{adaptive ? "step tolerance" : "time step", {}, 0, true};
  std::vector<AdviceLevel> levels;
  for (int k = tuning::coarser_steps; k >= -tuning::finer_steps; --k) {
    const double here = size * std::pow(factor, k);
    if (k > 0 && !adaptive && duration / here < tuning::fewest_steps) continue;
    if (k == 0) direction.scene_level = levels.size();
    const std::string path = std::string(control_path) + (adaptive ? "Adaptive/Tolerance" : "Time Step");
    levels.push_back({fmt::format("{:.6g}", here), here, {fmt::format("{}={}", path, here)}});
  }
  const std::string& own = integrator.get<std::string>("Type");
  direction.branches.push_back({own, {}, levels});
  if (own == "Static" || own == "Central Difference" || own == "Custom") return direction;
  // The ones first that are most often the cheapest.
  for (const char* name : {"Generalized-Alpha", "Bathe Composite", "Average Vector Field", "Newmark", "Energy-Momentum",
                           "Gautam-Sauer Composite", "Static"})
    if (name != own)
      direction.branches.push_back(
          {name, {std::string("Time Integrator/Type=") + scheme(name).name}, levels, name != std::string("Static")});
  return direction;
}

/// Returns the mesh direction: the meshes with the scene's elements, then with others.
AdviceDirection meshes(const List& scene, const MeshLevels& found) {
  AdviceDirection direction{"mesh", {}, found.scene_level, true};
  const List &interactions = scene.sublist("Interactions"), &materials = scene.sublist("Materials");
  const std::vector<std::string> walls = list_names(interactions), bodies = list_names(materials);
  const std::vector<std::string> elements{"Q1C4", "Q1CH", "Q1C2", "Q1C1"};
  const bool linear = scene.sublist("Mesh").get<int>("Cell Order") == 1;
  const bool contact = linear && all_are(interactions, walls, "Contact Element", elements);
  const bool formulation = linear && all_are(materials, bodies, "Element Formulation", {"Standard", "Enhanced"});
  const std::string own = contact ? interactions.sublist(walls.front()).get<std::string>("Contact Element") : "";
  const std::string own_formulation =
      formulation ? materials.sublist(bodies.front()).get<std::string>("Element Formulation") : "";
  direction.branches.push_back({own, {}, found.levels});
  if (formulation) {
    const std::string other = own_formulation == "Standard" ? "Enhanced" : "Standard";
    direction.branches.push_back(
        {other + " cells", in_all("Materials", bodies, "Element Formulation=" + other), found.levels});
  }
  if (contact && own_formulation == "Standard") {
    Assignments quadratic = in_all("Interactions", walls, "Contact Element=Q2C2");
    quadratic.emplace_back("Mesh/Cell Order=2");
    direction.branches.push_back({"quadratic cells", quadratic, found.levels, true, true, true});
  }
  // The richer ones come first.
  bool richer = true;
  for (const std::string& element : elements) {
    if (contact && element != own)
      direction.branches.push_back(
          {element, in_all("Interactions", walls, "Contact Element=" + element), found.levels, true, richer});
    richer = richer && element != own;
  }
  return direction;
}

}  // namespace

bool replaces_model(const AdviceDirections& directions, std::size_t direction, std::size_t branch) {
  const AdviceDirection& own = directions.all[direction];
  return branch != 0 && !(own.converges && own.branches[branch].same_limit);
}

bool has_other_laws(const AdviceDirections& directions) {
  for (const AdviceDirection& direction : directions.all)
    for (const AdviceBranch& branch : direction.branches)
      if (!branch.law.empty()) return true;
  return false;
}

AdviceDirections advice_directions(const List& complete) {
  AdviceDirections result;
  result.all.push_back(time_steps(complete.sublist("Time Integrator"), result.adaptive));
  const MeshLevels found = mesh_levels(complete.sublist("Mesh"));
  result.dimension = found.dimension;
  result.mesh_note = found.note;
  result.all.push_back(meshes(complete, found));
  for (AdviceDirection& direction : advice_choices(complete)) result.all.push_back(std::move(direction));
  const List& materials = complete.sublist("Materials");
  for (const std::string& body : list_names(materials))
    result.perturbation.push_back(
        fmt::format("Materials/{}/Density={}", body,
                    materials.sublist(body).get<double>("Density") * (1 + tuning::perturbation_size)));
  return result;
}

}  // namespace ixos
