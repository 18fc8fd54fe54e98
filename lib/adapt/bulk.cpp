#include "adapt/bulk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>

#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/simplex_nodes.hpp"
#include "fem/ties.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Gradient = std::array<double, 9>;

/// Returns the mean of the corners of an element.
template <class Element>
std::array<double, Element::dimension> corners_mean() {
  constexpr ReferenceShape shape = CellTraits<Element>::shape;
  if constexpr (shape == ReferenceShape::Quadrilateral || shape == ReferenceShape::Hexahedron) {
    return {};
  } else {
    NodeCorners all(Element::corners.size());
    std::iota(all.begin(), all.end(), 0);
    return middle_of(Element::corners, all);
  }
}

/// Returns du/dX at the middle of a cell.
Gradient middle_gradient(const Mesh& mesh, const ElementBlock& block, int cell, const std::vector<double>& u) {
  return with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension;
    std::array<double, Element::nodes> value, ones;
    std::array<std::array<double, D>, Element::nodes> slope;
    evaluate_tied<Element>(block.tied, corners_mean<Element>(), value, slope);
    ones.fill(1);
    const int* const nodes = &block.nodes[cell_entry(cell, Element::nodes)];
    const Small<double, D> map = jacobian<D>(mesh.coordinates, nodes, ones, slope);
    const Small<double, D> change = jacobian<D>(u, nodes, ones, slope);
    const Small<double, D> inverse = ixos::inverse(map, determinant(map));
    Gradient gradient{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k) gradient[3 * i + j] += change[i][k] * inverse[k][j];
    return gradient;
  });
}

/// Returns the number of halvings of a cell, along all its axes together.
int halvings(const TreeCell& cell) { return cell.halvings[0] + cell.halvings[1] + cell.halvings[2]; }

}  // namespace

BulkStrain::BulkStrain(const SplitMesh& mesh, const std::vector<double>& u, int directions)
    : mesh_(mesh), directions_(directions), jumps_(mesh.tree().cells().size(), 0.0) {
  const Mesh& own = mesh.mesh();
  std::vector<Gradient> middles;
  std::map<std::string, std::vector<Gradient>> sums;  // by name of the block: materials may differ
  std::map<std::string, std::vector<double>> counts;
  for (const ElementBlock& block : own.blocks) {
    sums[block.name].assign(at(own.nodes()), Gradient{});
    counts[block.name].assign(at(own.nodes()), 0.0);
  }
  const auto for_each_corner = [&](const auto& visit) {
    std::size_t number = 0;
    for (std::size_t b = 0; b < own.blocks.size(); ++b)
      for (int cell = 0; cell < own.blocks[b].cells(); ++cell, ++number)
        for (int a = 0; a < nodes_per_cell(corner_type(own.blocks[b].type)); ++a)
          visit(number, SplitMesh::Cell{static_cast<int>(b), cell},
                at(own.blocks[b].nodes[cell_entry(cell, nodes_per_cell(own.blocks[b].type), a)]), a);
  };
  for_each_corner([&](std::size_t number, const SplitMesh::Cell& cell, std::size_t node, int a) {
    if (a == 0) middles.push_back(middle_gradient(own, own.blocks[at(cell.block)], cell.cell, u));
    const std::string& name = own.blocks[at(cell.block)].name;
    for (std::size_t i = 0; i < 9; ++i) sums[name][node][i] += middles[number][i];
    counts[name][node] += 1;
  });
  for_each_corner([&](std::size_t number, const SplitMesh::Cell& cell, std::size_t node, int) {
    double squares = 0;
    const std::string& name = own.blocks[at(cell.block)].name;
    const double count = counts[name][node];
    for (std::size_t i = 0; i < 9; ++i) {
      const double jump = sums[name][node][i] / count - middles[number][i];
      squares += jump * jump;
    }
    double& largest = jumps_[at(mesh.leaf_of(cell))];
    largest = std::max(largest, std::sqrt(squares));
  });
}

double BulkStrain::in(int k, const TreeCell& cell) const {
  const TreeCell& own = mesh_.tree().cell(k);
  if (own.is_split()) return std::max(in(own.first_child, cell), in(own.first_child + 1, cell));
  return jumps_[at(k)] * std::exp2(static_cast<double>(halvings(own) - halvings(cell)) / directions_);
}

double BulkStrain::jump(const TreeCell& cell) const { return in(mesh_.tree().around(cell), cell); }

}  // namespace ixos
