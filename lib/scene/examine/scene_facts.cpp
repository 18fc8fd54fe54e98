#include "scene/examine/scene_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fem/cell_info.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "material/elastic_law.hpp"
#include "material/lame.hpp"
#include "mesh/layers.hpp"
#include "mesh/node_place.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "mesh/set_size.hpp"
#include "mesh/side_grid.hpp"
#include "mesh/side_set_nodes.hpp"
#include "scene/examine/symmetry_planes.hpp"

namespace ixos {
namespace {

int order_of(ContactElement element) {
  if (element == ContactElement::Q1C2 || element == ContactElement::Q2C2) return 2;
  if (element == ContactElement::Q1C4 || element == ContactElement::Q2C4) return 4;
  return element == ContactElement::Q1C1 ? 1 : 3;
}

/// Returns the attraction at a gap; 0 in repulsion and beyond the cutoff.
double attraction(const SceneInteraction& interaction, double gap) {
  if (interaction.cutoff > 0 && gap >= interaction.cutoff) return 0;
  return std::max(0.0, -static_cast<double>(interaction.law->traction(Pack(gap))[0]));
}

/// A law like Penalty returns another scale as its equilibrium gap; one that is defined at every gap may rest at 0.
std::optional<double> rest_gap(const GapLaw& law) {
  const double negligible = 1e-6 * std::abs(static_cast<double>(law.traction(Pack(law.adhesion_gap()))[0]));
  const auto rests = [&](double gap) {
    return std::abs(static_cast<double>(law.traction(Pack(gap))[0])) <= negligible;
  };
  if (!law.repels() || work_of_adhesion(law) == 0) return std::nullopt;
  if (law.domain() == GapDomain::All && rests(0)) return 0.0;
  return rests(law.equilibrium_gap()) ? std::optional<double>(law.equilibrium_gap()) : std::nullopt;
}

/// Returns whether the motion of an obstacle starts without a displacement; false if a program evaluates it.
bool begins_in_place(const SceneInteraction& interaction, const Histories& histories, const StepControlOptions& control,
                     int dimension) {
  for (const std::string& name : interaction.motion.histories())
    if (histories.is_given(name)) return false;
  const RigidMotion motion = rigid_motion(interaction.node.sublist("Motion"), interaction.motion, histories, dimension);
  const RigidPose pose = motion.pose(control.initial_time);
  return pose.translation == std::array<double, 3>{} && pose.angle == 0;
}

/// See SurfaceFacts::column.
double column(const Mesh& mesh, const std::vector<int>& parts, const SurfaceNumbers& surface,
              const SurfaceFacts& facts) {
  const bool is_flat = surface.largest_gap - surface.least_gap <= facts.peak_gap;
  if (surface.work == 0 || facts.has_friction || facts.drive.pulls.empty() || !is_flat ||
      !std::all_of(parts.begin(), parts.end(), [&](int part) { return part == surface.part; }))
    return 0;
  double foot = 0;
  for (const Side& side : mesh.side_sets[surface.side_set].sides) foot += side_measure(mesh, side);
  return mesh_quality(mesh).volume / (foot * surface.thickness);
}

bool follows_traction(const Friction& friction) {
  return friction.type == FrictionType::ExtendedAmontons || friction.type == FrictionType::Smoothed;
}

bool are_before_one_obstacle(const SurfaceNumbers& a, const SurfaceNumbers& b,
                             const std::vector<SceneInteraction>& interactions) {
  const SceneInteraction &own = interactions[a.interaction], &other = interactions[b.interaction];
  return a.part == b.part && a.least_gap == b.least_gap && a.normal == b.normal && own.side_set == other.side_set &&
         own.node.text("Obstacle") == other.node.text("Obstacle");
}

/// Returns that of branches with the history update Second Order; infinity without.
double shortest_relaxation(const Material& material) {
  double shortest = std::numeric_limits<double>::infinity();
  if (material.history_update == HistoryUpdate::SecondOrder)
    for (const MaxwellBranch& branch : material.branches) shortest = std::min(shortest, branch.time);
  return shortest;
}

/// Returns by node whether a condition or a grip prescribes a displacement of it.
std::vector<bool> held_nodes(const SceneNode& scene, const Mesh& mesh) {
  std::vector<bool> held(static_cast<std::size_t>(mesh.nodes()), false);
  const auto hold = [&](const SceneNode& node) {
    if (const NodeSet* const set = find_set(mesh.node_sets, node.text("Node Set")))
      for (int number : set->nodes) held[static_cast<std::size_t>(number)] = true;
  };
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists())
    if (node.text("Type") == "Displacement" || node.text("Type") == "Symmetry") hold(node);
  for (const SceneNode& node : scene.sublist("Grips").sublists()) hold(node);
  return held;
}

/// Returns how the cells of a material bend. `held`: see held_nodes().
BodyBending body_bending(const Material& material, const Mesh& mesh, const std::vector<bool>& held) {
  constexpr double slender = 4;
  const Lame lame = material.law->lame();
  BodyBending own;
  own.poissons_ratio = poissons_ratio(lame);
  own.is_volumetric =
      material.formulation == Formulation::Standard && own.poissons_ratio > nearly_incompressible + 1e-9;
  BendingQuery query;
  query.block = material.block;
  query.moduli = {lame.lambda + lame.mu, lame.mu, youngs_modulus(lame) / (1 - own.poissons_ratio * own.poissons_ratio)};
  // The deviator of the mode remains of Mean Dilatation.
  if (material.formulation == Formulation::MeanDilatation)
    query.moduli.along = lame.mu * (1 - 2.0 / mesh.body_dimension());
  query.enriched_only = material.formulation == Formulation::Enhanced;
  if (!own.is_volumetric) {
    query.slenderness = slender;
    query.held = held;
  }
  own.cells = typical_bending(mesh, query);
  for (const ElementBlock& block : mesh.blocks) {
    if (block.name != material.block || block.cells() == 0) continue;
    const CellInfo& info = cell_info(block.type);
    if (info.order == 1 && !is_cube(block.type)) own.stiff_cells = info.name;
    if (info.order == 2 && info.shape == ReferenceShape::Tetrahedron && material.formulation == Formulation::Standard)
      own.has_tetrahedra = true;
  }
  return own;
}

/// Adds the surfaces of an interaction whose spline has open creases.
void add_open_surfaces(const SceneInteraction& interaction, const Mesh& mesh, std::vector<OpenSurface>& surfaces) {
  if (!interaction.is_pair() || interaction.smoothing != Smoothing::Spline || mesh.dimension != 3) return;
  for (const std::string& set : {interaction.side_set, interaction.primary})
    if (const auto open = open_creases(mesh, side_set_named(mesh, set)); open.count > 0)
      surfaces.push_back({interaction.node.name(), set, open.count, open.angle});
}

/// Adds the first node of an interaction's surface whose partner on the other periodic side has another gap or normal.
void add_uneven_period(const SceneInteraction& interaction, const Mesh& mesh, std::vector<UnevenPeriod>& periods) {
  const SideSet* const set = find_set(mesh.side_sets, interaction.side_set);
  if (interaction.is_pair() || mesh.ties.empty() || set == nullptr) return;
  const std::set<int> surface = nodes_of(mesh, *set);
  const auto obstacle = obstacles().make(interaction.node, static_cast<std::size_t>(mesh.dimension));
  const auto gap_at = [&](int node) {
    const Vec<3> x = node_place(mesh, node);
    return obstacle->gap_and_normal({x[0], x[1], x[2]});
  };
  const double end = interaction.cutoff > 0 ? interaction.cutoff : interaction.law->range();
  for (const Tie& tie : mesh.ties) {
    if (tie.in_place || tie.masters.size() != 1 || surface.count(tie.node) == 0) continue;
    const ObstacleGap own = gap_at(tie.node), other = gap_at(tie.masters.front());
    double turn = 0;
    for (std::size_t i = 0; i < 3; ++i)
      turn = std::max(turn, std::abs(static_cast<double>(own.normal[i][0] - other.normal[i][0])));
    const double gap = own.gap[0], partner_gap = other.gap[0];
    if (gap >= end && partner_gap >= end) continue;  // nothing acts there
    if (std::abs(gap - partner_gap) <= 1e-3 * interaction.law->equilibrium_gap() && turn <= 1e-3) continue;
    periods.push_back(
        {interaction.node.name(), node_place(mesh, tie.node), node_place(mesh, tie.masters.front()), gap, partner_gap});
    return;
  }
}

}  // namespace

