#include "discretization/volume_squares.hpp"

#include <array>

#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Calls visit(cell, nodes, scale, values, dV) at each point of this rank's own cells of a block of Elements.
template <class Element, class Visit>
void visit_points(const LocalMesh& mesh, const LocalBlock& block, const Visit& visit) {
  const ShapeTable<Element> table(mass_rule<Element>(), block.tied);
  for (int cell = 0; cell < block.cells(); ++cell) {
    if (block.owned[static_cast<std::size_t>(cell)] == 0) continue;
    const int* nodes = &block.nodes[cell_entry(cell, Element::nodes)];
    const auto scale = cell_scales<Element>(block, cell);
    for (std::size_t q = 0; q < table.size(); ++q) {
      double volume = table.weight[q] *
                      determinant(jacobian<Element::dimension>(mesh.coordinates, nodes, scale, table.gradient[q]));
      if (mesh.axisymmetric) volume *= circumference(mesh.coordinates, nodes, scale, table.value[q]);
      visit(static_cast<std::size_t>(cell), nodes, scale, table.value[q], volume);
    }
  }
}

}  // namespace

std::vector<std::vector<double>> owned_volumes(const LocalMesh& mesh) {
  std::vector<std::vector<double>> volumes;
  for (const LocalBlock& block : mesh.blocks) {
    std::vector<double>& own = volumes.emplace_back(static_cast<std::size_t>(block.cells()), 0.0);
    with_element(block.type, [&](auto tag) {
      visit_points<typename decltype(tag)::type>(
          mesh, block, [&](std::size_t cell, const int*, const auto&, const auto&, double dV) { own[cell] += dV; });
    });
  }
  return volumes;
}

double nodal_square(const LocalMesh& mesh, const std::vector<std::vector<double>>& components) {
  double sum = 0;
  for (const LocalBlock& block : mesh.blocks)
    with_element(block.type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      visit_points<Element>(mesh, block,
                            [&](std::size_t, const int* nodes, const auto& scale, const auto& value, double dV) {
                              for (const std::vector<double>& component : components) {
                                double f = 0;
                                for (std::size_t a = 0; a < Element::nodes; ++a)
                                  f += scale[a] * value[a] * component[static_cast<std::size_t>(nodes[a])];
                                sum += f * f * dV;
                              }
                            });
    });
  return sum;
}

}  // namespace ixos
