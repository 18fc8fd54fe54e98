#include "model/strain_extent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/eigenpairs.hpp"
#include "discretization/cell_quadrature.hpp"
#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "material/strain.hpp"

namespace ixos {
namespace {

/// Returns the principal strain sqrt(1 + a) - 1 of an eigenvalue a of F^T F - I, without cancellation.
double principal_strain(double a) { return a / (1 + std::sqrt(std::max(0.0, 1 + a))); }

/// Replaces a number by a larger one, or by NaN, which stays.
void enlarge(double& number, double by) {
  if (!(by <= number) && !std::isnan(number)) number = by;
}

void add(const StrainExtent& more, StrainExtent& all) {
  enlarge(all.rotation, more.rotation);
  enlarge(all.largest, more.largest);
  double compression = -all.least;
  enlarge(compression, -more.least);
  all.least = -compression;
}

/// Adds a principal strain.
void add_strain(double strain, StrainExtent& all) { add({0, strain, strain}, all); }

template <class Element>
void add_block(const LocalMesh& mesh, const LocalBlock& block, const std::vector<double>& u, StrainExtent& all) {
  constexpr std::size_t D = Element::dimension;
  const ShapeTable<Element> table(cell_rule<Element>(block, 0), block.tied);
  for (int cell = 0; cell < block.cells(); ++cell) {
    if (block.owned[static_cast<std::size_t>(cell)] == 0) continue;
    const int* nodes = &block.nodes[cell_entry(cell, Element::nodes)];
    const auto scale = cell_scales<Element>(block, cell);
    for (std::size_t q = 0; q < table.size(); ++q) {
      const Small<double, D> place = jacobian<D>(mesh.coordinates, nodes, scale, table.gradient[q]);
      const Small<double, D> moved = jacobian<D>(u, nodes, scale, table.gradient[q]);
      add(strain_extent(product(moved, inverse(place, determinant(place)))), all);
      if (!mesh.axisymmetric) continue;
      double radius = 0, change = 0;
      for (std::size_t a = 0; a < Element::nodes; ++a) {
        const double share = scale[a] * table.value[q][a];
        radius += share * mesh.coordinates[D * static_cast<std::size_t>(nodes[a])];
        change += share * u[D * static_cast<std::size_t>(nodes[a])];
      }
      add_strain(change / radius, all);
    }
  }
}

}  // namespace

StrainExtent strain_extent(const Small<double, 2>& h) {
  StrainExtent result;
  const Eigenpairs<double, 2> pairs = eigenpairs(green_strain_doubled(h));
  for (double value : pairs.value) add_strain(principal_strain(value), result);
  result.rotation = std::abs(std::atan2(h[1][0] - h[0][1], 2 + h[0][0] + h[1][1]));
  return result;
}

StrainExtent strain_extent(const Small<double, 3>& h) {
  StrainExtent result;
  const Eigenpairs<double, 3> pairs = eigenpairs(green_strain_doubled(h));
  Small<double, 3> inverse_stretch{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double strain = principal_strain(pairs.value[k]);
    add_strain(strain, result);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        inverse_stretch[i][j] += pairs.vector[k][i] * pairs.vector[k][j] / (1 + strain);
  }
  const Small<double, 3> r = product(deformation_gradient(h), inverse_stretch);
  // Twice the sine of the angle, and twice its cosine.
  const double sine = std::hypot(r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]), cosine = trace(r) - 1;
  result.rotation = std::atan2(sine, cosine);
  return result;
}

StrainExtent strain_extent(const LocalMesh& mesh, const std::vector<double>& u) {
  StrainExtent all;
  for (const LocalBlock& block : mesh.blocks)
    with_element(block.type, [&](auto tag) { add_block<typename decltype(tag)::type>(mesh, block, u, all); });
  return all;
}

}  // namespace ixos
