/// Meshes whose parts are meshes of the catalogue themselves.
#pragma once
#include "mesh/generators/entry.hpp"
#include "mesh/splitting/refine.hpp"

namespace ixos {

/// The names of the entries parts_mesh() and array_mesh(), and whether a name is one of them.
extern const char* const parts_mesh_name;
extern const char* const array_mesh_name;
bool has_parts(const std::string& name);

/// Returns the entry of several bodies in one mesh. Its parameters are any number of lists, one for each part.
MeshEntry parts_mesh();
/// Returns the entry whose parts may be repeated.
MeshEntry array_mesh();

/// Returns the meshes that a part may be: the catalogue but "Given", "Parts" and "Array".
const Catalogue<MeshEntry>& part_meshes();

/// Makes the mesh that a list chooses from a catalogue, of cells of that order: 1 leaves those of a file as they are.
/// Splits cells, and applies the list's map. Throws InputError with the list path.
Mesh mapped_mesh(const Catalogue<MeshEntry>& catalogue, const SceneNode& node, int order,
                 const Splitting& splitting = {});

/// Raises the order of a mesh's cells to 2 if `order` is, splits cells, and applies the map of a list of the mesh.
/// Throws InputError with the list path, also for cells that do not conform.
void apply_order_and_map(const SceneNode& node, int order, const Splitting& splitting, Mesh& mesh);

/// Returns the lists that choose the meshes of the parts, or "Mesh" itself if it has no parts.
std::vector<SceneNode> part_lists(const SceneNode& mesh);

/// Returns the list that chooses the mesh to which the block belongs, of those of part_lists().
const SceneNode& list_of(const ElementBlock& block, const std::vector<SceneNode>& lists);

}  // namespace ixos
