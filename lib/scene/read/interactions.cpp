#include "scene/read/interactions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/friction_law.hpp"
#include "interaction/pair_kernel.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/enrichment/contact_elements.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "model/surface_interaction.hpp"
#include "parameters/expression.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "scene/read/friction.hpp"
#include "scene/read/rigid_bodies.hpp"

namespace ixos {
namespace {

constexpr const char* exodus_format = "Exodus";

const Options<MotionOptions>& motion_options() {
  static const Options<MotionOptions> all = [] {
    Options<MotionOptions> entries;
    add_motion_options(entries, "obstacle", "");
    return entries;
  }();
  return all;
}

const Options<InteractionSettings>& options() {
  static const Options<InteractionSettings> all =
      Options<InteractionSettings>()
          .add("Side Set", &InteractionSettings::side_set, "Side set of the surface that interacts.")
          .add(
              "Primary Side Set", &InteractionSettings::primary,
              "Side set of the surface of another body, the primary (master) surface, from which the gaps of the Side "
              "Set, the secondary (slave) surface, are measured; then there is no obstacle. Choose the finer surface "
              "as the secondary one. The Side Set itself: the surface interacts with itself. Empty: the interaction is "
              "that with the Obstacle.")
          .choose("Smoothing", &InteractionSettings::smoothing,
                  std::vector<std::pair<std::string, Smoothing>>{
                      {"Catmull-Rom", Smoothing::CatmullRom}, {"Spline", Smoothing::Spline}, {"None", Smoothing::None}},
                  "Shape of both surfaces of a pair between their nodes: Catmull-Rom is a smooth curve through the "
                  "nodes, with corners where two sides meet at more than 30 degrees; Spline is a "
                  "curve near the nodes with the same corners and one curvature between them; None has straight "
                  "sides, whose normals jump at the nodes. Catmull-Rom gives surfaces with triangles curved sides, "
                  "whose normals jump a little; Spline is not there for them. It has no effect without a Primary Side "
                  "Set.")
          .add("Exclusion", &InteractionSettings::exclusion,
               "For a surface that interacts with itself, whose Primary Side Set is its Side Set: distance along the "
               "undeformed surface below which its parts do not interact [L0]. Take about pi times the Cutoff, which "
               "such a surface needs. Otherwise 0.",
               at_least(0))
          .choose(
              "Passes", &InteractionSettings::passes,
              std::vector<std::pair<std::string, Passes>>{{"One", Passes::One},
                                                          {"Two", Passes::Two},
                                                          {"Two Without Reaction", Passes::TwoWithoutReaction},
                                                          {"Double Integral", Passes::DoubleIntegral}},
              "How a pair is integrated: over the Side Set, whose reaction the other surface takes (One); over both "
              "surfaces, each with half the law, which treats both bodies alike and takes twice the time (Two); over "
              "both with the whole law and without reactions, which conserves neither energy nor momentum and is "
              "for comparison; or by all pairs of points of both surfaces, without a gap (Double Integral), which is "
              "exact for curved bodies, a reference for small surfaces. It has no effect without a Primary Side Set.")
          .choose("Contact Element", &InteractionSettings::element, contact_elements(),
                  "Interpolation of the displacement along the contact side, in 3D in both directions of the face. "
                  "Q1C1 is linear; Q1C2, Q1C3 and Q1C4 have order 2, 3 and 4; Q1CH is cubic Hermite with continuous "
                  "slope. In 3D, Q1CH needs faces in a regular grid. Quadratic cells have Q2C2, their own side, of "
                  "order 2, which Q1C1 means too there, and Q2C4, of order 4.")
          .add("Bulk Points", &InteractionSettings::bulk_points,
               "Number of Gauss points along the contact side in the enriched elements, in 3D in both directions of "
               "the face. With 0 it is the order + 1, or 5 for Q1CH in 3D.",
               between(0, 64))
          .add("Surface Points", &InteractionSettings::points,
               "Number of Gauss points per direction on each side of the surface. With 0 it is 5, or 8 for Q1C3, Q1C4, "
               "Q1CH and Q2C4. Triangles have 1, 6, 7, 12 and 16 points for 1 to 5, and from 6 on the square; in "
               "surfaces of two bodies three times, quadrilaterals beside them four times, the square of half as many "
               "per direction, rounded up.",
               between(0, most_points_on_a_side))
          .add("Cutoff", &InteractionSettings::cutoff,
               "Gap beyond which the interaction is neglected [L0]. The error of the traction is at most the traction "
               "at this gap. 0: no cutoff.",
               at_least(0))
          .add("Step Margin", &InteractionSettings::margin,
               "Factor kappa that limits a Newton step: it keeps every gap r at least kappa min(r, equilibrium gap) "
               "[-].",
               greater_and_less_than(0, 1))
          .add("Factor", &InteractionSettings::factor_text,
               "Expression in x, y and z, the place of the undeformed surface in L0: factor of the law's energy and "
               "traction there, at least 0. Gaps do not change. Where it is 0 the law does not repel either. Empty: 1.")
          .add(
              "Factor Field", &InteractionSettings::factor_field,
              "Name of a nodal field of the mesh's Exodus file, whose values at the file's last time are a factor like "
              "Factor, linear (bilinear) between the corners of the sides of the file's cells. If both are given, they "
              "multiply. Empty: "
              "1.")
          .sublist("Motion", &InteractionSettings::motion, motion_options(),
                   "Motion of the obstacle as a rigid body. Its parameters describe it before the motion. If all "
                   "entries are empty, it rests.")
          .add("Rigid Body", &InteractionSettings::rigid_body,
               "Name of a list of Rigid Bodies, to which the obstacle belongs: it moves with that body, and the "
               "surface's "
               "forces act on it. The obstacle's parameters describe it before the motion. Empty: none.")
          .sublist("Friction", &InteractionSettings::friction, friction_options(),
                   "Resistance to slip along the obstacle or the other body, scaled by Factor; axisymmetric: in the "
                   "meridional plane.");
  return all;
}

/// Returns the expression as a function of the place; null for an empty text.
std::function<double(const std::array<double, 3>&)> factor_of(const std::string& text) {
  if (text.empty()) return nullptr;
  const std::vector<std::string> names = {"x", "y", "z"};
  const auto expression = std::make_shared<const Expression>("factor", text, names);
  return [expression](const std::array<double, 3>& x) { return expression->at({x[0], x[1], x[2]}); };
}

/// Returns values by local node of values by node of the whole mesh, 0 at nodes that it did not have.
std::vector<double> local_values(const std::vector<double>& values, const LocalMesh& mesh) {
  std::vector<double> local;
  if (values.empty()) return local;
  for (const int node : mesh.original_ids) {
    const auto place = static_cast<std::size_t>(node);
    local.push_back(place < values.size() ? values[place] : 0.0);
  }
  return local;
}

void add_interaction(const SceneInteraction& interaction, const SceneNode& bodies, const Histories& histories,
                     double initial_time, Model& model) {
  const SceneNode& node = interaction.node;
  at(node.path_of("Side Set"), [&] { return model.mesh().side_set(interaction.side_set); });
  const auto complete = [&](SurfaceForces& forces) {
    forces.name = node.name();
    forces.nodal_factor = local_values(interaction.field_values, model.mesh());
  };
  if (interaction.is_pair()) {
    SurfacePair pair = interaction;
    complete(pair);
    return at(node.path(), [&] { add_pair(model, pair); });
  }
  SurfaceInteraction wall{interaction, {}, {}, initial_time};
  complete(wall);
  wall.obstacle = obstacles().make(node, static_cast<std::size_t>(model.mesh().dimension));
  wall.rigid_body = interaction.rigid_body;
  const int d = model.mesh().dimension;
  wall.motion = rigid_motion(node.sublist("Motion"), interaction.motion, histories, d);
  if (const auto whole = prescribed_motion(bodies, wall.rigid_body, histories, d, model.mesh().axisymmetric)) {
    wall.motion = whole;
    wall.rigid_body.clear();
  }
  if (!wall.rigid_body.empty()) at(node.path_of("Rigid Body"), [&] { model.rigid_bodies().find(wall.rigid_body); });
  at(node.path(), [&] { ixos::add_interaction(model, wall); });
}

/// Refuses what the model would refuse, with the place.
void check(const SceneInteraction& own) {
  SurfacePair forces = own;
  if (!own.factor_field.empty()) forces.nodal_factor = {1};  // its file is read later; that there is a factor counts
  if (const auto refusal = own.is_pair() ? refusal_of(forces) : refusal_of_forces(forces))
    own.node.refuse_value(refusal->setting, refusal->value, refusal->why);
  if (own.is_pair() && !own.motion.histories().empty())
    own.node.refuse("Motion", "moves an obstacle, and an interaction with a Primary Side Set has none; leave it empty");
  if (own.is_pair() && !own.rigid_body.empty())
    own.node.refuse("Rigid Body",
                    "carries an obstacle, and an interaction with a Primary Side Set has none; leave it empty");
  if (!own.rigid_body.empty() && !own.motion.histories().empty())
    own.node.refuse("Motion",
                    "moves an obstacle that belongs to a Rigid Body, which moves it; leave one of them empty");
  if (own.friction.type != FrictionType::None)
    at(own.node.path_of("Friction/Type"), [&] { FrictionLaw(own.friction, own.law); });
}

}  // namespace

void declare_interaction(Teuchos::ParameterList& list) {
  laws().declare(list);
  options().declare(list);
  obstacles().declare(list);
}

InteractionSettings::InteractionSettings() { side_set = required; }

std::vector<SceneInteraction> read_interactions(const SceneNode& interactions) {
  std::vector<SceneInteraction> result;
  for (const SceneNode& node : interactions.sublists()) {
    InteractionSettings settings = options().read(node);
    settings.law = laws().make(node);
    settings.factor = at(node.path_of("Factor"), [&] { return factor_of(settings.factor_text); });
    result.emplace_back(settings, node);
    check(result.back());
  }
  return result;
}

void read_factor_fields(std::vector<SceneInteraction>& interactions, const Teuchos::ParameterList& list,
                        const Mesh& mesh) {
  const auto nodes = static_cast<std::size_t>(mesh.linear_nodes < 0 ? mesh.nodes() : mesh.linear_nodes);
  std::map<std::string, std::vector<double>> fields;  // each is read once
  for (SceneInteraction& own : interactions) {
    const std::string& field = own.factor_field;
    if (field.empty()) continue;
    const auto type = list.get<std::string>("Type");
    if (type != exodus_format)
      own.node.refuse("Factor Field",
                      fmt::format("\"{}\" is a field of an Exodus file, but Mesh/Type is {}; choose {}, "
                                  "or an expression as Factor",
                                  field, type, exodus_format));
    const auto [found, is_new] = fields.insert({field, {}});
    if (is_new)
      found->second = at(own.node.path_of("Factor Field"), [&] {
        return read_exodus_field(list.sublist(exodus_format).get<std::string>("File"), field);
      });
    own.field_values = found->second;
    if (own.field_values.size() != nodes) own.node.refuse("Factor Field", "the mesh file changed while it was read");
  }
}

std::vector<double> nodal_factors(const std::vector<SceneInteraction>& interactions) {
  std::vector<double> all;
  for (const SceneInteraction& own : interactions)
    all.insert(all.end(), own.field_values.begin(), own.field_values.end());
  return all;
}

std::vector<std::string> whole_side_sets(const std::vector<SceneInteraction>& interactions) {
  std::set<std::string> names;
  for (const SceneInteraction& own : interactions)
    if (own.is_pair()) names.insert({own.side_set, own.primary});
  return {names.begin(), names.end()};
}

FacingNodes facing_nodes(const std::vector<SceneInteraction>& interactions, const Mesh& mesh) {
  FacingNodes all;
  for (const SceneInteraction& own : interactions) {
    if (!own.is_pair() || own.primary == own.side_set) continue;
    const double range = own.cutoff > 0 ? own.cutoff : own.law->range();
    const FacingNodes near =
        facing_nodes(mesh, own.side_set, own.primary, std::min(range, 20 * own.law->equilibrium_gap()));
    all.pairs.insert(all.pairs.end(), near.pairs.begin(), near.pairs.end());
    all.sides.insert(all.sides.end(), near.sides.begin(), near.sides.end());
  }
  return all;
}

const std::string& name_of(ContactElement element) {
  for (const auto& [name, value] : contact_elements())
    if (value == element) return name;
  throw std::logic_error("a contact element without a name");
}

void enrich_surfaces(std::vector<SceneInteraction>& interactions, Mesh& mesh) {
  std::map<std::string, const SceneInteraction*> known;
  for (SceneInteraction& own : interactions) {
    const SideSet& set =
        at(own.node.path_of("Side Set"), [&]() -> const SideSet& { return side_set_named(mesh, own.side_set); });
    own.element = at(own.node.path_of("Contact Element"), [&] { return fitting_element(mesh, set, own.element); });
    if (own.is_pair()) {
      at(own.node.path_of("Primary Side Set"), [&] { return &side_set_named(mesh, own.primary); });
      if (own.element == ContactElement::Q1CH)
        own.node.refuse("Contact Element",
                        "\"Q1CH\" is not there for surfaces of two bodies yet; use \"Q1C1\", \"Q1C2\", \"Q1C3\" or "
                        "\"Q1C4\", for quadratic cells \"Q2C2\" or \"Q2C4\"");
    }
    if (own.element == ContactElement::Q2C2 && own.bulk_points > 0)
      own.node.refuse("Bulk Points", fmt::format("{} has no effect on Q2C2, the side of quadratic cells as it is; "
                                                 "use 0 and the material's Quadrature Points, or Q2C4",
                                                 own.bulk_points));
    const auto [before, added] = known.insert({own.side_set, &own});
    if (!added) {
      const SceneInteraction& first = *before->second;
      if (first.element != own.element || first.bulk_points != own.bulk_points)
        own.node.refuse("Contact Element",
                        fmt::format("another interaction wants {} on the side set \"{}\", or other Bulk Points",
                                    name_of(first.element), own.side_set));
      continue;
    }
    at(own.node.path_of("Contact Element"), [&] { enrich(mesh, own.side_set, own.element, own.bulk_points); });
  }
  check_cells(mesh);
}

void add_interactions(const std::vector<SceneInteraction>& interactions, const SceneNode& bodies,
                      const Histories& histories, double initial_time, Model& model) {
  for (const SceneInteraction& interaction : interactions)
    add_interaction(interaction, bodies, histories, initial_time, model);
}

}  // namespace ixos
