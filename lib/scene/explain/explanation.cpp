#include "scene/explain/explanation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/pack.hpp"
#include "fem/cell_info.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "material/elastic_law.hpp"
#include "model/surface_interaction.hpp"
#include "parameters/parameter_entries.hpp"
#include "scene/explain/left_out.hpp"
#include "scene/explain/si_explanation.hpp"
#include "scene/output/output_fields.hpp"
#include "scene/read/friction.hpp"
#include "scene/read/grips.hpp"
#include "scene/read/mesh_parts.hpp"
#include "scene/read/rigid_bodies.hpp"
#include "scene/read/scene_units.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

std::string megabytes(double bytes) { return fmt::format("{:.3g} MB", bytes / 1e6); }

/// Returns a line on the branches of a material; empty if it has none.
std::string branches_in_words(const Material& material) {
  if (material.branches.empty()) return "";
  double sum = 0, shortest = material.branches[0].time, longest = shortest;
  for (const MaxwellBranch& branch : material.branches) {
    sum += branch.modulus;
    shortest = std::min(shortest, branch.time);
    longest = std::max(longest, branch.time);
  }
  const double mu = material.law->lame().mu;
  return fmt::format(
      "  {} Maxwell branch(es), relaxation times {:.6g} to {:.6g} T0: shear modulus {:.6g} E0 in fast changes, {:.6g} "
      "E0 in slow ones; history by {}\n",
      material.branches.size(), shortest, longest, mu + sum, mu,
      material.history_update == HistoryUpdate::BackwardEuler ? "backward Euler" : "the midpoint");
}

/// Returns the types of the cells and their numbers if others than quadrilaterals and hexahedra are among them.
std::string cell_types(const LocalMesh& mesh) {
  std::map<CellType, long long> counts;
  for (const LocalBlock& block : mesh.blocks)
    if (block.global_cells > 0) counts[block.type] += block.global_cells;
  if (std::all_of(counts.begin(), counts.end(), [](const auto& own) { return is_cube(own.first); })) return "";
  std::vector<std::string> words;
  bool bubbles = false;
  for (const auto& [type, count] : counts) {
    words.push_back(fmt::format("{} {}", count, cell_info(type).name));
    bubbles = bubbles || cell_info(type).bubbles;
  }
  return fmt::format(
      "Cells: {}{}\n", fmt::join(words, ", "),
      bubbles ? " (with nodes in triangles and insides, for Mean Dilatation or for explicit steps)" : "");
}

/// Returns a line for each list that splits cells or ties sides.
std::string refinements_and_ties(const SceneNode& mesh) {
  std::string text;
  for (const SceneNode& own : mesh.sublist("Refine").sublists())
    text +=
        fmt::format("Refine {}: {} level{}\n", own.name(), own.count("Levels"), own.count("Levels") == 1 ? "" : "s");
  if (const SceneNode adapt = mesh.sublist("Adapt"); adapt.count("Levels") > 0)
    text += fmt::format(
        "Adapt: up to {} levels, until the traction changes by at most {} of the law's strength over a face{}\n",
        adapt.count("Levels"), adapt.number("Part"),
        adapt.number("Strain") > 0 ? fmt::format(", and the gradient by {} at a cell", adapt.number("Strain")) : "");
  for (const auto& [list, what] : {std::pair("Ties", "Tie"), std::pair("Periodic", "Periodic sides")})
    for (const SceneNode& own : mesh.sublist(list).sublists())
      text += fmt::format("{} {}: the nodes of side set \"{}\" follow side set \"{}\"\n", what, own.name(),
                          own.text("Side Set"), own.text("Primary Side Set"));
  return text;
}

std::string bodies(const Simulation& simulation) {
  const LocalMesh& mesh = simulation.model().mesh();
  std::string text =
      fmt::format("Mesh: {} dimensions{}, {} nodes{}, {} cells, {} degrees of freedom, {} rank(s)\n", mesh.dimension,
                  mesh.axisymmetric     ? " (axisymmetric)"
                  : mesh.dimension == 2 ? " (plane strain)"
                                        : "",
                  mesh.global_nodes + mesh.global_tied,
                  mesh.global_tied > 0 ? fmt::format(" ({} of them tied to others)", mesh.global_tied) : "",
                  mesh.global_cells, simulation.model().space().global(), simulation.model().space().comm()->getSize());
  text += cell_types(mesh);
  const std::vector<SceneNode> parts = part_lists(SceneNode(simulation.parameters().sublist("Mesh"), "Mesh"));
  for (std::size_t k = 0; k < parts.size() && parts[k].path() != "Mesh"; ++k)
    text += fmt::format("{}{} ({}){}", k == 0 ? "Parts: " : "", parts[k].name(), parts[k].text("Type"),
                        k + 1 == parts.size() ? "\n" : ", ");
  text += refinements_and_ties(SceneNode(simulation.parameters().sublist("Mesh"), "Mesh"));
  if (!simulation.set_sizes().empty()) text += "Sets:\n";
  for (const SetSize& size : simulation.set_sizes())
    text += fmt::format("  {}\n", in_words(size, mesh.body_dimension()));
  const List& materials = simulation.parameters().sublist("Materials");
  std::size_t number = 0;
  for (const SceneNode& node : SceneNode(materials, "Materials").sublists()) {
    const Material& material = simulation.materials()[number++];
    const Lame lame = material.law->lame();
    text += fmt::format(
        "Material {}: block \"{}\", {}, {} elements, E = {:.6g} E0, nu = {:.6g}, density {}{}{}\n", node.name(),
        material.block, node.text("Model"), node.text("Element Formulation"), youngs_modulus(lame),
        poissons_ratio(lame), material.density,
        simulation.model().damping() == nullptr
            ? ""
            : fmt::format(", damping {} M + {} K", material.mass_damping, material.stiffness_damping),
        material.viscosity == 0 ? "" : fmt::format(", viscosity {} T0 times the moduli", material.viscosity));
    text += branches_in_words(material);
  }
  return text;
}

