/// Nodes of triangles, tetrahedra, prisms and pyramids: each stands in the middle of some corners.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "fem/cell_traits.hpp"

namespace ixos {

/// Returns the mean of some corners of a reference shape: the place of a node.
template <std::size_t D, std::size_t Corners>
std::array<double, D> middle_of(const std::array<std::array<double, D>, Corners>& corners, const NodeCorners& own) {
  std::array<double, D> middle{};
  for (const int corner : own)
    for (std::size_t d = 0; d < D; ++d)
      middle[d] += corners[static_cast<std::size_t>(corner)][d] / static_cast<double>(own.size());
  return middle;
}

/// Returns the nodes of sides given by their corners: the corners, the middles of their edges, the side's own. `nodes`:
/// what corners each node of the cell stands between.
inline SideNodes sides_by_corners(const SideNodes& corners, const std::vector<NodeCorners>& nodes) {
  const auto add = [&nodes](NodeCorners between, std::vector<int>& side) {
    std::sort(between.begin(), between.end());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      NodeCorners own = nodes[a];
      std::sort(own.begin(), own.end());
      if (own == between) side.push_back(static_cast<int>(a));
    }
  };
  SideNodes sides = corners;
  for (std::vector<int>& side : sides) {
    const std::vector<int> round = side;
    for (std::size_t k = 0; k < (round.size() == 2 ? 1 : round.size()); ++k)
      add({round[k], round[(k + 1) % round.size()]}, side);
    if (round.size() > 2) add(round, side);
  }
  return sides;
}

/// The places of an element's nodes. `Own` has the corners of its shape and node_corners().
template <class Own>
struct NodesBetweenCorners {
  /// Returns the reference coordinates of a node. Throws std::out_of_range.
  static auto place(std::size_t a) {
    static const auto places = [] {
      std::vector<typename std::remove_const_t<decltype(Own::corners)>::value_type> all;
      for (const NodeCorners& own : Own::node_corners()) all.push_back(middle_of(Own::corners, own));
      return all;
    }();
    return places.at(a);
  }
};

/// The traits of an element whose nodes stand between corners. `Shape`: the traits of its shape, with side_corners().
template <class Element, class Shape>
struct SimplexTraits : Shape {
  using Plain = Element;
  static constexpr int order = Element::nodes > Shape::Corners::nodes ? 2 : 1;
  static SideNodes side_nodes() { return sides_by_corners(Shape::side_corners(), Element::node_corners()); }
};

}  // namespace ixos
