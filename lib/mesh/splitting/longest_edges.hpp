/// The first bisections of simplices.
#pragma once
#include <array>
#include <map>

#include "mesh/mesh.hpp"
#include "mesh/splitting/tree_cell.hpp"

namespace ixos {

/// The edges of a mesh's triangles and tetrahedra by length. Lengths that differ by rounding are equal; the numbers of
/// nodes then decide, so that all cells at an edge or a face agree.
class LongestEdges {
 public:
  explicit LongestEdges(const Mesh& mesh);

  /// Returns the longest edge of a whole simplex, and those of its faces.
  MarkedEdges marks(const TreeCell& simplex) const;

 private:
  using Edge = std::array<int, 2>;
  MarkedEdges::Edge longest(const TreeCell& simplex, int left_out) const;

  std::map<Edge, int> rank_;  ///< by ascending nodes: larger for longer edges
};

}  // namespace ixos
