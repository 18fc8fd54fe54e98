/// A smooth surface through the nodes of linear faces, three- and four-sided: where the middles of their edges are.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "geometry/face_patches.hpp"

namespace ixos {

/// The middle of an edge is that of the cubic curve with the surface's slopes at both ends, (a + b)/2 + (a' - b')/8. A
/// slope at a node is that of the quadratic function of the tangent plane's coordinates which fits the nodes around it
/// best, with the inverse squares of their distances as weights: linear in the places, unlike slopes that follow from
/// normals (Vlachos, Peters, Boyd, Mitchell 2001). Quadratic motions of a flat surface come back. The fit does not
/// reach across creases, edges of one face or of two that meet at more than 30 degrees. Along these the slope is that
/// of the parabola through a node and its neighbours. At an end without a slope the curve is a parabola.
class EdgeMiddles {
 public:
  using Face = boost::container::static_vector<int, 4>;
  /// `x`: reference places by node [L0].
  EdgeMiddles(std::vector<Face> faces, const std::vector<Vec<3>>& x);

  NodeWeights middle(int a, int b) const;

 private:
  struct Edge {
    std::vector<int> faces;
    bool crease = true;
  };
  const Edge& edge(int a, int b) const { return edges_.at(std::minmax(a, b)); }
  Vec<3> normal(int face) const;
  std::optional<NodeWeights> slope(int a, int b) const;
  std::optional<NodeWeights> along_crease(int a, int b) const;
  std::vector<int> sector(int node, int face) const;
  void grow(std::vector<int>& faces) const;
  std::optional<NodeWeights> fitted(int a, int b, const std::vector<int>& faces, const Vec<3>& normal) const;

  std::vector<Face> faces_;
  std::map<std::pair<int, int>, Edge> edges_;
  std::vector<std::vector<int>> ends_;  ///< by node: the other ends of its creases
  std::vector<Vec<3>> x_;
};

}  // namespace ixos
