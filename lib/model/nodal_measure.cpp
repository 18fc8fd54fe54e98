#include "model/nodal_measure.hpp"

#include <cmath>

#include "base/small_matrix.hpp"
#include "fem/cell_types.hpp"
#include "fem/shape_table.hpp"

namespace ixos {
namespace {

/// Of an element of dimension `Element::dimension` in a space of S dimensions.
template <class Element, std::size_t S>
void add(const LocalMesh& mesh, const std::vector<int>& nodes, const std::array<double, Element::nodes>& scale,
         const ShapeTable<Element>& table, std::vector<double>& measure) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  for (std::size_t q = 0; q < table.size(); ++q) {
    Small<double, S, D> jacobian{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < S; ++i)
        for (std::size_t d = 0; d < D; ++d)
          jacobian[i][d] +=
              scale[a] * mesh.coordinates[static_cast<std::size_t>(nodes[a]) * S + i] * table.gradient[q][a][d];
    double volume;
    if constexpr (D == S) {
      volume = determinant(jacobian);
    } else if constexpr (D == 1) {
      volume = std::hypot(jacobian[0][0], jacobian[1][0]);
    } else {
      std::array<double, 3> normal;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = jacobian[j][0] * jacobian[k][1] - jacobian[k][0] * jacobian[j][1];
      }
      volume = std::hypot(normal[0], normal[1], normal[2]);
    }
    for (std::size_t a = 0; a < N; ++a)
      measure[static_cast<std::size_t>(nodes[a])] += table.weight[q] * volume * scale[a] * table.value[q][a];
  }
}

}  // namespace

void add_block_measure(const LocalMesh& mesh, const LocalBlock& block, std::vector<double>& measure) {
  with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    const ShapeTable<Element> table;
    std::array<double, Element::nodes> scale;
    for (int cell = 0; cell < block.cells(); ++cell) {
      const auto first = block.nodes.begin() + static_cast<std::ptrdiff_t>(cell_entry(cell, Element::nodes));
      for (std::size_t a = 0; a < scale.size(); ++a) scale[a] = node_scale(block, cell, static_cast<int>(a));
      add<Element, Element::dimension>(mesh, {first, first + Element::nodes}, scale, table, measure);
    }
  });
}

void add_side_measure(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::vector<double>& measure) {
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    with_side_element(block.type, side.side, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      static const ShapeTable<Element> table;
      const std::vector<int>& numbers = side_nodes(block.type, side.side);
      std::array<double, Element::nodes> scale;
      for (std::size_t a = 0; a < scale.size(); ++a) scale[a] = node_scale(block, side.cell, numbers[a]);
      add<Element, Element::dimension + 1>(mesh, side.nodes, scale, table, measure);
    });
  }
}

}  // namespace ixos
