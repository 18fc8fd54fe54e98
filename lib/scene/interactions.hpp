/// Interactions of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>
#include <vector>

#include "interaction/gap_law.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "model/model.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// One list of "Interactions", read once.
struct SceneInteraction {
  SceneNode node;
  std::string side_set;
  ContactElement element = ContactElement::Q1C1;
  int bulk_points = 0;
  int surface_points = 0;
  double cutoff = 0;  ///< [L0]; 0: none
  double margin = 0;
  std::shared_ptr<const GapLaw> law;  ///< without the cutoff
};

/// Adds the parameters of an interaction to a valid list.
void declare_interaction(Teuchos::ParameterList& list);

/// Returns the interactions of the validated list "Interactions". Throws InputError with the list path. The list must
/// outlive the result.
std::vector<SceneInteraction> read_interactions(const SceneNode& interactions);

/// Gives the surfaces the contact elements that the interactions ask for. Throws InputError with the list path.
void enrich_surfaces(const std::vector<SceneInteraction>& interactions, Mesh& mesh);

/// Adds the interactions to the model. Throws InputError, with the list path, if one does not fit the mesh, or its
/// surface starts in or below the obstacle. Collective.
void add_interactions(const std::vector<SceneInteraction>& interactions, Model& model);

}  // namespace ixos
