/// How the four-sided faces of a surface in space meet: edges, lines of edges, and nodes of a grid.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// The faces of a surface, four nodes each, counter-clockwise seen from outside. An edge is a crease if only one face
/// has it, or if its two faces meet at more than 30 degrees. A node is regular if four faces and four edges without a
/// crease meet there.
///
/// A strip is a sequence of faces in which each meets the next one at opposite edges; the edges across it have one
/// length, their mean. The lengths along the lines of the grid are then those of a product of two axes.
class SideGrid {
 public:
  using Face = std::array<int, 4>;
  /// Edges of two faces that are creases, but end inside the surface: at a node without another crease or rim. The
  /// edges of a body do not. Those of a smooth surface whose faces are too large for its curvature do.
  struct OpenCreases {
    int count = 0;
    double angle = 0;  ///< the largest one between two faces
  };

  /// `x`: places by node. Throws InputError with `name` if more than two faces have an edge, or if two faces go along
  /// it in one direction. `numbers`: those of the nodes in messages.
  SideGrid(std::vector<Face> faces, const std::vector<Vec<3>>& x, const std::string& name,
           const std::vector<long long>& numbers);

  const std::vector<Face>& faces() const { return faces_; }
  /// Returns the face beyond the edge, -1 at a rim.
  int across(int face, int a, int b) const;
  bool is_crease(int a, int b) const { return edge(a, b).crease; }
  bool is_regular(int node) const;
  /// Returns the node to which the edge from `far` to `node` continues: along the line of the grid at a regular node,
  /// or along the only other crease if that has the same direction within 30 degrees; -1 if there is none.
  int continuation(int node, int far) const;
  /// Returns the length of the edge's strip [L0].
  double strip_length(int a, int b) const { return strip_length_[static_cast<std::size_t>(edge(a, b).strip)]; }
  /// Returns the corner of the face that is opposite to the node; -1 if the face does not have it.
  int opposite(int face, int node) const;
  bool has(int face, int node) const;
  OpenCreases open_creases() const;

 private:
  struct Edge {
    std::array<int, 2> faces{-1, -1};
    bool crease = true;
    int strip = -1;
  };
  const Edge& edge(int a, int b) const { return edges_.at(std::minmax(a, b)); }
  Vec<3> normal(int face) const;  ///< of any length
  void find_edges(const std::string& name, const std::vector<long long>& numbers);
  void find_strips(const std::vector<Vec<3>>& x);

  std::vector<Face> faces_;
  std::map<std::pair<int, int>, Edge> edges_;
  std::vector<std::vector<int>> ends_;  ///< by node: the other ends of its edges
  std::vector<int> count_;              ///< by node: its faces
  std::vector<Vec<3>> x_;
  std::vector<double> strip_length_;
};

/// Throws the InputError of a surface in which two faces go along an edge in one direction; `a`, `b`: the numbers of
/// its nodes in messages.
[[noreturn]] void refuse_edge(const std::string& name, long long a, long long b);

/// Returns the open creases of a side set of a mesh in space; none if its cells are not linear.
SideGrid::OpenCreases open_creases(const Mesh& mesh, const SideSet& set);

}  // namespace ixos
