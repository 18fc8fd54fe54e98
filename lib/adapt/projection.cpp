#include "adapt/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adapt/field_at.hpp"
#include "base/small_matrix.hpp"
#include "fem/cell_info.hpp"
#include "fem/jacobian.hpp"
#include "fem/quadrature.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_table.hpp"
#include "fem/ties.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Collects the parts that a cell of another tree of the same whole cells has in common with the leaves of this one:
/// boxes overlap, simplices are one another's parts.
void collect(const SplitTree& tree, int k, const TreeCell& part, std::vector<TreeCell>& pieces) {
  const TreeCell& cell = tree.cell(k);
  TreeCell common = part;
  if (part.shape == TreeShape::Box) {
    for (std::size_t i = 0; i < at(tree.dimension()); ++i) {
      common.lower[i] = std::max(part.lower[i], cell.lower[i]);
      common.upper[i] = std::min(part.upper[i], cell.upper[i]);
      if (!(common.lower[i] < common.upper[i])) return;
    }
  } else if (!cell.contains(part)) {
    if (!part.contains(cell)) return;
    common = cell;
  }
  if (tree.is_leaf(k)) return pieces.push_back(common);
  collect(tree, cell.first_child, part, pieces);
  collect(tree, cell.first_child + 1, part, pieces);
}

/// Returns the volume of a box or a simplex in its root, up to a factor that all of one kind have.
double volume_of(const TreeCell& part) {
  double volume = 1;
  if (part.shape == TreeShape::Simplex) return std::exp2(-part.halvings[0]);
  for (std::size_t i = 0; i < at(part.dimension()); ++i) volume *= part.upper[i] - part.lower[i];
  return volume;
}

/// Returns a point of a part of a cell at reference coordinates of its shape.
RootPoint point_of(const TreeCell& part, const double* xi) {
  RootPoint point{part.block, part.root, part.place(0)};
  for (int k = 0; k < part.dimension(); ++k) {
    const bool is_box = part.shape == TreeShape::Box;
    const RootPlace end = part.place(is_box ? 1 << k : k + 1);
    const double share = is_box ? (xi[k] + 1) / 2 : xi[k];
    for (std::size_t i = 0; i < 3; ++i) point.at[i] += share * (end[i] - part.place(0)[i]);
  }
  return point;
}

class Projection {
 public:
  Projection(const SplitMesh& from, const std::vector<double>& v, const SplitMesh& to, const Model& model,
             const std::vector<double>& interpolated)
      : from_(from), v_(v), to_(to), model_(model), interpolated_(interpolated) {}

  std::vector<double> missing() {
    missing_.assign(static_cast<std::size_t>(model_.space().local()), 0.0);
    for (const Body& body : model_.bodies()) {
      const LocalBlock& block = model_.mesh().blocks[body.block];
      for (int cell = 0; cell < block.cells(); ++cell)
        add(block, cell, {static_cast<int>(body.block), block.original_cells[at(cell)]}, body.material.density);
    }
    model_.space().condense(missing_.data());
    return std::move(missing_);
  }

 private:
  void add(const LocalBlock& block, int local_cell, const SplitMesh::Cell& cell, double density) {
    const TreeCell& leaf = to_.tree().cell(to_.leaf_of(cell));
    const int around = from_.tree().around(leaf);
    if (from_.tree().is_leaf(around)) {
      const SplitMesh::Cell& old = from_.cell_of(around);
      const ElementBlock& before = from_.mesh().blocks[at(old.block)];
      const TreeCell& whole = from_.tree().cell(around);
      const bool is_same = whole.is_same_part(leaf);
      const bool are_plain = is_kept_by_parts(before.type) && is_kept_by_parts(block.type);
      const bool is_same_function = are_plain || (is_same && before.type == block.type && before.tied == block.tied);
      if (is_same_function && !follows_others(block, local_cell)) return;
    }
    std::vector<TreeCell> pieces;
    collect(from_.tree(), around, leaf, pieces);
    for (const TreeCell& piece : pieces) integrate(block, local_cell, cell, density, piece);
  }

  /// Returns whether the functions of a type of cells are functions of its parts, too.
  static bool is_kept_by_parts(CellType type) { return !is_enriched(type) && !cell_info(type).bubbles; }

  /// Returns whether a tied node of the cell has other values than the field before: cells beside it were joined.
  bool follows_others(const LocalBlock& block, int local_cell) const {
    const LocalMesh& mesh = model_.mesh();
    const auto d = at(mesh.dimension);
    const int n = nodes_per_cell(block.type);
    for (int a = 0; a < n; ++a) {
      const int node = block.nodes[cell_entry(local_cell, n, a)];
      if (!mesh.is_tied(node)) continue;
      const auto original = at(mesh.original_ids[at(node)]);
      if (!to_.places()[original]) continue;
      std::array<double, 3> before{};
      evaluate(from_, v_, d, *to_.places()[original], before.data());
      for (std::size_t i = 0; i < d; ++i)
        if (before[i] != interpolated_[original * d + i]) return true;
    }
    return false;
  }

  void integrate(const LocalBlock& block, int local_cell, const SplitMesh::Cell& cell, double density,
                 const TreeCell& piece) {
    with_element(block.type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      constexpr std::size_t D = Element::dimension;
      const QuadratureRule<D> rule = element_rule<Element>(is_enriched(block.type) || is_quadratic(block.type) ? 6 : 4);
      const TreeCell& leaf = to_.tree().cell(to_.leaf_of(cell));
      const int* const nodes = &block.nodes[cell_entry(local_cell, Element::nodes)];
      std::array<double, Element::nodes> ones, shape;
      ones.fill(1);
      std::array<std::array<double, D>, Element::nodes> slope;
      const double share = volume_of(piece) / volume_of(leaf);  // of the cell's reference volume
      for (std::size_t q = 0; q < rule.size(); ++q) {
        const RootPoint point = point_of(piece, rule.points[q].data());
        const std::array<double, 3> place = to_.reference_point(cell, point);
        std::array<double, D> xi;
        std::copy_n(place.begin(), D, xi.begin());
        evaluate_tied<Element>(block.tied, xi, shape, slope);
        double volume = std::abs(determinant(jacobian<D>(model_.mesh().coordinates, nodes, ones, slope)));
        if constexpr (D == 2)
          if (model_.mesh().axisymmetric) volume *= circumference(model_.mesh().coordinates, nodes, ones, shape);
        std::array<double, 3> difference{}, now{};
        evaluate(from_, v_, D, point, difference.data());
        evaluate(to_, interpolated_, D, point, now.data());
        const double weight = density * rule.weights[q] * share * volume;
        for (std::size_t a = 0; a < shape.size(); ++a)
          for (std::size_t i = 0; i < D; ++i)
            missing_[at(nodes[a]) * D + i] += weight * shape[a] * (difference[i] - now[i]);
      }
    });
  }

  const SplitMesh& from_;
  const std::vector<double>& v_;
  const SplitMesh& to_;
  const Model& model_;
  const std::vector<double>& interpolated_;
  std::vector<double> missing_;
};

}  // namespace

std::vector<double> missing_momentum(const SplitMesh& from, const std::vector<double>& v, const SplitMesh& to,
                                     const Model& model, const std::vector<double>& interpolated) {
  return Projection(from, v, to, model, interpolated).missing();
}

}  // namespace ixos
