#include "scene/symmetry.hpp"

#include <fmt/format.h>

#include "scene/scene_mesh.hpp"

namespace ixos {
namespace {

/// Returns the list of the block's material.
std::string material_of(const std::string& block, const SceneNode& scene, const std::vector<Material>& materials,
                        const LocalMesh& mesh) {
  const std::vector<SceneNode> nodes = scene.sublist("Materials").sublists();
  for (std::size_t i = 0; i < materials.size(); ++i)
    for (const std::size_t b : mesh.blocks_named(materials[i].block))
      if (mesh.blocks[b].name == block) return nodes[i].path();
  return "the material of the block \"" + block + "\"";
}

}  // namespace

std::string asymmetry(const SceneNode& scene, const std::vector<Material>& materials, const Model& model,
                      const Table& table) {
  for (const Stage& stage : table.stages)
    for (const NamedForceTerm& named : model.force_terms()) {
      const bool elastic = named.term->part() == Part::Elastic;
      const Rule& rule = elastic ? stage.elastic : stage.interaction;
      if (named.term->is_gradient(rule)) continue;
      if (elastic && !rule.is_gradient()) return "the discrete gradient of the scheme \"" + table.name + "\"";
      if (elastic) return material_of(named.name, scene, materials, model.mesh());
      // A discrete gradient of the gap is its exact mean.
      std::string interaction = "Interactions/" + named.name;
      if (const auto* own = dynamic_cast<const Interaction*>(named.term); own != nullptr && own->has_friction())
        return !own->is_gradient(end_rule()) ? interaction + "/Friction/Threshold \"Current\""
               : own->is_moved()             ? "the mean friction along the turning obstacle of " + interaction
                                             : "the mean friction between the bodies of " + interaction;
      if (const auto* own = dynamic_cast<const Interaction*>(named.term); own != nullptr && own->couples_anew())
        return "the discrete gradient of " + interaction;
      if (rule.mean == Mean::Points || !named.term->is_gradient(end_rule())) return interaction;
      const SceneNode motion = scene.sublist("Interactions").sublist(named.name).sublist("Motion");
      const char* kind = motion.text("Rotation").empty() ? "curved" : "moved";
      return fmt::format("the exact mean before the {} obstacle of {}", kind, interaction);
    }
  return "";
}

std::string matrix_only(const SceneNode& scene, const std::vector<Material>& materials, const LocalMesh& mesh) {
  if (mesh.axisymmetric) return std::string("Mesh/") + geometry_choice + " \"" + axisymmetric_geometry + "\"";
  const std::vector<SceneNode> nodes = scene.sublist("Materials").sublists();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (materials[i].viscosity != 0) return nodes[i].path_of("Viscosity");
    if (has_action(materials[i].formulation)) continue;
    return nodes[i].path_of("Element Formulation") + " \"" + nodes[i].text("Element Formulation") + "\"";
  }
  for (const SceneNode& node : scene.sublist("Interactions").sublists()) {
    const SceneNode friction = node.sublist("Friction");
    if (friction.text("Type") != "None" && friction.text("Threshold") == "Current")
      return friction.path_of("Threshold") + " \"Current\"";
  }
  return "";
}

}  // namespace ixos
