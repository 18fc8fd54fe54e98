#include "scene/scene_facts.hpp"

#include <algorithm>

#include "mesh/layers.hpp"

namespace ixos {
namespace {

int order_of(ContactElement element) {
  if (element == ContactElement::Q1C2) return 2;
  if (element == ContactElement::Q1C4) return 4;
  return element == ContactElement::Q1C1 ? 1 : 3;
}

/// Returns the attraction at a gap; 0 in repulsion and beyond the cutoff.
double attraction(const SceneInteraction& interaction, double gap) {
  if (interaction.cutoff > 0 && gap >= interaction.cutoff) return 0;
  return std::max(0.0, -static_cast<double>(interaction.law->traction(Pack(gap))[0]));
}

}  // namespace

SceneFacts scene_facts(const SceneNode& scene, CharacteristicNumbers numbers, const std::vector<Material>& materials,
                       const std::vector<SceneInteraction>& interactions, const Mesh& mesh,
                       const std::vector<int>& parts, const Histories& histories, const StepControlOptions& control,
                       Inertia inertia) {
  SceneFacts facts;
  const Driving driving(scene, histories, control, mesh, parts);
  facts.motions = driving.motions();
  facts.loaded = driving.has_loads();
  facts.moves = driving.moves();
  for (const SurfaceNumbers& surface : numbers.surfaces) {
    const SceneInteraction& interaction = interactions[surface.interaction];
    SurfaceFacts own;
    own.order = order_of(interaction.element);
    own.peak_gap = interaction.law->adhesion_gap();
    own.drive = driving.of_part(surface.part, surface.normal);
    own.attraction = attraction(interaction, std::max(surface.least_gap - own.drive.approach, own.peak_gap));
    const Material& material = materials[numbers.bodies[surface.body].material];
    // Enriched cells stay Standard.
    if (material.formulation != Formulation::Enhanced || own.order > 1) {
      const SingleLayer layer = single_layer(mesh, mesh.side_sets[surface.side_set]);
      own.single_layer = layer.share;
      own.layer_thickness = layer.thickness;
    }
    facts.surfaces.push_back(std::move(own));
  }
  facts.numbers = std::move(numbers);
  facts.has_inertia = inertia != Inertia::None;
  // Explicit schemes divide the step until it is stable.
  facts.step = control.adaptive.on || inertia == Inertia::Lumped ? 0 : control.time_step;
  facts.duration = control.final_time - control.initial_time;
  return facts;
}

}  // namespace ixos