SceneFacts scene_facts(const SceneNode& scene, CharacteristicNumbers numbers, const std::vector<Material>& materials,
                       const std::vector<SceneInteraction>& interactions, const Mesh& mesh,
                       const std::vector<int>& parts, const Histories& histories, const StepControlOptions& control,
                       Inertia inertia) {
  SceneFacts facts;
  facts.dimension = mesh.dimension;
  Driving driving(scene, histories, control, mesh, parts);
  for (const SceneInteraction& interaction : interactions)
    driving.add_obstacle(interaction.node.sublist("Motion"), interaction.motion, histories);
  facts.motions = driving.motions();
  facts.loaded = driving.has_loads();
  facts.moves = driving.moves() || std::any_of(interactions.begin(), interactions.end(),
                                               [](const auto& interaction) { return interaction.moves(); });
  for (const SurfaceNumbers& surface : numbers.surfaces) {
    const SceneInteraction& interaction = interactions[surface.interaction];
    SurfaceFacts own;
    own.order = order_of(interaction.element);
    own.peak_gap = interaction.law->adhesion_gap();
    own.range = interaction.law->range();
    own.rest_gap = rest_gap(*interaction.law);
    own.repulsion = std::max(0.0, static_cast<double>(interaction.law->traction(Pack(surface.least_gap))[0]));
    own.open_cut = open_cut(scene, mesh, mesh.side_sets[surface.side_set], parts, surface.normal);
    own.moved = interaction.moves();
    own.never_bonds = surface.never_bonds ||
                      (own.moved && !interaction.law->bonds_later() && surface.least_gap >= interaction.law->range() &&
                       begins_in_place(interaction, histories, control, mesh.dimension));
    own.drive = driving.of_part(surface.part, surface.normal);
    own.attraction = attraction(interaction, std::max(surface.least_gap - own.drive.approach, own.peak_gap));
    const Material& material = materials[numbers.bodies[surface.body].material];
    own.opposed = std::any_of(interactions.begin(), interactions.end(), [&](const SceneInteraction& other) {
      return other.side_set == interaction.side_set && other.law->repels();
    });
    own.has_friction = std::any_of(interactions.begin(), interactions.end(), [&](const SceneInteraction& other) {
      return other.side_set == interaction.side_set && other.friction.type != FrictionType::None;
    });
    own.column = column(mesh, parts, surface, own);
    if (follows_traction(interaction.friction))
      for (const SurfaceNumbers& other : numbers.surfaces)
        if (other.interaction != surface.interaction && are_before_one_obstacle(surface, other, interactions))
          own.uncounted = other.name;
    // Enriched cells stay Standard; quadratic ones do not lock.
    if (interaction.element != ContactElement::Q2C2 && interaction.element != ContactElement::Q2C4 &&
        (material.formulation != Formulation::Enhanced || own.order > 1)) {
      const SingleLayer layer = single_layer(mesh, mesh.side_sets[surface.side_set]);
      own.single_layer = layer.share;
      own.layer_thickness = layer.thickness;
    }
    facts.surfaces.push_back(std::move(own));
  }
  for (const SceneInteraction& interaction : interactions)
    if (interaction.is_pair() && interaction.passes == Passes::DoubleIntegral)
      facts.dense_points.push_back({interaction.node.name(),
                                    std::max(median_face_length(mesh, side_set_named(mesh, interaction.side_set)),
                                             median_face_length(mesh, side_set_named(mesh, interaction.primary))),
                                    points_on_a_side(interaction.points), interaction.law->equilibrium_gap()});
  const std::vector<bool> held = held_nodes(scene, mesh);
  for (const BodyNumbers& body : numbers.bodies)
    facts.bending.push_back(body_bending(materials[body.material], mesh, held));
  for (const SceneInteraction& interaction : interactions) {
    add_open_surfaces(interaction, mesh, facts.open_surfaces);
    add_uneven_period(interaction, mesh, facts.uneven_periods);
  }
  for (const BodyNumbers& body : numbers.bodies)
    facts.relaxation_times.push_back(shortest_relaxation(materials[body.material]));
  facts.numbers = std::move(numbers);
  facts.has_inertia = inertia != Inertia::None;
  // Explicit schemes divide the step until it is stable.
  facts.step = control.adaptive.on || inertia == Inertia::Lumped ? 0 : control.time_step;
  facts.initial_time = control.initial_time;
  facts.duration = control.final_time - control.initial_time;
  facts.adaptive = control.adaptive.on;
  facts.longest_step = control.adaptive.on ? std::min(control.maximum_step, facts.duration) : control.time_step;
  return facts;
}

}  // namespace ixos
