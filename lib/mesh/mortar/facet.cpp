#include "mesh/mortar/facet.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/small_matrix.hpp"
#include "base/vector3.hpp"
#include "fem/cell_info.hpp"
#include "fem/cell_traits.hpp"
#include "fem/cells/triangles.hpp"
#include "fem/quadratic_elements.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"

namespace ixos {

Facet::Facet(const Mesh& mesh, const Side& side)
    : dimension_(mesh.dimension - 1),
      corners_(static_cast<std::size_t>(count_of(corners_of(mesh, side)))),
      order_(cell_info(mesh.blocks[static_cast<std::size_t>(side.block)].type).order),
      nodes_(nodes_of_side(mesh, side)),
      normal_(outward_normal(mesh, side)) {
  places_.reserve(nodes_.size());
  for (const int node : nodes_) places_.push_back(node_place(mesh, node));
  normal_ = 1 / length(normal_) * normal_;
}

int Facet::degree() const {
  if (is_triangle()) return nodes_.size() == 7 ? 3 : order_;
  return dimension_ * order_;
}

double Facet::size() const {
  double longest = 0;
  for (std::size_t a = 0; a < corners(); ++a)
    for (std::size_t b = 0; b < a; ++b) longest = std::max(longest, length(places_[a] - places_[b]));
  return longest;
}

Vec<3> Facet::middle() const {
  Vec<3> sum{};
  for (std::size_t a = 0; a < corners(); ++a) sum = sum + 1 / static_cast<double>(corners()) * places_[a];
  return sum;
}

ProjectionPlane Facet::plane() const {
  const Vec<3> along = places_[1] - places_[0], in_plane = along - inner(along, normal_) * normal_;
  const Vec<3> first = 1 / length(in_plane) * in_plane;
  return {middle(), {first, cross(normal_, first)}};
}

bool Facet::is_affine() const {
  const Shape at_middle = shape({});
  Vec<3> origin{};
  std::array<Vec<3>, 2> slope{};
  for (std::size_t a = 0; a < nodes_.size(); ++a) {
    origin = origin + at_middle.value[a] * places_[a];
    for (std::size_t d = 0; d < 2; ++d) slope[d] = slope[d] + at_middle.gradient[a][d] * places_[a];
  }
  const auto is_off = [&](const Vec<2>& xi) {
    return length(point(xi) - (origin + xi[0] * slope[0] + xi[1] * slope[1])) > 1e-9 * size();
  };
  // The map is the affine one if it is at as many points as it has nodes.
  if (is_triangle() && is_off(start())) return false;
  const int along = order_ + 1, across = dimension_ == 1 ? 1 : along;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) {
      if (is_triangle() && i + j > order_) continue;
      const double s = static_cast<double>(i) / order_, t = static_cast<double>(j) / order_;
      if (is_off(is_triangle() ? Vec<2>{s, t} : Vec<2>{2 * s - 1, dimension_ == 1 ? 0.0 : 2 * t - 1})) return false;
    }
  return true;
}

std::vector<Polygon> Facet::images(const ProjectionPlane& plane) const {
  const auto image = [&](const std::vector<std::size_t>& nodes) {
    Polygon polygon;
    polygon.reserve(nodes.size());
    for (const std::size_t a : nodes) polygon.push_back(plane.image(places_[a]));
    if (polygon.size() == 2) {
      polygon[0][1] = polygon[1][1] = 0;
    }
    if (area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
  };
  if (dimension_ == 1) return {image({0, 1})};
  if (is_triangle() && order_ == 2) return {image({0, 3, 5}), image({3, 1, 4}), image({5, 4, 2}), image({3, 4, 5})};
  if (is_triangle()) return {image({0, 1, 2})};
  if (order_ == 2) return {image({0, 4, 8, 7}), image({4, 1, 5, 8}), image({8, 5, 2, 6}), image({7, 8, 6, 3})};
  return {image({0, 1, 2, 3})};
}

std::optional<Vec<2>> Facet::find(const ProjectionPlane& plane, const Vec<2>& image) const {
  constexpr double far = 3;  // twice as far from the middle as the edges, at least
  Vec<2> xi = start();
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Shape here = shape(xi);
    Vec<2> off = image;
    Small<double, 2> slope{};
    for (std::size_t a = 0; a < nodes_.size(); ++a) {
      const Vec<2> x = plane.image(places_[a]);
      off = off - here.value[a] * x;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t d = 0; d < 2; ++d) slope[i][d] += x[i] * here.gradient[a][d];
    }
    if (dimension_ == 1) {
      off[1] = 0;
      slope[1][1] = 1;
    }
    const double det = determinant(slope);
    const Vec<2> step{(slope[1][1] * off[0] - slope[0][1] * off[1]) / det,
                      (slope[0][0] * off[1] - slope[1][0] * off[0]) / det};
    xi = xi + step;
    if (!(std::abs(xi[0]) < far && std::abs(xi[1]) < far)) return std::nullopt;
    if (length(step) < 1e-8) return xi;  // the next step would be as long as this one's square
  }
  return std::nullopt;
}

