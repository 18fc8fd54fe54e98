#include "geometry/split_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "base/error.hpp"
#include "fem/with_element.hpp"
#include "geometry/edge_middles.hpp"
#include "geometry/lagrange_patches.hpp"
#include "geometry/surface_patches.hpp"

namespace ixos {
namespace {

using Reference = std::array<double, 2>;  ///< coordinates of a side's element
using Corner = SurfacePatch<3>::Corner;

Reference mean(const std::vector<Reference>& points) {
  Reference sum{};
  for (const Reference& point : points)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += point[d] / static_cast<double>(points.size());
  return sum;
}

/// Returns the coordinates of the corners of a side's element: the places where their functions are 1.
template <class Element>
std::vector<Reference> corners_of() {
  if constexpr (std::is_base_of_v<TriangleBase, Element>)
    return {TriangleBase::corners.begin(), TriangleBase::corners.end()};
  else
    return {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
}

/// The points through which a side goes, in the order of its element's nodes: the nodes, or sums of others.
using Controls = std::vector<NodeWeights>;

/// Returns the nodes in these sums, in the order in which they come.
std::vector<int> nodes_of(const Controls& controls) {
  std::vector<int> result;
  for (const NodeWeights& control : controls)
    for (const int node : control.nodes)
      if (std::find(result.begin(), result.end(), node) == result.end()) result.push_back(node);
  return result;
}

/// Returns the patch between four points of a side.
template <class Element>
SurfacePatch<3> patch_between(const std::array<Reference, 4>& corners, const Controls& controls) {
  const std::vector<int> nodes = nodes_of(controls);
  if (nodes.size() > SurfacePatch<3>::most) throw std::length_error("a patch has too many nodes");
  SurfacePatch<3> patch;
  patch.count = nodes.size();
  patch.degree = Element::nodes <= 4 ? 1 : Element::nodes == 7 ? 3 : 2;
  std::copy(nodes.begin(), nodes.end(), patch.nodes.begin());
  std::vector<double> places;
  for (int i = 0; i <= patch.degree; ++i) places.push_back(static_cast<double>(i) / patch.degree);
  const std::vector<std::vector<double>> lines = lagrange_polynomials(places);
  const std::size_t n = places.size();
  std::vector<double> functions(nodes.size() * n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const double s = places[i], t = places[j];
      const std::array<double, 4> share{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
      Reference xi{};
      for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t d = 0; d < 2; ++d) xi[d] += share[c] * corners[c][d];
      std::array<double, Element::nodes> value;
      std::array<Reference, Element::nodes> gradient;
      Element::evaluate(xi, value, gradient);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        double own = 0;
        for (std::size_t c = 0; c < controls.size(); ++c) own += value[c] * controls[c].weight(nodes[a]);
        for (std::size_t l = 0; l < n; ++l)
          for (std::size_t k = 0; k < n; ++k) functions[(a * n + l) * n + k] += own * lines[i][k] * lines[j][l];
      }
    }
  patch.set_functions(functions);
  return patch;
}

/// Numbers the points between nodes, by these nodes.
class Numbering {
 public:
  explicit Numbering(SplitSides& all) : all_(all) {}
  int operator()(Corner corner) {
    if (corner.size() == 1) return corner.front();
    std::sort(corner.begin(), corner.end());
    const auto [found, is_new] = number_.try_emplace(corner, static_cast<int>(all_.x.size()));
    if (is_new) {
      Vec<3> place{};
      for (const int node : corner)
        place = place + 1 / static_cast<double>(corner.size()) * all_.x[static_cast<std::size_t>(node)];
      all_.x.push_back(place);
      all_.numbers.push_back(all_.numbers[static_cast<std::size_t>(corner.front())]);
    }
    return found->second;
  }

