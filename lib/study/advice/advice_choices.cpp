#include "study/advice/advice_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "study/advice/advice_lists.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

const char* const linear_material = "Linear Elastic";

AdviceDirection tolerances(const List& scene) {
  const double own = scene.sublist("Nonlinear Solver").get<double>("Tolerance");
  AdviceDirection direction{"Newton tolerance", {{"", {}, {}}}, 0, true, own > tuning::loose_tolerance};
  std::vector<AdviceLevel>& levels = direction.branches[0].levels;
  const auto add = [&](double value) {
    levels.push_back({fmt::format("{:g}", value), value, {fmt::format("Nonlinear Solver/Tolerance={}", value)}});
  };
  for (double value : {1e-6, 1e-8})
    if (value > 2 * own) add(value);
  direction.scene_level = levels.size();
  add(own);
  if (direction.suspect) add(own / 100);
  return direction;
}

/// A number in lists of interactions, and its own values there.
struct WallNumbers {
  std::string entry;
  std::vector<std::string> walls;
  std::vector<double> own;

  AdviceLevel level(double size, const std::string& label, double factor, double most) const {
    AdviceLevel result{label, size, {}};
    for (std::size_t i = 0; i < walls.size(); ++i)
      result.settings.push_back(
          fmt::format("Interactions/{}/{}={:g}", walls[i], entry, std::min(most, factor * own[i])));
    return result;
  }
};

AdviceDirection surface_points(const List& interactions, const std::vector<std::string>& walls) {
  AdviceDirection direction{"surface points", {{"", {}, {}}}, 0, true, false};
  WallNumbers numbers{"Surface Points", walls, {}};
  int least = tuning::most_points, largest = 0;
  for (const std::string& wall : walls) {
    const std::string element = interactions.sublist(wall).get<std::string>("Contact Element");
    const bool enriched = element == "Q1C3" || element == "Q1C4" || element == "Q1CH" || element == "Q2C4";
    const int usual = enriched ? tuning::default_points_enriched : tuning::default_points;
    const int given = interactions.sublist(wall).get<int>("Surface Points"), own = given == 0 ? usual : given;
    direction.suspect = direction.suspect || own < usual;
    numbers.own.push_back(own);
    least = std::min(least, own);
    largest = std::max(largest, own);
  }
  std::vector<AdviceLevel>& levels = direction.branches[0].levels;
  if (least > tuning::few_points)
    levels.push_back(numbers.level(static_cast<double>(least) / tuning::few_points, "3", 1, tuning::few_points));
  direction.scene_level = levels.size();
  levels.push_back({"as given", 1, {}});
  if (2 * largest <= tuning::most_points) levels.push_back(numbers.level(0.5, "twice as many", 2, tuning::most_points));
  return direction;
}

AdviceDirection cutoffs(const List& interactions, const std::vector<std::string>& walls) {
  AdviceDirection direction{"cutoff", {{"", {}, {}}}, 1, true, true};
  WallNumbers numbers{"Cutoff", {}, {}};
  for (const std::string& wall : walls) {
    const double own = interactions.sublist(wall).get<double>("Cutoff");
    if (!(own > 0)) continue;
    numbers.walls.push_back(wall);
    numbers.own.push_back(own);
  }
  if (numbers.walls.empty()) return direction;
  const double none = std::numeric_limits<double>::max();
  direction.branches[0].levels = {
      numbers.level(2, "half", 0.5, none), {"as given", 1, {}}, numbers.level(0.5, "twice as large", 2, none)};
  return direction;
}

/// Returns the choice between the scene's own and one other.
AdviceDirection choice(const std::string& name, const std::string& own, const std::string& other,
                       const Assignments& settings) {
  return {name, {{own, {}, {{"", 1, {}}}}, {other, settings, {{"", 1, {}}}}}, 0, false, false};
}

bool is_damped(const List& materials, const std::vector<std::string>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const std::string& body) {
    const List& material = materials.sublist(body);
    return material.get<double>("Mass Damping") > 0 || material.get<double>("Stiffness Damping") > 0;
  });
}

}  // namespace

std::vector<AdviceDirection> advice_choices(const List& complete) {
  const List &materials = complete.sublist("Materials"), &interactions = complete.sublist("Interactions");
  const std::vector<std::string> bodies = list_names(materials), walls = list_names(interactions);
  std::vector<AdviceDirection> result{tolerances(complete)};
  if (!walls.empty()) result.push_back(surface_points(interactions, walls));
  if (AdviceDirection cutoff = cutoffs(interactions, walls); !cutoff.branches[0].levels.empty())
    result.push_back(std::move(cutoff));
  if (all_are(materials, bodies, "Model", {"Neo-Hooke", "Saint Venant-Kirchhoff"})) {
    result.push_back(choice("material", materials.sublist(bodies.front()).get<std::string>("Model"), linear_material,
                            in_all("Materials", bodies, std::string("Model=") + linear_material)));
    result.back().branches.back().law = linear_material;
  }
  if (is_damped(materials, bodies)) {
    Assignments settings = in_all("Materials", bodies, "Mass Damping=0");
    for (const std::string& setting : in_all("Materials", bodies, "Stiffness Damping=0")) settings.push_back(setting);
    result.push_back(choice("damping", "as given", "none", settings));
  }
  return result;
}

}  // namespace ixos