Vec<3> Facet::point(const Vec<2>& xi) const {
  const std::vector<double> value = values(xi);
  Vec<3> x{};
  for (std::size_t a = 0; a < nodes_.size(); ++a) x = x + value[a] * places_[a];
  return x;
}

Facet::Shape Facet::shape(const Vec<2>& xi) const {
  const auto evaluate = [&](auto tag) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension, N = Element::nodes;
    std::array<double, D> at;
    std::copy_n(xi.begin(), D, at.begin());
    std::array<double, N> value;
    std::array<std::array<double, D>, N> gradient;
    Element::evaluate(at, value, gradient);
    Shape result{{value.begin(), value.end()}, std::vector<Vec<2>>(N)};
    for (std::size_t a = 0; a < N; ++a) std::copy_n(gradient[a].begin(), D, result.gradient[a].begin());
    return result;
  };
  if (dimension_ == 1) return order_ == 1 ? evaluate(TypeTag<Line2>{}) : evaluate(TypeTag<LagrangeEdge<2>>{});
  if (is_triangle())
    return order_ == 1          ? evaluate(TypeTag<Tri3>{})
           : nodes_.size() == 6 ? evaluate(TypeTag<Tri6>{})
                                : evaluate(TypeTag<Tri7>{});
  return order_ == 1 ? evaluate(TypeTag<Quad4>{}) : evaluate(TypeTag<Quad9>{});
}

std::vector<Facet> Facet::edges() const {
  std::vector<Facet> edges(corners_, Facet());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    edges[k].order_ = order_;
    std::vector<std::size_t> own{k, (k + 1) % corners_};
    if (order_ == 2) own.push_back(corners_ + k);
    edges[k].nodes_.reserve(own.size());
    edges[k].places_.reserve(own.size());
    for (const std::size_t a : own) {
      edges[k].nodes_.push_back(nodes_[a]);
      edges[k].places_.push_back(places_[a]);
    }
  }
  return edges;
}

std::vector<Facet> boundary_edges(const std::vector<Facet>& sides) {
  std::map<std::pair<int, int>, std::vector<Facet>> found;
  for (const Facet& side : sides)
    for (const Facet& edge : side.edges()) found[std::minmax(edge.nodes()[0], edge.nodes()[1])].push_back(edge);
  std::vector<Facet> boundary;
  for (const auto& [ends, edges] : found)
    if (edges.size() == 1) boundary.push_back(edges.front());
  return boundary;
}

std::vector<FacetEnd> curve_ends(const std::vector<Facet>& curves) {
  struct Meeting {
    Vec<3> place;
    std::vector<Vec<3>> ways;  ///< from there along the curves
  };
  std::map<int, Meeting> meetings;
  for (const Facet& curve : curves)
    for (std::size_t a = 0; a < 2; ++a) {
      Meeting& here = meetings[curve.nodes()[a]];
      here.place = curve.places()[a];
      here.ways.push_back(curve.places()[1 - a] - here.place);
    }
  std::vector<FacetEnd> ends;
  for (const auto& [node, here] : meetings)
    if (here.ways.size() != 2 || !meet_smoothly(-1.0 * here.ways[0], here.ways[1])) ends.push_back({node, here.place});
  return ends;
}

}  // namespace ixos
