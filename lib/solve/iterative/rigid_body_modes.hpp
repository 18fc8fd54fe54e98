/// The null space and coordinates that algebraic multigrid needs from a model.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// Returns rigid translations and rotations of the reference configuration as columns (3 in 2D, 6 in 3D) on the owned
/// map, zero on constrained degrees of freedom. Rotations are about the centre of the nodes: about a distant origin
/// they would be nearly translations. Bodies that are not connected need no modes of their own: aggregates do not join
/// them, and restricted to an aggregate these modes span the motions of its body.
Teuchos::RCP<MultiVector> rigid_body_modes(const Model& model);
/// Does the same for any mesh and its degrees of freedom, of which some, by local number, are constrained.
Teuchos::RCP<MultiVector> rigid_body_modes(const LocalMesh& mesh, const DofSpace& space,
                                           const std::vector<int>& constrained);

/// Returns the coordinates of owned nodes, one column an axis, on the node map [L0].
Teuchos::RCP<MultiVector> node_coordinates(const Model& model);
Teuchos::RCP<MultiVector> node_coordinates(const LocalMesh& mesh, const Comm& comm);

}  // namespace ixos