/// Friction has the threshold of the law that acts before the obstacle.
std::string friction_of(const SceneInteraction& interaction, const LocalMesh& mesh) {
  const auto obstacle = obstacles().make(interaction.node, static_cast<std::size_t>(mesh.dimension));
  return friction_in_words(interaction.friction,
                           law_before(*obstacle, interaction.law, interaction.cutoff, mesh.body_dimension()));
}

/// Returns how many pairs of points a double integral has.
std::string double_integral_in_words(const SceneInteraction& own, const LocalMesh& mesh) {
  const auto points_of = [&](const std::string& set) {
    const auto whole = mesh.whole_side_sets.find(set);
    const std::vector<LocalSide>& sides =
        whole != mesh.whole_side_sets.end() ? whole->second : mesh.side_sets[mesh.side_set(set)];
    return static_cast<double>(number_of_patches(mesh, sides)) *
           std::pow(points_on_a_patch(own.points, has_triangles(mesh, sides)), mesh.dimension - 1);
  };
  const double first = points_of(own.side_set), second = points_of(own.primary);
  return fmt::format(
      "  Double integral of {:.0f} by {:.0f} points, {:.3g} pairs at each point in time; the matrix is dense\n", first,
      second, first * second);
}

std::string surroundings(const Simulation& simulation) {
  std::string text;
  for (const SceneInteraction& interaction : simulation.interactions()) {
    const SceneNode& node = interaction.node;
    const std::string other = interaction.is_pair()
                                  ? "the side set \"" + interaction.primary + "\" of another body, smoothing " +
                                        node.text("Smoothing") +
                                        (interaction.passes == Passes::One ? "" : ", passes " + node.text("Passes"))
                                  : "a " + node.text("Obstacle");
    text += fmt::format(
        "Interaction {}: {} between side set \"{}\" and {}, {} contact elements, {} Gauss points per direction\n",
        node.name(), node.text("Law"), interaction.side_set, other, name_of(interaction.element),
        interaction.points > 0 ? std::to_string(interaction.points) : "the element's default number of");
    if (interaction.is_pair() && interaction.passes == Passes::DoubleIntegral)
      text += double_integral_in_words(interaction, simulation.model().mesh());
    if (!interaction.factor_field.empty())
      text += fmt::format("  Factor: the nodal field \"{}\" of the mesh file\n", interaction.factor_field);
    if (!interaction.motion.histories().empty())
      text += fmt::format("  The obstacle is {}; its work is part of external_work\n", interaction.motion.in_words());
    if (!interaction.rigid_body.empty())
      text += fmt::format("  The obstacle belongs to the rigid body {}, and its forces act on that\n",
                          interaction.rigid_body);
    if (interaction.friction.type != FrictionType::None) text += friction_of(interaction, simulation.model().mesh());
    if (interaction.cutoff > 0) {
      const GapLaw& law = *interaction.law;
      const double work = work_of_adhesion(law);
      if (work == 0) continue;
      const double lost = std::abs(law.traction(interaction.cutoff)[0]);
      text += fmt::format(
          "  Cutoff at a gap of {} L0: the error of the traction is at most {:.3g} E0, {:.2g} of the largest "
          "attraction; the relative error of the work of adhesion is {:.2g}\n",
          interaction.cutoff, lost, std::abs(lost / law.traction(law.adhesion_gap())[0]),
          1 - work_of_adhesion(*law.cut_off(interaction.cutoff)) / work);
    }
  }
  if (has_interaction_columns(simulation.output(), simulation.interactions().size()))
    text += "Force, moment, contact measure and least gap of each interaction are columns of history.csv\n";
  text += grips_in_words(SceneNode(simulation.parameters(), "").sublist("Grips"));
  text += rigid_bodies_in_words(simulation.model().rigid_bodies(), simulation.model().mesh().dimension);
  const List& conditions = simulation.parameters().sublist("Boundary Conditions");
  for (const auto& [name, entry] : entries(conditions)) {
    const List& list = conditions.sublist(name);
    const auto type = list.get<std::string>("Type");
    const auto history = list.get<std::string>("History");
    if (type == "Displacement")
      text += fmt::format("Boundary condition {}: node set \"{}\", components {}, {}\n", name,
                          list.get<std::string>("Node Set"), list.get<std::string>("Components"),
                          history.empty() ? "held" : "driven by history " + history);
    else if (type == "Symmetry")
      text += fmt::format("Boundary condition {}: the plane of node set \"{}\" is one of symmetry\n", name,
                          list.get<std::string>("Node Set"));
    else
      text += fmt::format("Boundary condition {}: {}, {}\n", name, type,
                          history.empty() ? "constant" : "driven by history " + history);
  }
  return text;
}

