#include "mesh/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/small_matrix.hpp"
#include "fem/cell_types.hpp"
#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"

namespace ixos {
namespace {

struct CellQuality {
  double scaled_jacobian = std::numeric_limits<double>::infinity();
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  double volume = 0;
};

/// The determinant of the matrix whose columns are those of `m` scaled to length 1.
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

/// Of the element with as many corners as `Element`, whose Jacobian at a corner has half the edges there as columns.
template <class Element>
CellQuality cell_quality(const Mesh& mesh, const int* nodes) {
  constexpr std::size_t D = Element::dimension, N = Element::nodes;
  static const ShapeTable<Element> table;  // its points integrate the Jacobian exactly
  std::array<double, N> ones;
  ones.fill(1);
  std::array<double, N> value;
  std::array<std::array<double, D>, N> gradient;
  const auto at = [&](const std::array<double, D>& xi) {
    Element::evaluate(xi, value, gradient);
    return jacobian<D>(mesh.coordinates, nodes, ones, gradient);
  };
  CellQuality cell;
  for (std::size_t corner = 0; corner < N; ++corner) {
    std::array<double, D> xi;
    for (std::size_t d = 0; d < D; ++d) xi[d] = (corner >> d) % 2 == 0 ? -1 : 1;
    const Small<double, D> j = at(xi);
    cell.scaled_jacobian = std::min(cell.scaled_jacobian, scaled_determinant(j));
    for (std::size_t d = 0; d < D; ++d) {
      double square = 0;
      for (std::size_t i = 0; i < D; ++i) square += 4 * j[i][d] * j[i][d];
      cell.shortest = std::min(cell.shortest, std::sqrt(square));
      cell.longest = std::max(cell.longest, std::sqrt(square));
    }
  }
  if (D == 3) cell.scaled_jacobian = std::min(cell.scaled_jacobian, scaled_determinant(at({})));
  for (std::size_t q = 0; q < table.size(); ++q)
    cell.volume += table.weight[q] * determinant(jacobian<D>(mesh.coordinates, nodes, ones, table.gradient[q]));
  return cell;
}

}  // namespace

MeshQuality mesh_quality(const Mesh& mesh) {
  MeshQuality all;
  std::vector<double> scaled;
  for (const ElementBlock& block : mesh.blocks)
    for (int c = 0; c < block.cells(); ++c) {
      const int* nodes = &block.nodes[cell_entry(c, nodes_per_cell(block.type))];
      const CellQuality cell =
          plain_type(block.type) == CellType::Hex8 ? cell_quality<Hex8>(mesh, nodes) : cell_quality<Quad4>(mesh, nodes);
      scaled.push_back(cell.scaled_jacobian);
      all.largest_aspect_ratio = std::max(all.largest_aspect_ratio, cell.longest / cell.shortest);
      all.volume += cell.volume;
    }
  all.cells = mesh.cells();
  all.nodes = mesh.nodes();
  if (scaled.empty()) return all;
  std::sort(scaled.begin(), scaled.end());
  all.least_scaled_jacobian = scaled.front();
  all.low_scaled_jacobian = scaled[(scaled.size() - 1) / 20];
  for (double value : scaled) all.mean_scaled_jacobian += value / static_cast<double>(scaled.size());
  return all;
}

std::string to_string(const MeshQuality& quality) {
  return fmt::format(
      "{} cells, {} nodes, volume {:.6g}\n"
      "scaled Jacobian: least {:.3f}, 5 % at most {:.3f}, mean {:.3f}\n"
      "largest aspect ratio: {:.1f}\n",
      quality.cells, quality.nodes, quality.volume, quality.least_scaled_jacobian, quality.low_scaled_jacobian,
      quality.mean_scaled_jacobian, quality.largest_aspect_ratio);
}

}  // namespace ixos
