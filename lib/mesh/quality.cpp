#include "mesh/quality.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

template <class Element>
void check(const Mesh& mesh, const ElementBlock& block) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  const ShapeTable<Element> table(Element::default_points, block.tied);
  for (int cell = 0; cell < block.cells(); ++cell) {
    const auto scale = cell_scales<Element>(block, cell);
    for (const auto& gradient : table.gradient) {
      const double det = determinant(jacobian<D>(mesh.coordinates, &block.nodes[cell_entry(cell, N)], scale, gradient));
      if (!(det > 0))
        throw InputError(
            fmt::format("block \"{}\", cell {}: inverted or degenerate (Jacobian {:.3g}); its nodes must be ordered "
                        "counter-clockwise, in a hexahedron the bottom face first",
                        block.name, cell + 1, det));
    }
  }
}

}  // namespace

void check_cells(const Mesh& mesh) {
  for (const ElementBlock& block : mesh.blocks)
    with_element(block.type, [&](auto element) { check<typename decltype(element)::type>(mesh, block); });
}

}  // namespace ixos
