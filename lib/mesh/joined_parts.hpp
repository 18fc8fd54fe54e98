/// Meshes of several bodies from meshes of one.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// A mesh that becomes a part of another one.
struct MeshPart {
  std::string name;
  Mesh mesh;
};

/// Returns the name that a block or a set of a part has in the joined mesh: "left" and "surface" make "left_surface".
std::string name_in_part(const std::string& part, const std::string& own);

/// Returns whether name_in_part() of this part made the name, in a mesh of joined_parts().
bool is_in_part(const std::string& part, const std::string& name);

/// Returns one mesh of all parts, in their order, with names from name_in_part() for blocks, side sets and node sets,
/// and with their ties. Merges no nodes: where parts touch, they stay apart. The nodes that raise_order() appended to a
/// part stand behind the other nodes of all parts, see Mesh::linear_nodes. Throws InputError if there is no part, if
/// the parts have different dimensions or meanings of them, if one is enriched, if a name of a part is empty, stands
/// twice, has other characters than letters (of ASCII), digits, "_" and "-", or begins like the names of another part's
/// blocks ("left" and "left_upper").
Mesh joined_parts(const std::vector<MeshPart>& parts);

/// Returns one part of a mesh of joined_parts(): its blocks and sets, under their names in the joined mesh, and their
/// nodes. Sets `old` to the nodes' numbers there; their order is that of the part. A model of it may have
/// another communicator than the whole.
Mesh part_of_joined(const Mesh& joined, const std::string& part, std::vector<int>& old);

}  // namespace ixos
