#include "scene/symmetry.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// Returns the list of the block's material.
std::string material_of(const std::string& block, const SceneNode& scene, const std::vector<Material>& materials,
                        const LocalMesh& mesh) {
  const std::vector<SceneNode> nodes = scene.sublist("Materials").sublists();
  for (std::size_t i = 0; i < materials.size(); ++i)
    for (const std::size_t b : mesh.blocks_named(materials[i].block))
      if (mesh.blocks[b].name == block) return nodes[i].path();
  return "the material of the block \"" + block + "\"";
}

/// Returns a text of a free-form list; empty if the list has no such text.
std::string text_of(const List& list, const std::string& name) {
  return list.isType<std::string>(name) ? list.get<std::string>(name) : "";
}

/// Returns "Solver Type" in "Linear Solver Types/<type>".
std::string solver_type(const List& linear, const std::string& type) {
  const std::string lists = "Linear Solver Types";
  if (!linear.isSublist(lists) || !linear.sublist(lists).isSublist(type)) return "";
  return text_of(linear.sublist(lists).sublist(type), "Solver Type");
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

void check_linear_solver(const SceneNode& scene, const std::vector<Material>& materials, const std::string& asymmetry) {
  const SceneNode solver = scene.sublist("Linear Solver");
  const List& list = solver.list();
  const bool matrix_free = text_of(list, "Operator") == "Matrix-Free";
  if (matrix_free && !asymmetry.empty())
    solver.refuse("Operator", "\"Matrix-Free\" needs a symmetric tangent; because of " + asymmetry +
                                  ", the tangent is not symmetric; use \"Assembled\"");
  const std::vector<SceneNode> nodes = scene.sublist("Materials").sublists();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (matrix_free && materials[i].viscosity != 0)
      solver.refuse("Operator",
                    "\"Matrix-Free\" is not offered for " + nodes[i].path_of("Viscosity") + "; use \"Assembled\"");
    if (!matrix_free || has_action(*materials[i].law, materials[i].formulation)) continue;
    const char* entry = has_action(*materials[i].law, Formulation::Standard) ? "Element Formulation" : "Model";
    solver.refuse("Operator", "\"Matrix-Free\" is not offered for " + nodes[i].path_of(entry) + " \"" +
                                  nodes[i].text(entry) + "\"; use \"Assembled\"");
  }
  if (asymmetry.empty()) return;
  const auto refuse = [&](const std::string& entry, const std::string& value, const std::string& instead) {
    solver.refuse(entry, "\"" + value + "\" needs a symmetric matrix; because of " + asymmetry +
                             ", the tangent is not symmetric; use " + instead);
  };
  struct Symmetric {
    std::string type;
    std::vector<std::string> solvers;
    std::string instead;
  };
  static const std::vector<Symmetric> all{
      {"Direct", {"CHOLMOD", "MUMPS"}, "\"KLU\""},
      {"Belos",
       {"Block CG", "Pseudo Block CG", "Pseudo Block Stochastic CG", "CG", "RCG", "PCPG", "MINRES"},
       "\"Pseudo Block GMRES\""},
      {"Amesos2", {"CHOLMOD"}, "\"KLU2\""}};
  const std::string chosen = text_of(list, "Linear Solver Type");
  for (const Symmetric& symmetric : all) {
    const bool automatic = chosen.empty() || chosen == "Automatic";
    const std::string asked = solver_type(list, symmetric.type);
    if ((automatic || chosen == symmetric.type) &&
        std::find(symmetric.solvers.begin(), symmetric.solvers.end(), asked) != symmetric.solvers.end())
      refuse("Linear Solver Types/" + symmetric.type + "/Solver Type", asked, symmetric.instead);
  }
  if (text_of(list, "Preconditioner Type") == "Chebyshev")
    refuse("Preconditioner Type", "Chebyshev", "\"MueLu\", \"Ifpack2\" or \"Direct\"");
}

}  // namespace ixos
