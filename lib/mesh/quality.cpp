#include "mesh/quality.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/small_matrix.hpp"
#include "fem/cell_types.hpp"
#include "fem/shape_table.hpp"

namespace ixos {
namespace {

template <class Element>
void check(const Mesh& mesh, const ElementBlock& block) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  const ShapeTable<Element> table;
  for (int cell = 0; cell < block.cells(); ++cell)
    for (const auto& gradient : table.gradient) {
      Small<double, D> jacobian{};
      for (std::size_t a = 0; a < N; ++a) {
        const auto node = static_cast<std::size_t>(block.nodes[cell_entry(cell, N, static_cast<int>(a))]);
        const double scale = node_scale(block, cell, static_cast<int>(a));
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) jacobian[i][j] += scale * mesh.coordinates[node * D + i] * gradient[a][j];
      }
      if (!(determinant(jacobian) > 0))
        throw InputError(
            fmt::format("block \"{}\", cell {}: inverted or degenerate (Jacobian {:.3g}); cells are numbered "
                        "counter-clockwise, hexahedra bottom first",
                        block.name, cell + 1, determinant(jacobian)));
    }
}

}  // namespace

void check_cells(const Mesh& mesh) {
  for (const ElementBlock& block : mesh.blocks)
    with_element(block.type, [&](auto element) { check<typename decltype(element)::type>(mesh, block); });
}

}  // namespace ixos
