/// Sides of one element type in SIMD batches: quadrature, measure, and where their points are.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "discretization/element_batches.hpp"
#include "fem/shape_grid.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/local_mesh.hpp"
#include "term/interaction.hpp"

namespace ixos {

template <class SideElement>
class SurfaceSides {
 public:
  static constexpr std::size_t D = SideElement::dimension + 1;
  static constexpr std::size_t N = SideElement::nodes;
  using Vectors = Small<Pack, N, D>;

  /// `points`: Gauss points a direction; 0: 5, but 8 on sides of order 3 or more.
  SurfaceSides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, int points)
      : quadrature_(counts(points), ties(mesh, sides)),
        grid_(shape_grid<SideElement>(grid_counts(), ties(mesh, sides))),
        batches_(node_table(sides), pattern, scale_table(mesh, sides)) {
    for (const LocalSide& side : sides) sides_.push_back({side.block, side.cell, side.side});
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      Vectors x;
      batches_.gather(b, mesh.coordinates.data(), x);
      reference_.push_back(x);
      for (std::size_t q = 0; q < quadrature_.size(); ++q) measure_.push_back(quadrature_.weight[q] * stretch(x, q));
      owned_.emplace_back([&](auto lane) {
        return lane < batches_.lanes(b) && sides[b * static_cast<std::size_t>(pack_width) + lane].owned ? 1.0 : 0.0;
      });
    }
  }

  const ShapeTable<SideElement>& quadrature() const { return quadrature_; }
  const ElementBatches<N, D>& batches() const { return batches_; }
  void place(const Pattern& pattern) { batches_.place(pattern); }
  std::size_t size() const { return batches_.size(); }  ///< batches
  /// Returns quadrature weight times reference length or area, by quadrature point.
  const Pack* measure(std::size_t b) const { return &measure_[b * quadrature_.size()]; }
  /// Returns 1 for sides that count on this rank, otherwise 0.
  const Pack& owned(std::size_t b) const { return owned_[b]; }
  /// Returns the lowest of the points of a grid on each side, its nodes and the points halfway between them. The gap of
  /// a batch's point is gaps_of(b)(shape functions there).
  template <class GapsOf>
  LowestPoint lowest_point(const double* u, const GapsOf& gaps_of) const {
    LowestPoint lowest;
    std::size_t batch = 0, lane = 0;
    const std::array<double, N>* shape = nullptr;
    for (std::size_t b = 0; b < size(); ++b) {
      const auto gap = gaps_of(b);
      for (const std::array<double, N>& here : grid_) {
        const Pack r = gap(here);
        if (!(least(r) < lowest.gap)) continue;
        lowest.gap = least(r);
        batch = b;
        shape = &here;
        for (lane = 0; r[lane] != lowest.gap;) ++lane;
      }
    }
    if (shape == nullptr) return lowest;
    Vectors displacement;
    batches_.gather(batch, u, displacement);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d)
        lowest.place[d] += (*shape)[a] * (reference_[batch][a][d][lane] + displacement[a][d][lane]);
    return lowest;
  }
  /// Returns nodal reference coordinates [L0]; those of a Hermite side's derivative nodes are derivatives.
  const Vectors& reference(std::size_t b) const { return reference_[b]; }
  /// Adds numbers that the nodes of a batch received through their shape functions to an array by local node.
  void add_nodal(std::size_t b, const std::array<Pack, N>& values, double* by_node) const {
    for_each_node(b, [&](std::size_t a, std::size_t lane, std::size_t node) {
      by_node[node] += batches_.scale(b, a, lane) * values[a][lane];
    });
  }
  /// Lowers an array by local node to the values of a batch's nodes; NaN stands for no value yet. A derivative node
  /// takes the value of the last side that has the least value at its corner.
  void lower_nodal(std::size_t b, const std::array<Pack, N>& values, double* by_node) const {
    std::array<std::array<bool, pack_width>, places> lowered{};
    for_each_node(b, [&](std::size_t a, std::size_t lane, std::size_t node) {
      const double value = values[a][lane] / batches_.scale(b, a, lane);
      bool& here = lowered[place_of(a)][lane];
      if (a < places) here = !(by_node[node] < value);
      if (here) by_node[node] = value;
    });
  }
  /// Adds, per local node, int N_a dA over the sides that are not counted yet, and counts them [L0^(D-1)].
  void add_nodal_measure(CountedSides& counted, double* measure_by_node) const {
    for (std::size_t b = 0; b < size(); ++b) {
      std::array<bool, pack_width> counts{};
      for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
        counts[lane] = counted.insert(sides_[b * static_cast<std::size_t>(pack_width) + lane]).second;
      for (std::size_t q = 0; q < quadrature_.size(); ++q)
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
            if (counts[lane])
              measure_by_node[static_cast<std::size_t>(batches_.first_dof(b, a, lane)) / D] +=
                  batches_.scale(b, a, lane) * quadrature_.value[q][a] * measure(b)[q][lane];
    }
  }

 protected:
  /// Nodes that are places; the others of a Hermite side are derivatives.
  static constexpr std::size_t places = IsHermite<SideElement>::value ? std::size_t{1} << (D - 1) : N;
  /// Derivatives that a Hermite side has at each corner.
  static constexpr std::size_t derivatives = D == 2 ? 1 : 3;
  /// Returns the node at whose place a node is: for a derivative, its corner.
  static constexpr std::size_t place_of(std::size_t a) { return a < places ? a : (a - places) / derivatives; }

 private:
  /// Calls visit(node of the side, lane, local node). Leaves out nodes of tied edges, whose shape functions are zero:
  /// other nodes stand in their places.
  template <class Visit>
  void for_each_node(std::size_t b, const Visit& visit) const {
    for (std::size_t a = 0; a < N; ++a) {
      bool counts = false;
      for (std::size_t q = 0; q < quadrature_.size(); ++q) counts = counts || quadrature_.value[q][a] != 0;
      for (std::size_t lane = 0; counts && lane < batches_.lanes(b); ++lane)
        visit(a, lane, static_cast<std::size_t>(batches_.first_dof(b, a, lane)) / D);
    }
  }

  static std::array<int, D - 1> counts(int points) {
    std::array<int, D - 1> result;
    const int own = SideElement::default_points[0] > 3 ? 8 : 5;  // beyond order 2 more
    result.fill(points > 0 ? points : own);
    return result;
  }

  static std::array<int, D - 1> grid_counts() {
    std::array<int, D - 1> result = SideElement::default_points;  // the order + 1, or more
    for (int& count : result) count = 2 * count - 1;
    return result;
  }

  /// Returns the tied edges, which are the same for all sides.
  static unsigned ties(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
    if (sides.empty()) return 0;
    return side_ties(mesh.blocks[static_cast<std::size_t>(sides.front().block)], sides.front().side);
  }

  static std::vector<double> scale_table(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
    std::vector<double> scales;
    if (places == N) return scales;
    for (const LocalSide& side : sides)
      for (std::size_t a = 0; a < N; ++a)
        scales.push_back(side_node_scale(mesh.blocks[static_cast<std::size_t>(side.block)], side.cell, side.side, a));
    return scales;
  }

  static std::vector<int> node_table(const std::vector<LocalSide>& sides) {
    std::vector<int> nodes;
    for (const LocalSide& side : sides) nodes.insert(nodes.end(), side.nodes.begin(), side.nodes.end());
    return nodes;
  }

  /// Returns the reference length or area per unit of the reference side at quadrature point q.
  Pack stretch(const Small<Pack, N, D>& x, std::size_t q) const {
    Small<Pack, D - 1, D> tangent{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t k = 0; k + 1 < D; ++k)
        for (std::size_t d = 0; d < D; ++d) tangent[k][d] += quadrature_.gradient[q][a][k] * x[a][d];
    Pack square = 0.0;
    if constexpr (D == 2) {
      square = tangent[0][0] * tangent[0][0] + tangent[0][1] * tangent[0][1];
    } else {
      for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
        const Pack component = tangent[0][e] * tangent[1][f] - tangent[0][f] * tangent[1][e];
        square += component * component;
      }
    }
    return std::experimental::sqrt(square);
  }

  std::vector<std::array<int, 3>> sides_;  ///< local block, cell and side
  ShapeTable<SideElement> quadrature_;
  std::vector<std::array<double, N>> grid_;  ///< shape functions at the points of lowest_point()
  ElementBatches<N, D> batches_;
  std::vector<Vectors> reference_;
  std::vector<Pack> measure_;  ///< batches x quadrature points
  std::vector<Pack> owned_;
};

}  // namespace ixos
