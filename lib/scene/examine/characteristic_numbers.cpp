#include "scene/examine/characteristic_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "material/elastic_law.hpp"
#include "mesh/bounds.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/selection.hpp"
#include "scene/examine/pair_numbers.hpp"
#include "scene/examine/surface_shape.hpp"
#include "scene/read/mesh_parts.hpp"

namespace ixos {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls visit(node) for the nodes of all cells of the block, of enriched ones for those of their plain_type(); returns
/// whether there is one.
template <class Visit>
bool for_each_place(const Mesh& mesh, const std::string& name, const Visit& visit) {
  bool found = false;
  for (const ElementBlock& block : mesh.blocks) {
    if (block.name != name) continue;
    const int all = nodes_per_cell(block.type), places = nodes_per_cell(plain_type(block.type));
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 0; a < places; ++a) visit(block.nodes[cell_entry(cell, all, a)]);
    found = found || block.cells() > 0;
  }
  return found;
}

/// `parts`: by node, see connected_parts().
std::optional<BodyNumbers> body_numbers(const std::string& name, const Material& material, const Mesh& mesh,
                                        const std::vector<int>& parts) {
  std::map<int, Bounds> boxes;  // of the parts
  const bool found = for_each_place(mesh, material.block, [&](int node) {
    boxes[parts[static_cast<std::size_t>(node)]].add(node_place(mesh, node));
  });
  if (!found) return std::nullopt;
  const Lame lame = material.law->lame();
  const double ratio = poissons_ratio(lame);
  BodyNumbers body;
  body.name = name;
  body.modulus = youngs_modulus(lame);
  body.plane_modulus = body.modulus / (1 - ratio * ratio);
  body.density = material.density;
  body.wave_speed = std::sqrt((lame.lambda + 2 * lame.mu) / material.density);
  for (const auto& [part, box] : boxes) {
    for (std::size_t i = 0; i < 3; ++i) body.size = std::max(body.size, box.extent(i));
    if (mesh.axisymmetric) body.size = std::max(body.size, 2 * box.upper[0]);
  }
  body.crossing_time = body.size / body.wave_speed;
  return body;
}

/// Returns the length of a side between its corners, in 3D its area.
double measure_of(const Mesh& mesh, const Side& side) {
  const std::array<double, 3> normal = outward_normal(mesh, side);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  return mesh.dimension == 2 ? length : 0.5 * length;
}

ObstacleGap obstacle_gap(const Obstacle& obstacle, const Vec<3>& x) { return obstacle.at({x[0], x[1], x[2]}); }

/// Returns the curvature 1/R of a sphere's surface that has the obstacle's mean curvature below x: on parallel surfaces
/// a sphere's distance g from R bends by 1/(R + g) in each direction.
double curvature_below(const Obstacle& obstacle, const Vec<3>& x, int dimension) {
  const ObstacleGap found = obstacle_gap(obstacle, x);
  double bend = 0;
  for (std::size_t i = 0; i < 3; ++i) bend += found.bend[i][i][0] / (dimension - 1);
  return bend == 0 ? 0 : 1 / (1 / bend - found.gap[0]);
}

void add_law(const SceneInteraction& interaction, SurfaceNumbers& numbers) {
  const GapLaw& law = *interaction.law;
  numbers.is_electrode = interaction.node.text("Law") == "Electrostatic";
  numbers.equilibrium_gap = law.equilibrium_gap();
  const bool cut = interaction.cutoff > law.adhesion_gap();
  numbers.work = work_of_adhesion(cut ? *law.cut_off(interaction.cutoff) : law);
  numbers.peak_traction = std::max(0.0, -static_cast<double>(law.traction(law.adhesion_gap())[0]));
}

/// Takes the adhesion from a surface that can never have a bond. A moved obstacle may begin at another place.
void take_missing_bonds(const SceneInteraction& interaction, SurfaceNumbers& numbers) {
  numbers.never_bonds =
      !interaction.law->bonds_later() && !interaction.moves() && numbers.least_gap >= interaction.law->range();
  if (numbers.never_bonds) numbers.work = numbers.peak_traction = 0;
}

/// Returns the sides of a set that belong to a part.
SideSet sides_of_part(const Mesh& mesh, const SideSet& set, const std::vector<int>& parts, int part) {
  SideSet result{set.name, {}};
  for (const Side& side : set.sides)
    if (parts[static_cast<std::size_t>(corners_of(mesh, side)[0])] == part) result.sides.push_back(side);
  return result;
}

/// Adds what the sides of the set show; `nearest` becomes the node of least gap.
void add_sides(const Mesh& mesh, const SideSet& set, const Obstacle& obstacle, SurfaceNumbers& numbers,
               Vec<3>& nearest) {
  numbers.least_gap = infinity;
  numbers.largest_gap = -infinity;
  for (const Side& side : set.sides)
    for (const Vec<3>& point : side_points(mesh, side)) {
      const double gap = obstacle_gap(obstacle, point).gap[0];
      numbers.largest_gap = std::max(numbers.largest_gap, gap);
      if (!(gap < numbers.least_gap)) continue;
      numbers.least_gap = gap;
      nearest = point;
    }
  numbers.face_length = median_face_length(mesh, set);
}

}  // namespace

