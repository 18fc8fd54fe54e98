#include "mesh/quality.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "base/error.hpp"
#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/meridian.hpp"

namespace ixos {
namespace {

/// Throws InputError, with name(cell), for the first cell whose Jacobian is not positive.
template <class Element, class Block, class Name>
void check(const std::vector<double>& coordinates, const Block& block, const Name& name) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  auto rule = own_rule<Element>();
  if constexpr (HasRule<Element>::value && CellTraits<Element>::order == 2)  // curved ones invert near corners first
    for (std::size_t a = 0; a < N; ++a) {
      rule.points.push_back(Element::place(a));
      rule.weights.push_back(0);
    }
  const ShapeTable<Element> table(rule, block.tied);
  for (int cell = 0; cell < block.cells(); ++cell) {
    const auto scale = cell_scales<Element>(block, cell);
    for (const auto& gradient : table.gradient) {
      const double det = determinant(jacobian<D>(coordinates, &block.nodes[cell_entry(cell, N)], scale, gradient));
      if (!(det > 0))
        throw InputError(
            fmt::format("{}: inverted or degenerate (Jacobian {:.3g}); {}", name(cell), det,
                        HasRule<Element>::value && CellTraits<Element>::order == 2
                            ? "an edge is bent too much; make the mesh finer there, optimise its cells (gmsh: "
                              "Mesh.HighOrderOptimize = 1), or give linear cells and Cell Order 2"
                            : "its nodes must be ordered counter-clockwise, in a hexahedron the bottom face first"));
    }
  }
}

}  // namespace

void check_cells(const Mesh& mesh) {
  check_meridian(mesh);
  for (const ElementBlock& block : mesh.blocks)
    with_element(block.type, [&](auto element) {
      check<typename decltype(element)::type>(
          mesh.coordinates, block, [&](int cell) { return in_words(place_of(mesh, block, cell), mesh.dimension); });
    });
}

void check_cells(const LocalMesh& mesh) {
  check_meridian(mesh);
  for (const LocalBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    const auto name = [&](int cell) {
      std::vector<long long> nodes(static_cast<std::size_t>(n));
      for (int a = 0; a < n; ++a)
        nodes[static_cast<std::size_t>(a)] =
            mesh.program_id(static_cast<std::size_t>(block.nodes[cell_entry(cell, n, a)]));
      return fmt::format("block \"{}\", the cell with nodes {} at {}", block.name, fmt::join(nodes, ", "),
                         point_in_words(cell_centre(mesh, block, cell), mesh.dimension));
    };
    with_element(block.type,
                 [&](auto element) { check<typename decltype(element)::type>(mesh.coordinates, block, name); });
  }
}

}  // namespace ixos
