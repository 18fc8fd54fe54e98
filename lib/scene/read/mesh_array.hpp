/// Repeated parts of a mesh.
#pragma once
#include <functional>

#include "mesh/mesh.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Returns the copies of a part in one mesh, see repeated(), or the part itself if its Layout is Once. make(list): the
/// mesh that a list of the part makes. Copies that differ in parameters have each their own list. Throws InputError
/// with the list path, the number of the copy and the seed if a copy cannot be made, and if two copies overlap.
Mesh array_of(const SceneNode& part, const std::function<Mesh(const SceneNode&)>& make);

}  // namespace ixos
