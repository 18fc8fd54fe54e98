#include "mesh/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "base/small_matrix.hpp"
#include "fem/cell_info.hpp"
#include "fem/jacobian.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

struct CellQuality {
  double scaled_jacobian = std::numeric_limits<double>::infinity();
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  double volume = 0;
};

/// Returns the determinant of the matrix whose columns are those of `m` scaled to length 1.
template <std::size_t D>
double scaled_determinant(const Small<double, D>& m) {
  double product = 1;
  for (std::size_t d = 0; d < D; ++d) {
    double square = 0;
    for (std::size_t i = 0; i < D; ++i) square += m[i][d] * m[i][d];
    product *= std::sqrt(square);
  }
  return product > 0 ? determinant(m) / product : 0;
}

/// Returns the quality of a cell. `Corners`: the linear element of its corners; the columns of that element's Jacobian
/// at a corner are half the edges there. `revolved`: the volume is that of the ring which a plane cell sweeps.
template <class Element, class Corners>
CellQuality cell_quality(const std::vector<double>& coordinates, const int* nodes, bool revolved) {
  constexpr std::size_t D = Element::dimension;
  // Its points integrate the Jacobian of straight-sided cells exactly, also with the radius as a factor.
  static const ShapeTable<Element> table;
  std::array<double, Element::nodes> ones;
  ones.fill(1);
  CellQuality cell;
  const auto judge = [&](const std::array<double, D>& xi) {
    const auto j = jacobian_at<Element>(xi, coordinates, nodes);
    cell.scaled_jacobian = std::min(cell.scaled_jacobian, scaled_determinant(j));
  };
  for (std::size_t corner = 0; corner < Corners::nodes; ++corner) {
    std::array<double, D> xi;
    for (std::size_t d = 0; d < D; ++d) xi[d] = (corner >> d) % 2 == 0 ? -1 : 1;
    judge(xi);
    const auto j = jacobian_at<Corners>(xi, coordinates, nodes);
    for (std::size_t d = 0; d < D; ++d) {
      double square = 0;
      for (std::size_t i = 0; i < D; ++i) square += 4 * j[i][d] * j[i][d];
      cell.shortest = std::min(cell.shortest, std::sqrt(square));
      cell.longest = std::max(cell.longest, std::sqrt(square));
    }
  }
  if (D == 3) judge({});
  for (std::size_t q = 0; !std::is_same_v<Element, Corners> && q < table.size(); ++q) judge(table.point[q]);
  for (std::size_t q = 0; q < table.size(); ++q) {
    double measure = table.weight[q] * determinant(jacobian<D>(coordinates, nodes, ones, table.gradient[q]));
    if constexpr (D == 2)
      if (revolved) measure *= circumference(coordinates, nodes, ones, table.value[q]);
    cell.volume += measure;
  }
  return cell;
}

/// The edges of a shape, by their corners, and for each corner those at the other ends of its edges.
template <ReferenceShape shape, std::size_t corners>
struct ShapeEdges {
  std::vector<std::array<std::size_t, 2>> ends;
  std::array<std::vector<std::size_t>, corners> neighbours;

  ShapeEdges() {
    // The nodes of the quadratic cell that stand between two corners.
    const auto quadratic = [](const CellInfo& info) { return info.shape == shape && info.order == 2; };
    for (const NodeCorners& between : find_cell(quadratic)->node_corners) {
      if (between.size() != 2) continue;
      const auto a = static_cast<std::size_t>(between[0]), b = static_cast<std::size_t>(between[1]);
      ends.push_back({a, b});
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  }
};

/// Returns 1 over the determinant of the unit vectors along the edges at a corner of a regular cell.
constexpr double ideal_factor(ReferenceShape shape) {
  return shape == ReferenceShape::Triangle || shape == ReferenceShape::Prism ? 1.1547005383792515  // 2 / sqrt 3
                                                                             : 1.4142135623730951;
}

/// Returns the quality of a triangle, tetrahedron, prism or pyramid: at each corner of as many edges as dimensions, the
/// scaled Jacobian of these edges over that of a regular cell; in quadratic cells also that of the map at the corners
/// and the quadrature points.
template <class Element, class Corners>
CellQuality simplex_quality(const std::vector<double>& coordinates, const int* nodes, bool revolved) {
  constexpr std::size_t D = Element::dimension, C = Corners::nodes;
  static const ShapeTable<Element> table(mass_rule<Element>());
  static const ShapeEdges<CellTraits<Element>::shape, C> shape_edges;
  constexpr double factor = ideal_factor(CellTraits<Element>::shape);
  std::array<double, Element::nodes> ones;
  ones.fill(1);
  CellQuality cell;
  for (const auto& [a, b] : shape_edges.ends) {
    double square = 0;
    for (std::size_t i = 0; i < D; ++i) {
      const double way = coordinates[static_cast<std::size_t>(nodes[b]) * D + i] -
                         coordinates[static_cast<std::size_t>(nodes[a]) * D + i];
      square += way * way;
    }
    cell.shortest = std::min(cell.shortest, std::sqrt(square));
    cell.longest = std::max(cell.longest, std::sqrt(square));
  }
  for (std::size_t c = 0; c < C; ++c) {
    const std::vector<std::size_t>& neighbours = shape_edges.neighbours[c];
    if (neighbours.size() != D) continue;  // the apex of a pyramid
    Small<double, D> edges;                // as columns
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i < D; ++i)
        edges[i][d] = coordinates[static_cast<std::size_t>(nodes[neighbours[d]]) * D + i] -
                      coordinates[static_cast<std::size_t>(nodes[c]) * D + i];
    const double sign = determinant(jacobian_at<Corners>(Corners::place(c), coordinates, nodes)) < 0 ? -1 : 1;
    cell.scaled_jacobian = std::min(cell.scaled_jacobian, sign * factor * std::abs(scaled_determinant(edges)));
    if constexpr (!std::is_same_v<Element, Corners>)
      cell.scaled_jacobian =
          std::min(cell.scaled_jacobian,
                   factor * scaled_determinant(jacobian_at<Element>(Element::place(c), coordinates, nodes)));
  }
  for (std::size_t q = 0; q < table.size(); ++q) {
    const Small<double, D> j = jacobian<D>(coordinates, nodes, ones, table.gradient[q]);
    if constexpr (!std::is_same_v<Element, Corners>)
      cell.scaled_jacobian = std::min(cell.scaled_jacobian, factor * scaled_determinant(j));
    double measure = table.weight[q] * determinant(j);
    if constexpr (D == 2)
      if (revolved) measure *= circumference(coordinates, nodes, ones, table.value[q]);
    cell.volume += measure;
  }
  return cell;
}

