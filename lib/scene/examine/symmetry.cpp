#include "scene/examine/symmetry.hpp"

#include <fmt/format.h>

#include "scene/read/scene_mesh.hpp"

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

/// Returns what makes the tangent of an interaction unsymmetric for a rule.
std::string asymmetry_of(const NamedInteraction& named, const Rule& rule, const SceneNode& scene) {
  std::string interaction = "Interactions/" + named.name;
  Interaction& term = *named.term;
  if (term.has_friction())
    return !term.is_gradient(end_rule()) ? interaction + "/Friction/Threshold \"Current\""
           : term.motion() != nullptr    ? "the mean friction along the turning obstacle of " + interaction
                                         : "the mean friction between the bodies of " + interaction;
  if (term.coupling() != nullptr) return "the discrete gradient of " + interaction;
  // A discrete gradient of the gap is its exact mean.
  if (rule.mean == Mean::Points || !term.is_gradient(end_rule())) return interaction;
  const SceneNode motion = scene.sublist("Interactions").sublist(named.name).sublist("Motion");
  const char* kind = motion.text("Rotation").empty() ? "curved" : "moved";
  return fmt::format("the exact mean before the {} obstacle of {}", kind, interaction);
}

}  // namespace

std::string asymmetry(const SceneNode& scene, const std::vector<Material>& materials, const Model& model,
                      const Table& table) {
  for (const Stage& stage : table.stages) {
    for (const NamedForceTerm& named : model.force_terms()) {
      if (named.term->part() != Part::Elastic || named.term->is_gradient(stage.elastic)) continue;
      if (!stage.elastic.is_gradient()) return "the discrete gradient of the scheme \"" + table.name + "\"";
      return material_of(named.name, scene, materials, model.mesh());
    }
    for (const NamedInteraction& named : model.interactions())
      if (!named.term->is_gradient(stage.interaction)) return asymmetry_of(named, stage.interaction, scene);
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
  for (const SceneNode& node : scene.sublist("Grips").sublists())
    if (!node.text("Rigid Body").empty()) return node.path_of("Rigid Body");
  for (const SceneNode& node : scene.sublist("Interactions").sublists()) {
    const SceneNode friction = node.sublist("Friction");
    if (friction.text("Type") != "None" && friction.text("Threshold") == "Current")
      return friction.path_of("Threshold") + " \"Current\"";
  }
  return "";
}

}  // namespace ixos
