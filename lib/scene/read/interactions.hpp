/// Interactions of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/facing_nodes.hpp"
#include "model/model.hpp"
#include "model/surface_pair.hpp"
#include "parameters/scene_node.hpp"
#include "scene/read/motions.hpp"

namespace ixos {

/// The settings of a list of "Interactions". Without a primary surface the interaction is that with an obstacle, and
/// settings of pairs do not count.
struct InteractionSettings : SurfacePair {
  InteractionSettings();

  ContactElement element = ContactElement::Q1C1;
  int bulk_points = 0;
  std::string factor_text{};   ///< expression of the factor; empty: none
  std::string factor_field{};  ///< nodal field of the mesh file; empty: none
  MotionOptions motion{};      ///< of the obstacle
  std::string rigid_body{};    ///< to which the obstacle belongs; empty: none

  /// Returns whether the obstacle moves, by histories or with a rigid body.
  bool moves() const { return !motion.histories().empty() || !rigid_body.empty(); }
};

/// One list of "Interactions", read once. The factor's values at nodes are not in SurfaceForces::nodal_factor, which
/// belongs to a model's mesh.
struct SceneInteraction : InteractionSettings {
  SceneInteraction(const InteractionSettings& settings, const SceneNode& own)
      : InteractionSettings(settings), node(own) {}

  SceneNode node;
  std::vector<double> field_values{};  ///< of the factor field by node of the Mesh before enrich_surfaces(); empty: 1

  bool is_pair() const { return !primary.empty(); }
};

/// Adds the parameters of an interaction to a valid list.
void declare_interaction(Teuchos::ParameterList& list);

/// Returns the interactions of the validated list "Interactions". Throws InputError with the list path. The list must
/// outlive the result.
std::vector<SceneInteraction> read_interactions(const SceneNode& interactions);

/// Reads the factor fields of the interactions, if any, from the Exodus file of the validated list "Mesh"; `mesh` is
/// its mesh, perhaps of raised order. Throws InputError with the list path.
void read_factor_fields(std::vector<SceneInteraction>& interactions, const Teuchos::ParameterList& list,
                        const Mesh& mesh);

/// Returns the factors that were read, one after the other.
std::vector<double> nodal_factors(const std::vector<SceneInteraction>& interactions);

/// Returns the side sets of which each rank needs all sides: those of two bodies' interactions.
std::vector<std::string> whole_side_sets(const std::vector<SceneInteraction>& interactions);

/// Returns the sides of two bodies that face each other within the reach of their interactions, a side once for each of
/// its interactions. A surface that interacts with itself has none.
FacingNodes facing_nodes(const std::vector<SceneInteraction>& interactions, const Mesh& mesh);

/// Returns the name of a contact element in scenes.
const std::string& name_of(ContactElement element);

/// Gives the surfaces the contact elements that the interactions ask for, and each interaction the one that it has:
/// fitting_element(). Throws InputError with the list path.
void enrich_surfaces(std::vector<SceneInteraction>& interactions, Mesh& mesh);

/// Adds the interactions to the model. `bodies`: the list "Rigid Bodies". Throws InputError, with the list path, if one
/// does not fit the mesh, or its surface is in or below the obstacle at the initial time. Collective.
void add_interactions(const std::vector<SceneInteraction>& interactions, const SceneNode& bodies,
                      const Histories& histories, double initial_time, Model& model);

}  // namespace ixos
