/// Meshes that a scene may choose.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "parameters/catalogue.hpp"

namespace ixos {

/// An entry makes a mesh from its parameters. The list that chooses it is "Mesh".
struct MeshEntry : CatalogueEntry<Mesh> {
  int dimension = 0;  ///< of all its meshes; 0 if its parameter "Dimension" gives it, or the file of the mesh
  /// Makes the mesh of quadratic cells from the same list, if its shape is curved; null: raise_order() does.
  std::function<Mesh(const SceneNode&)> make_quadratic{};
};

/// Copies `values` to the first `count` elements of `target`; an empty array leaves it unchanged. Throws InputError if
/// there are not `count` values.
template <class T, std::size_t N>
void copy_values(const SceneNode& node, const char* entry, const std::vector<T>& values, int count,
                 std::array<T, N>& target) {
  if (values.empty()) return;
  if (static_cast<int>(values.size()) != count)
    throw InputError(node.path_of(entry) + " has " + std::to_string(values.size()) + " elements, not " +
                     std::to_string(count));
  std::copy(values.begin(), values.end(), target.begin());
}

}  // namespace ixos
