/// Integrals over meshes for tests.
#pragma once
#include <cstddef>

#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/mesh.hpp"

namespace ixos::test {

/// Calls f(value at each node, gradient det, points) for the integration points of all cells.
template <class F>
void for_each_point(const Mesh& mesh, const F& f) {
  for (const ElementBlock& block : mesh.blocks)
    with_element(block.type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      const ShapeTable<Element> table(own_rule<Element>(), 0U);
      std::array<double, Element::nodes> scale;
      scale.fill(1);
      for (int cell = 0; cell < block.cells(); ++cell) {
        const int* nodes = &block.nodes[cell_entry(cell, Element::nodes)];
        for (std::size_t q = 0; q < table.size(); ++q)
          f(nodes, table.value[q].data(), static_cast<std::size_t>(Element::nodes),
            table.weight[q] *
                determinant(jacobian<Element::dimension>(mesh.coordinates, nodes, scale, table.gradient[q])));
      }
    });
}

inline double volume(const Mesh& mesh) {
  double sum = 0;
  for_each_point(mesh, [&](const int*, const double*, std::size_t, double weight) { sum += weight; });
  return sum;
}

}  // namespace ixos::test
