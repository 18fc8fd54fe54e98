#include "study/advice/advice_plane.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "study/advice/plane_scene.hpp"
#include "study/common/absolute_paths.hpp"

namespace ixos {

namespace {
using List = Teuchos::ParameterList;
}  // namespace

std::optional<AdvicePlane> plane_question(const AdviceQuestion& question, const std::string& path) {
  const List complete = changed_scene(question.scene, question.common);
  if (!why_spatial(complete).empty()) return std::nullopt;
  AdvicePlane plane;
  plane.question = question;
  plane.question.scene = path;
  plane.question.common.clear();
  plane.question.quantities.clear();
  plane.depth = complete.sublist("Mesh").sublist("Box").get<Teuchos::Array<double>>("Lengths")[1];
  for (const AskedQuantity& asked : question.quantities) {
    const std::optional<std::string> column = plane_column(asked.column());
    const bool grows = grows_with_depth(asked.column(), complete.sublist("Output").sublist("Probes"));
    if (!column || (grows && asked.has_limit())) return std::nullopt;
    plane.question.quantities.push_back(asked.of_column(*column));
    plane.factors.push_back(grows && asked.is_proportional() ? plane.depth : 1.0);
    plane.column_factors.push_back(grows ? plane.depth : 1.0);
  }
  return plane;
}

void write_plane_scene(const AdviceQuestion& question, const AdvicePlane& plane) {
  List scene = plane_scene(in_scene_units(user_scene(question.scene, question.common), scene_parameters()));
  make_paths_absolute(scene, question.scene);
  write_scene_file(scene, plane.question.scene);
}

double difference_from_space(const AdviceQuestion& question, const AdvicePlane& plane,
                             const AdviceDirections& directions, AdviceRuns& runs, const AdvicePoint& point) {
  const AdviceSample* const flat = runs.sample(point);
  const double unknown = std::numeric_limits<double>::infinity();
  if (flat == nullptr || !flat->good) return unknown;
  Assignments settings = settings_of(directions, point);
  const List there = changed_scene(plane.question.scene, settings);
  const auto cells = there.sublist("Mesh").sublist("Box").get<Teuchos::Array<int>>("Divisions");
  settings.push_back("Mesh/Box/Divisions={" + std::to_string(cells[0]) + ", 1, " + std::to_string(cells[1]) + "}");
  const AdviceSample spatial =
      runs.in_another_scene(question, {"in-space", {"in space, one cell across"}, {}}, settings);
  if (!spatial.good) return unknown;
  double largest = 0;
  for (std::size_t q = 0; q < spatial.values.size(); ++q) {
    const double scale = question.quantities[q].is_error() ? 1 : std::abs(spatial.values[q]);
    const double difference = std::abs(plane.factors[q] * flat->values[q] - spatial.values[q]);
    const double share = difference == 0 ? 0 : difference / scale;
    const double of_column =
        column_difference((*spatial.histories)[q], scaled((*flat->histories)[q], plane.column_factors[q]));
    if (!std::isfinite(share) || !std::isfinite(of_column)) return unknown;
    largest = std::max({largest, share, of_column});
  }
  return largest;
}

}  // namespace ixos
