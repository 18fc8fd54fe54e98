#include "discretization/nodal_measure.hpp"

#include <cmath>
#include <map>
#include <type_traits>

#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Adds the integrals of an element of dimension `Element::dimension` in a space of S dimensions.
template <class Element, std::size_t S>
void add(const LocalMesh& mesh, const int* nodes, const std::array<double, Element::nodes>& scale,
         const ShapeTable<Element>& table, std::vector<double>& measure) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  for (std::size_t q = 0; q < table.size(); ++q) {
    const auto tangents = jacobian<S>(mesh.coordinates, nodes, scale, table.gradient[q]);
    double volume;
    if constexpr (D == S) {
      volume = determinant(tangents);
    } else if constexpr (D == 1) {
      volume = std::hypot(tangents[0][0], tangents[1][0]);
    } else {
      std::array<double, 3> normal;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = tangents[j][0] * tangents[k][1] - tangents[k][0] * tangents[j][1];
      }
      volume = std::hypot(normal[0], normal[1], normal[2]);
    }
    if (mesh.axisymmetric) volume *= circumference(mesh.coordinates, nodes, scale, table.value[q]);
    for (std::size_t a = 0; a < N; ++a)
      measure[static_cast<std::size_t>(nodes[a])] += table.weight[q] * volume * scale[a] * table.value[q][a];
  }
}

}  // namespace

void add_block_measure(const LocalMesh& mesh, const LocalBlock& block, std::vector<double>& measure) {
  with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    const ShapeTable<Element> table(mass_rule<Element>(), block.tied);
    for (int cell = 0; cell < block.cells(); ++cell)
      add<Element, Element::dimension>(mesh, &block.nodes[cell_entry(cell, Element::nodes)],
                                       cell_scales<Element>(block, cell), table, measure);
  });
  mesh.ties.condense(measure.data(), 1);
}

void add_side_measure(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::vector<double>& measure) {
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    with_side_element(block.type, side.side, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      static std::map<unsigned, ShapeTable<Element>> tables;  // by tied edges
      const unsigned tied = side_ties(block, side.side);
      auto rule = mass_rule<Element>();
      if constexpr (std::is_same_v<Element, Quad4CH>)  // as many as the face has along the same edge
        rule = product_rule(std::array<int, 2>{HermiteFace::default_points[0], Quad4CH::default_points[1]});
      const auto& table = tables.try_emplace(tied, rule, tied).first->second;
      std::array<double, Element::nodes> scale;
      for (std::size_t a = 0; a < scale.size(); ++a) scale[a] = side_node_scale(block, side.cell, side.side, a);
      add<Element, Element::dimension + 1>(mesh, side.nodes.data(), scale, table, measure);
    });
  }
  mesh.ties.condense(measure.data(), 1);
}

}  // namespace ixos
