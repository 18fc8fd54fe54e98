/// Sets of sides and nodes chosen by their place.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the side set of that name. Throws InputError that names the nearest one.
const SideSet& side_set_named(const Mesh& mesh, const std::string& name);

/// An axis-parallel box; an empty bound means no bound. Points on its boundary count as inside, to 1e-9 of the mesh's
/// size.
struct Region {
  std::vector<double> lower;  ///< D coordinates [L0], or empty
  std::vector<double> upper;
};

/// Adds the side set `name`: the sides of the set `from` whose corner nodes all lie in the region. Throws InputError if
/// `from` does not exist, `name` exists already, or the region holds no side.
void add_side_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region);

/// Adds the node set `name`: the nodes of the set `from` in the region, or of the whole mesh if `from` is empty. Throws
/// InputError likewise.
void add_node_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region);

}  // namespace ixos