 private:
  SplitSides& all_;
  std::map<Corner, int> number_;
};

/// Appends the patches of a side with these corners.
template <class Element>
void append(const Controls& controls, const std::vector<int>& corners, int side, Numbering& number, SplitSides& all) {
  const std::vector<Reference> ends = corners_of<Element>();
  const std::size_t n = ends.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n, before = (k + n - 1) % n;
    SurfacePatch<3> patch = patch_between<Element>(
        {ends[k], mean({ends[k], ends[next]}), mean(ends), mean({ends[before], ends[k]})}, controls);
    patch.side_corners = n;
    patch.split_corners = {{corners[k]},
                           {corners[k], corners[next]},
                           Corner(corners.begin(), corners.end()),
                           {corners[before], corners[k]}};
    for (Corner& corner : patch.split_corners) std::sort(corner.begin(), corner.end());
    patch.smooth = {false, true, false, true};
    SideGrid::Face face;
    for (std::size_t c = 0; c < 4; ++c) face[c] = number(patch.split_corners[c]);
    all.faces.push_back(face);
    all.side.push_back(side);
    all.patches.push_back(std::move(patch));
  }
}

NodeWeights node_alone(int node) {
  NodeWeights result;
  result.add(node, 1);
  return result;
}

/// Returns the points of a quadratic side through the corners and the middles of a linear one.
Controls smooth_controls(const std::vector<int>& corners, const EdgeMiddles& middles) {
  Controls result;
  for (const int corner : corners) result.push_back(node_alone(corner));
  for (std::size_t k = 0; k < corners.size(); ++k)
    result.push_back(middles.middle(corners[k], corners[(k + 1) % corners.size()]));
  if (corners.size() == 3) return result;
  NodeWeights middle;  // that of a quadrilateral without a node there
  for (std::size_t k = 0; k < result.size(); ++k) middle.add(result[k], k < corners.size() ? -0.25 : 0.5);
  result.push_back(middle);
  return result;
}

/// Throws InputError if two sides go along an edge in one direction. `nodes`: by side, the corners first.
void require_edges(const std::vector<LocalSide>& sides, const std::vector<std::vector<int>>& nodes,
                   const std::vector<long long>& numbers, const LocalMesh& mesh, const std::string& name) {
  std::set<std::pair<int, int>> ways;
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const CellType type = mesh.blocks[static_cast<std::size_t>(sides[f].block)].type;
    const std::size_t corners = side_nodes(corner_type(type), sides[f].side).size();
    for (std::size_t k = 0; k < corners; ++k) {
      const int a = nodes[f][k], b = nodes[f][(k + 1) % corners];
      if (!ways.insert({a, b}).second)
        refuse_edge(name, numbers[static_cast<std::size_t>(a)], numbers[static_cast<std::size_t>(b)]);
    }
  }
}

}  // namespace

SplitSides split_sides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const std::vector<int>& nodes,
                       bool smooth, const std::string& name) {
  SplitSides result;
  for (const int node : nodes) {
    result.x.push_back(reference_place<3>(mesh, node));
    result.numbers.push_back(mesh.message_number(static_cast<std::size_t>(node)));
  }
  std::vector<std::vector<int>> all;
  for (const LocalSide& side : sides) {
    all.emplace_back();
    for (const int node : side.nodes) all.back().push_back(surface_number(nodes, node, mesh));
  }
  require_edges(sides, all, result.numbers, mesh, name);
  std::optional<EdgeMiddles> middles;
  if (smooth && sides.front().nodes.size() <= 4) {
    std::vector<EdgeMiddles::Face> faces;
    faces.reserve(all.size());
    for (const std::vector<int>& own : all) faces.emplace_back(own.begin(), own.end());
    middles.emplace(std::move(faces), result.x);
  }
  Numbering number(result);
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const std::vector<int>& own = all[f];
    try {
      with_side_element(mesh.blocks[static_cast<std::size_t>(sides[f].block)].type, sides[f].side, [&](auto tag) {
        using Element = typename decltype(tag)::type;
        if constexpr (Element::dimension == 2 && Element::nodes <= 9) {
          constexpr bool is_triangle = std::is_base_of_v<TriangleBase, Element>;
          const std::vector<int> corners(own.begin(), own.begin() + (is_triangle ? 3 : 4));
          if (middles)
            return append<std::conditional_t<is_triangle, Tri6, Quad9>>(smooth_controls(corners, *middles), corners,
                                                                        static_cast<int>(f), number, result);
          Controls controls;
          for (const int node : own) controls.push_back(node_alone(node));
          append<Element>(controls, corners, static_cast<int>(f), number, result);
        }
      });
    } catch (const std::length_error&) {
      throw InputError(
          fmt::format("too many sides of the surface \"{}\" meet near node {} of the mesh for Smoothing "
                      "\"Catmull-Rom\"; use \"None\"",
                      name, result.numbers[static_cast<std::size_t>(own.front())]));
    }
  }
  return result;
}

}  // namespace ixos
