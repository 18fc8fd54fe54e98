/// The faces of a side set as a grid, for contact elements that are smooth from face to face: a part of enrich().
#pragma once
#include <array>
#include <map>
#include <vector>

#include "mesh/enrichment/contact_nodes.hpp"

namespace ixos {

/// Corners of a face, counter-clockwise seen from outside.
using Face = std::array<int, 4>;

/// Faces of the set around a node, each joined to the next by an edge, the grid's spokes: face k lies between spokes k
/// and k + 1. Spokes 0 and 2 continue each other, and so do 1 and 3.
struct Fan {
  int node;
  std::vector<int> spokes;         ///< their other ends, counter-clockwise
  std::vector<std::size_t> faces;  ///< as many as spokes if the fan is closed, else one less
};

/// The grid of a set's faces. Throws InputError if a closed fan has other than four faces, an open one more than three,
/// or an edge more than two.
class FaceGrid {
 public:
  FaceGrid(const Mesh& mesh, const SideSet& set);

  const std::vector<Face>& faces() const { return faces_; }
  /// Returns the fans. A node at which faces meet in a corner only has several.
  const std::vector<Fan>& fans() const { return fans_; }

  struct Place {
    std::size_t fan;
    std::size_t position;  ///< of the face in it
  };
  /// Returns the place of a face's corner.
  const Place& place(std::size_t face, std::size_t corner) const { return places_[face][corner]; }

  /// Returns the mean length of the edges that lie opposite each other in a row of faces, this edge among them [L0]. As
  /// all of them have one width, derivatives across a line of the grid match along all of it.
  double width(int a, int b) const { return widths_.at(edge_key(a, b)); }

 private:
  void find_fans(const Mesh& mesh, const SideSet& set);
  void find_widths(const Mesh& mesh);

  std::vector<Face> faces_;
  std::vector<Fan> fans_;
  std::vector<std::array<Place, 4>> places_;
  std::map<Edge, double> widths_;
};

}  // namespace ixos
