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
#include "fem/ties.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A box in a whole cell.
struct Box {
  std::array<double, 3> lower, upper;
};

/// Collects what the leaves of a tree cut out of a box.
void collect(const SplitTree& tree, int k, const Box& box, std::vector<Box>& pieces) {
  const TreeCell& cell = tree.cell(k);
  Box cut = box;
  for (std::size_t i = 0; i < at(tree.dimension()); ++i) {
    cut.lower[i] = std::max(box.lower[i], cell.lower[i]);
    cut.upper[i] = std::min(box.upper[i], cell.upper[i]);
    if (!(cut.lower[i] < cut.upper[i])) return;
  }
  if (tree.is_leaf(k)) return pieces.push_back(cut);
  collect(tree, cell.first_child, box, pieces);
  collect(tree, cell.first_child + 1, box, pieces);
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
      const bool is_same = whole.lower == leaf.lower && whole.upper == leaf.upper;
      const bool are_plain = !is_enriched(before.type) && !is_enriched(block.type);
      const bool is_same_function = are_plain || (is_same && before.type == block.type && before.tied == block.tied);
      if (is_same_function && !follows_others(block, local_cell)) return;
    }
    std::vector<Box> pieces;
    collect(from_.tree(), around, {leaf.lower, leaf.upper}, pieces);
    for (const Box& piece : pieces) integrate(block, local_cell, cell, density, piece);
  }

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
                 const Box& piece) {
    with_element(block.type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      constexpr std::size_t D = Element::dimension;
      std::array<int, D> along;
      along.fill(is_enriched(block.type) || is_quadratic(block.type) ? 6 : 4);
      const QuadratureRule<D> rule = product_rule<D>(along);
      const TreeCell& leaf = to_.tree().cell(to_.leaf_of(cell));
      const int* const nodes = &block.nodes[cell_entry(local_cell, Element::nodes)];
      std::array<double, Element::nodes> ones, shape;
      ones.fill(1);
      std::array<std::array<double, D>, Element::nodes> slope;
      double share = 1;  // of the cell's reference volume
      for (std::size_t i = 0; i < D; ++i) share *= (piece.upper[i] - piece.lower[i]) / (leaf.upper[i] - leaf.lower[i]);
      for (std::size_t q = 0; q < rule.size(); ++q) {
        RootPoint point{leaf.block, leaf.root, {}};
        for (std::size_t i = 0; i < D; ++i)
          point.at[i] = piece.lower[i] + (rule.points[q][i] + 1) / 2 * (piece.upper[i] - piece.lower[i]);
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
