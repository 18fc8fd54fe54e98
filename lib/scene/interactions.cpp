#include "scene/interactions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "interaction/catalogue.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "model/surface_interaction.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

struct Parameters {
  std::string side_set = required;
  ContactElement element = ContactElement::Q1C1;
  int bulk_points = 0, surface_points = 0;
  double cutoff = 0, margin = 0.8;
};

const Options<Parameters>& options() {
  static const Options<Parameters> all =
      Options<Parameters>()
          .add("Side Set", &Parameters::side_set, "Side set of the surface that interacts.")
          .choose("Contact Element", &Parameters::element,
                  {{"Q1C1", ContactElement::Q1C1},
                   {"Q1C2", ContactElement::Q1C2},
                   {"Q1C3", ContactElement::Q1C3},
                   {"Q1C4", ContactElement::Q1C4},
                   {"Q1CH", ContactElement::Q1CH}},
                  "Interpolation of the displacement along the contact side, in 3D in both directions of the face. "
                  "Q1C1 is linear; Q1C2, Q1C3 and Q1C4 have order 2, 3 and 4; Q1CH is cubic Hermite with continuous "
                  "slope. In 3D, Q1CH needs faces in a regular grid.")
          .add("Bulk Points", &Parameters::bulk_points,
               "Number of Gauss points along the contact side in the enriched elements, in 3D in both directions of "
               "the face. With 0 it is the order + 1, or 5 for Q1CH in 3D.",
               between(0, 64))
          .add("Surface Points", &Parameters::surface_points,
               "Number of Gauss points per direction on each side of the surface. With 0 it is 5, or 8 for Q1C3, Q1C4 "
               "and Q1CH.",
               between(0, 64))
          .add("Cutoff", &Parameters::cutoff,
               "Gap beyond which the interaction is neglected [L0]. The error of the traction is at most the traction "
               "at this gap. 0: no cutoff.",
               at_least(0))
          .add("Step Margin", &Parameters::margin,
               "Factor kappa that limits a Newton step: it keeps every gap r at least kappa min(r, equilibrium gap) "
               "[-].",
               greater_and_less_than(0, 1));
  return all;
}

void add_interaction(const SceneInteraction& interaction, Model& model) {
  const SceneNode& node = interaction.node;
  at(node.path_of("Side Set"), [&] { return model.mesh().side_set(interaction.side_set); });
  at(node.path_of("Cutoff"), [&] { check_cutoff(*interaction.law, interaction.cutoff); });
  const auto obstacle = obstacles().make(node, static_cast<std::size_t>(model.mesh().dimension));
  at(node.path(), [&] {
    ixos::add_interaction(model, {interaction.side_set, interaction.law, obstacle, interaction.cutoff,
                                  interaction.surface_points, interaction.margin, node.name()});
  });
}

}  // namespace

void declare_interaction(Teuchos::ParameterList& list) {
  laws().declare(list);
  options().declare(list);
  obstacles().declare(list);
}

std::vector<SceneInteraction> read_interactions(const SceneNode& interactions) {
  std::vector<SceneInteraction> result;
  for (const SceneNode& node : interactions.sublists()) {
    const Parameters p = options().read(node);
    result.push_back(
        {node, p.side_set, p.element, p.bulk_points, p.surface_points, p.cutoff, p.margin, laws().make(node)});
  }
  return result;
}

void enrich_surfaces(const std::vector<SceneInteraction>& interactions, Mesh& mesh) {
  std::map<std::string, const SceneInteraction*> known;
  for (const SceneInteraction& own : interactions) {
    const auto [before, added] = known.insert({own.side_set, &own});
    if (!added) {
      const SceneInteraction& first = *before->second;
      if (first.element != own.element || first.bulk_points != own.bulk_points)
        own.node.refuse("Contact Element",
                        fmt::format("another interaction wants {} on the side set \"{}\", or other Bulk Points",
                                    first.node.text("Contact Element"), own.side_set));
      continue;
    }
    at(own.node.path_of("Side Set"), [&] { return side_set_named(mesh, own.side_set); });
    at(own.node.path_of("Contact Element"), [&] { enrich(mesh, own.side_set, own.element, own.bulk_points); });
  }
  check_cells(mesh);
}

void add_interactions(const std::vector<SceneInteraction>& interactions, Model& model) {
  for (const SceneInteraction& interaction : interactions) add_interaction(interaction, model);
}

}  // namespace ixos
