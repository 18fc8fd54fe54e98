/// Sets of a mesh that a scene selects by place.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Adds the parameters of a set to a valid list.
void declare_set(Teuchos::ParameterList& list);

/// Returns the names with a "*" that lists give for sets, of all lists within the list.
std::vector<std::string> set_patterns(const Teuchos::ParameterList& list);

/// Adds the sets of the validated list "Mesh/Sets", in their order: a set may be selected from an earlier one. Throws
/// InputError with the list path.
void add_sets(const SceneNode& sets, Mesh& mesh);

}  // namespace ixos