/// Returns the quality of a cell; that of an enriched one is the quality of its plain_type().
CellQuality cell_quality(CellType type, const std::vector<double>& coordinates, const int* nodes, bool revolved) {
  return with_element(plain_type(type), [&](auto tag) -> CellQuality {
    using Element = typename decltype(tag)::type;
    using Traits = CellTraits<Element>;
    if constexpr (!std::is_same_v<typename Traits::Plain, Element>)
      throw std::logic_error("a plain cell is enriched");
    else if constexpr (HasRule<Element>::value)
      return simplex_quality<Element, typename Traits::Corners>(coordinates, nodes, revolved);
    else
      return cell_quality<Element, typename Traits::Corners>(coordinates, nodes, revolved);
  });
}

}  // namespace

MeshQuality mesh_quality(const Mesh& mesh) {
  MeshQuality all;
  all.dimension = mesh.dimension;
  all.least_scaled_jacobian = std::numeric_limits<double>::infinity();
  std::vector<double> scaled;
  for (const ElementBlock& block : mesh.blocks)
    for (int c = 0; c < block.cells(); ++c) {
      const int* nodes = &block.nodes[cell_entry(c, nodes_per_cell(block.type))];
      const CellQuality cell = cell_quality(block.type, mesh.coordinates, nodes, mesh.axisymmetric);
      scaled.push_back(cell.scaled_jacobian);
      all.volume += cell.volume;
      if (cell.scaled_jacobian < all.least_scaled_jacobian) {
        all.least_scaled_jacobian = cell.scaled_jacobian;
        all.most_distorted = place_of(mesh, block, c);
      }
      if (const double ratio = cell.longest / cell.shortest; ratio > all.largest_aspect_ratio) {
        all.largest_aspect_ratio = ratio;
        all.longest = place_of(mesh, block, c);
      }
    }
  all.cells = mesh.cells();
  all.nodes = mesh.nodes();
  if (scaled.empty()) return {};
  const auto low = scaled.begin() + static_cast<std::ptrdiff_t>((scaled.size() - 1) / 20);
  std::nth_element(scaled.begin(), low, scaled.end());
  all.low_scaled_jacobian = *low;
  for (double value : scaled) all.mean_scaled_jacobian += value / static_cast<double>(scaled.size());
  return all;
}

double least_scaled_jacobian(CellType type, const std::vector<int>& nodes, const std::vector<double>& coordinates) {
  const auto count = static_cast<std::size_t>(nodes_per_cell(type));
  double least = 1;
  for (std::size_t first = 0; first + count <= nodes.size(); first += count)
    least = std::min(least, cell_quality(type, coordinates, &nodes[first], false).scaled_jacobian);
  return least;
}

std::string to_string(const MeshQuality& quality) {
  return fmt::format(
      "{} cells, {} nodes, volume {:.6g}\n"
      "scaled Jacobian: least {:.3f} ({}), 5th percentile {:.3f}, mean {:.3f}\n"
      "largest aspect ratio: {:.1f} ({})\n",
      quality.cells, quality.nodes, quality.volume, quality.least_scaled_jacobian,
      in_words(quality.most_distorted, quality.dimension), quality.low_scaled_jacobian, quality.mean_scaled_jacobian,
      quality.largest_aspect_ratio, in_words(quality.longest, quality.dimension));
}

std::string quality_warning(const MeshQuality& quality) {
  if (quality.cells == 0) return "";
  const int d = quality.dimension;
  std::string text;
  if (quality.least_scaled_jacobian < 0.1)
    text = fmt::format("{} has a scaled Jacobian of {:.3f}", in_words(quality.most_distorted, d),
                       quality.least_scaled_jacobian);
  if (quality.largest_aspect_ratio > 100)
    text += fmt::format("{}{} has an aspect ratio of {:.0f}", text.empty() ? "" : "; ", in_words(quality.longest, d),
                        quality.largest_aspect_ratio);
  return text.empty() ? "" : "the mesh has very bad cells: " + text;
}

}  // namespace ixos
