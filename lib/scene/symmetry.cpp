#include "scene/symmetry.hpp"

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
      const std::string interaction = "Interactions/" + named.name;
      const bool curved = rule.mean != Mean::Points && named.term->is_gradient(end_rule());
      return curved ? "the exact mean before the curved obstacle of " + interaction : interaction;
    }
  return "";
}

std::string matrix_only(const SceneNode& scene, const std::vector<Material>& materials) {
  const std::vector<SceneNode> nodes = scene.sublist("Materials").sublists();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (materials[i].viscosity != 0) return nodes[i].path_of("Viscosity");
    if (has_action(*materials[i].law, materials[i].formulation)) continue;
    const char* entry = has_action(*materials[i].law, Formulation::Standard) ? "Element Formulation" : "Model";
    return nodes[i].path_of(entry) + " \"" + nodes[i].text(entry) + "\"";
  }
  return "";
}

}  // namespace ixos