std::string solution(const Simulation& simulation) {
  const Scheme& chosen = scheme(simulation.time_integrator().scheme);
  const List& linear = simulation.parameters().sublist("Linear Solver");
  const StepControlOptions& control = simulation.step_control();
  const std::string steps =
      control.adaptive.on
          ? fmt::format("adaptive steps, the first of {} T0", control.time_step)
          : fmt::format("about {:.0f} steps of {} T0", (control.final_time - control.initial_time) / control.time_step,
                        control.time_step);
  return fmt::format(
      "Scheme: {}, order {}; conserves {}\nTime: from {} to {} T0 in {}\n"
      "Newton: NOX, tolerance {}; linear solver {}\n",
      chosen.name, chosen.order, chosen.conserves, control.initial_time, control.final_time, steps,
      simulation.newton().tolerance, linear_solver_in_words(linear));
}

/// Returns a line for each stage.
std::string stages_in_words(const Simulation& simulation) {
  const Stages& stages = simulation.stages();
  if (!stages.any()) return "";
  std::string text = "Stages:\n";
  const std::vector<double> ends = stages.planned_ends();
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const List scene = complete_scene(stages.scene({ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(k)}));
    const List& integrator = scene.sublist("Time Integrator");
    text +=
        fmt::format("  {}: {}, to {:.6g} T0 in steps of {} T0{}\n", stages.name(k), integrator.get<std::string>("Type"),
                    ends[k], integrator.sublist("Time Step Control").get<double>("Time Step"),
                    integrator.sublist("Stop").numParams() > 0 ? ", unless a criterion ends it" : "");
  }
  return text;
}

std::string memory(const Simulation& simulation) {
  const Model& model = simulation.model();
  const double d = model.mesh().dimension;
  const double pairs = model.pattern().pairs();
  const List& linear = simulation.parameters().sublist("Linear Solver");
  const auto preconditioner = linear.get<std::string>("Preconditioner Type");
  const bool needs_matrix = linear.get<std::string>("Operator") != "Matrix-Free" ||
                            (!preconditions_without_matrix(preconditioner) && preconditioner != "None");
  const double matrices = needs_matrix ? static_cast<double>(simulation.integrator().tangents()) : 0;
  double bytes = 0;  // quadratic cells, too, have as many points as nodes
  for (const LocalBlock& block : model.mesh().blocks) {
    const double nodes = nodes_per_cell(plain_type(block.type));
    bytes += block.cells() * (8 * nodes * (d * d + 1) + 4 * nodes * (nodes + 2));
  }
  return fmt::format(
      "Memory on this rank, without factorisations: tangent matrices ({}) {}, mass matrix {}, element "
      "geometry and offsets {}\n",
      matrices, megabytes(matrices * pairs * d * d * 12), megabytes(model.mass() == nullptr ? 0 : pairs * 8),
      megabytes(bytes));
}

std::string frames(const Simulation& simulation) {
  const OutputOptions& output = simulation.output();
  if (!output.has_frames()) return "";
  std::string text;
  for (const bool nodal : {true, false}) {
    std::string names;
    for (const OutputField& field : chosen_fields(output.fields, simulation.model()))
      if ((field.nodal != nullptr) == nodal)
        names += fmt::format("{}{} [{}]", names.empty() ? "" : ", ", field.name,
                             unit_in(simulation.model().mesh().body_dimension(), field.unit));
    if (!names.empty()) text += fmt::format("Fields of {}: {}\n", nodal ? "nodes" : "cells", names);
  }
  return text;
}

std::string notes(const Simulation& simulation) {
  std::string text;
  for (const std::string& hint : simulation.hints()) text += "Note: " + hint + "\n";
  return text;
}

}  // namespace

std::string explain(const Simulation& simulation) {
  return bodies(simulation) + surroundings(simulation) + solution(simulation) + stages_in_words(simulation) +
         memory(simulation) + frames(simulation) + notes(simulation) + left_out(simulation) +
         explain_numbers(simulation);
}

}  // namespace ixos
