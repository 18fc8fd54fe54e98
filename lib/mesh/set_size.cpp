#include "mesh/set_size.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fem/jacobian.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Returns the integral over the side element whose nodes these are.
template <class Element>
double integral(const Mesh& mesh, const std::array<int, Element::nodes>& nodes) {
  constexpr std::size_t D = Element::dimension, S = D + 1;
  static const ShapeTable<Element> table;
  std::array<double, Element::nodes> ones;
  ones.fill(1);
  double sum = 0;
  for (std::size_t q = 0; q < table.size(); ++q) {
    const Small<double, S, D> t = jacobian<S>(mesh.coordinates, nodes.data(), ones, table.gradient[q]);
    double size = 0;
    if constexpr (D == 1) {
      size = std::hypot(t[0][0], t[1][0]);
    } else {
      const auto product = [&t](std::size_t i, std::size_t j) { return t[i][0] * t[j][1] - t[j][0] * t[i][1]; };
      size = std::hypot(product(1, 2), product(2, 0), product(0, 1));
    }
    if constexpr (S == 2) {
      if (mesh.axisymmetric) size *= circumference(mesh.coordinates, nodes.data(), ones, table.value[q]);
    }
    sum += table.weight[q] * size;
  }
  return sum;
}

}  // namespace

double side_measure(const Mesh& mesh, const Side& side) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  const CellType type = plain_type(block.type);
  return with_side_element(type, side.side, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    std::array<int, Element::nodes> nodes{};
    const std::vector<int>& local = side_nodes(type, side.side);
    for (std::size_t a = 0; a < nodes.size(); ++a)
      nodes[a] = block.nodes[cell_entry(side.cell, nodes_per_cell(block.type), local[a])];
    return integral<Element>(mesh, nodes);
  });
}

std::vector<SetSize> set_sizes(const Mesh& mesh) {
  std::vector<SetSize> sizes;
  for (const SideSet& set : mesh.side_sets) {
    sizes.push_back({set.name, true, set.sides.size(), 0});
    for (const Side& side : set.sides) sizes.back().measure += side_measure(mesh, side);
  }
  for (const NodeSet& set : mesh.node_sets) sizes.push_back({set.name, false, set.nodes.size(), 0});
  return sizes;
}

std::string in_words(const SetSize& size, int body_dimension) {
  const char* plural = size.count == 1 ? "" : "s";
  if (!size.of_sides) return fmt::format("node set {}: {} node{}", size.name, size.count, plural);
  return fmt::format("side set {}: {} side{}, {:.6g} {}", size.name, size.count, plural, size.measure,
                     body_dimension == 2 ? "L0" : "L0^2");
}

}  // namespace ixos