double median_face_length(const Mesh& mesh, const SideSet& set) {
  std::vector<double> measures;
  for (const Side& side : set.sides) {
    const bool is_triangle = mesh.dimension == 3 && count_of(corners_of(mesh, side)) == 3;  // half of a square's face
    measures.push_back((is_triangle ? 2 : 1) * measure_of(mesh, side));
  }
  if (measures.empty()) return 0;
  const auto middle = measures.begin() + static_cast<std::ptrdiff_t>(measures.size() / 2);
  std::nth_element(measures.begin(), middle, measures.end());
  return mesh.dimension == 2 ? *middle : std::sqrt(*middle);
}

double cohesive_zone(double plane_modulus, double work, double peak_traction, double thickness) {
  if (!(peak_traction > 0)) return 0;
  const double bulk = plane_modulus * work / (peak_traction * peak_traction);
  return std::min(bulk, std::pow(2.0 / 3 * bulk * thickness * thickness * thickness, 0.25));
}

void add_tabor(double radius, double plane_modulus, SurfaceNumbers& numbers) {
  numbers.radius = radius;
  const double elastic = numbers.work / plane_modulus;
  numbers.tabor = std::cbrt(radius * elastic * elastic / std::pow(numbers.equilibrium_gap, 3));
}

CharacteristicNumbers characteristic_numbers(const SceneNode& scene, const std::vector<Material>& materials,
                                             const std::vector<SceneInteraction>& interactions, const Mesh& mesh,
                                             const std::vector<int>& parts) {
  CharacteristicNumbers all;
  std::vector<std::size_t> body_of(materials.size(), std::string::npos);
  const std::vector<SceneNode> lists = scene.sublist("Materials").sublists();
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (auto body = body_numbers(lists[i].name(), materials[i], mesh, parts)) {
      body->material = i;
      body_of[i] = all.bodies.size();
      all.bodies.push_back(*body);
    }
  const std::vector<SceneNode> shapes = part_lists(scene.sublist("Mesh"));
  // The surface of a name, if it is on a body.
  const auto surface_of = [&](const std::string& name) -> std::optional<PairSurface> {
    const SideSet* const set = find_set(mesh.side_sets, name);
    if (set == nullptr || set->sides.empty()) return std::nullopt;
    const Side& first = set->sides.front();
    const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(first.block)];
    const auto material =
        std::find_if(materials.begin(), materials.end(), [&](const Material& own) { return own.block == block.name; });
    if (material == materials.end()) return std::nullopt;
    const int node = block.nodes[cell_entry(first.cell, nodes_per_cell(block.type))];
    const SceneNode& shape = list_of(block, shapes);
    const std::string type = shape.text("Type");
    const bool is_ball = type == "Disk" || type == "Ball";
    return PairSurface{*set, all.bodies[body_of[static_cast<std::size_t>(material - materials.begin())]],
                       parts[static_cast<std::size_t>(node)],
                       is_ball ? 2 / shape.sublist(type).number("Diameter") : 0.0};
  };
  for (std::size_t i = 0; i < interactions.size(); ++i) {
    const SceneInteraction& interaction = interactions[i];
    const auto surface = surface_of(interaction.side_set);
    if (!surface) continue;
    const BodyNumbers& body = surface->body;
    SurfaceNumbers numbers;
    numbers.name = interaction.node.name();
    numbers.interaction = i;
    numbers.side_set = static_cast<std::size_t>(&surface->set - mesh.side_sets.data());
    numbers.body = static_cast<std::size_t>(&body - all.bodies.data());
    numbers.part = surface->part;
    add_law(interaction, numbers);
    if (interaction.is_pair()) {
      const auto other = surface_of(interaction.primary);
      if (!other || interaction.is_with_itself()) continue;
      add_pair(mesh, parts, *surface, *other, numbers);
      all.pairs.push_back(std::move(numbers));
      continue;
    }
    const auto obstacle = obstacles().make(interaction.node, static_cast<std::size_t>(mesh.dimension));
    Vec<3> nearest{};
    add_sides(mesh, surface->set, *obstacle, numbers, nearest);
    take_missing_bonds(interaction, numbers);
    numbers.elastic_length = numbers.work / body.modulus;
    const ObstacleGap found = obstacle_gap(*obstacle, nearest);
    for (std::size_t axis = 0; axis < 3; ++axis) numbers.normal[axis] = found.normal[axis][0];
    numbers.extent = extent_of(mesh, sides_of_part(mesh, surface->set, parts, numbers.part), numbers.normal);
    numbers.thickness = extent_along(mesh, parts, numbers.part, numbers.normal);
    numbers.cohesive_zone = cohesive_zone(body.plane_modulus, numbers.work, numbers.peak_traction, numbers.thickness);
    double curvature = curvature_below(*obstacle, nearest, mesh.dimension);
    curvature +=
        surface->curvature > 0 ? surface->curvature : curvature_of(mesh, surface->set, nearest, numbers.normal);
    if (curvature > 0) add_tabor(1 / curvature, body.plane_modulus, numbers);
    numbers.attraction_speed = std::sqrt(2 * numbers.work / (body.density * numbers.thickness));
    numbers.gap_crossing_time = numbers.equilibrium_gap / numbers.attraction_speed;
    all.surfaces.push_back(std::move(numbers));
  }
  return all;
}

}  // namespace ixos
