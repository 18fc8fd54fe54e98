/// Sides of one element type in SIMD batches: quadrature, measure, and where their points are.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "discretization/element_batches.hpp"
#include "fem/corner_element.hpp"
#include "fem/reference_elements.hpp"
#include "fem/revolved.hpp"
#include "fem/shape_grid.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/meridian.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos {

/// `Interface`: WallSides or what derives from it; its constructor takes the last arguments.
template <class SideElement, class Interface = WallSides<SideElement::dimension + 1>>
class SurfaceSides : public Interface {
 public:
  static constexpr std::size_t D = SideElement::dimension + 1;
  static constexpr std::size_t N = SideElement::nodes;
  using Interface::area;
  using Interface::size;
  using Vectors = Small<Pack, N, D>;

  /// `points`: Gauss points a direction; 0: 5, but 8 on sides of order 3 or more.
  template <class... Arguments>
  SurfaceSides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, int points,
               Arguments&&... arguments)
      : Interface(std::forward<Arguments>(arguments)...),
        quadrature_(rule(points), ties(mesh, sides)),
        grid_(shape_grid<SideElement>(grid_counts(), ties(mesh, sides))),
        batches_(node_table(sides), pattern, scale_table(mesh, sides)) {
    for (const LocalSide& side : sides) numbers_.push_back({side.block, side.cell, side.side});
    this->sides_ = sides.size();
    this->places_ = places_of(rule(points));
    for (const auto& shape : quadrature_.value) {
      double total = 0;
      for (const double value : shape) total += std::abs(value);
      this->total_shape_.push_back(total);
    }
    const std::vector<bool> axis = nodes_on_axis(mesh);
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      Vectors x;
      batches_.gather(b, mesh.coordinates.data(), x);
      reference_.push_back(x);
      for (std::size_t q = 0; q < quadrature_.size(); ++q)
        this->measure_.push_back(quadrature_.weight[q] * stretch(x, q) * around(mesh, x, q));
      if constexpr (D == 2)
        if (mesh.axisymmetric) no_ring_.push_back(nodes_without_ring(b, axis));
      this->owned_.emplace_back([&](auto lane) {
        return lane < batches_.lanes(b) && sides[b * static_cast<std::size_t>(pack_width) + lane].owned ? 1.0 : 0.0;
      });
    }
  }

  const ShapeTable<SideElement>& quadrature() const { return quadrature_; }
  const ElementBatches<N, D>& batches() const { return batches_; }
  void place(const Pattern& pattern) override { batches_.place(pattern); }
  void scale(const SurfaceFactor& factor) override {
    if (!factor.of_place && factor.of_node.empty()) return;
    this->area_ = this->measure_;
    for (std::size_t b = 0; b < size(); ++b)
      for (std::size_t q = 0; q < quadrature_.size(); ++q)
        for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane) {
          Pack& here = this->measure_[b * quadrature_.size() + q];
          if (factor.of_place) here[lane] = here[lane] * factor.of_place(place_of_point(b, q, lane));
          if (!factor.of_node.empty()) here[lane] = here[lane] * between_corners(factor.of_node, b, q, lane);
        }
  }
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
  bool may_be_coarsened() const override { return has_coarser_element<SideElement> || size() == 0; }
  /// Returns the weights w_a of quadrature point q in nodal means, int w_a T dA over int w_a dA: the shape functions
  /// N_a. At a node on the axis of an axisymmetric mesh, int N_a dA vanishes on sides of even order, because R is 0
  /// there. Then the weight is N_a/(2 pi R), which gives the mean over the section.
  std::array<Pack, N> nodal_weights(std::size_t b, std::size_t q) const {
    std::array<Pack, N> weights;
    for (std::size_t a = 0; a < N; ++a) weights[a] = quadrature_.value[q][a];
    if constexpr (D == 2)
      if (!no_ring_.empty())
        for (std::size_t a = 0; a < N; ++a)
          weights[a] = select(no_ring_[b][a] > 0.0, Pack(weights[a] / ring(b, q)), weights[a]);
    return weights;
  }
  /// Adds a number of quadrature point q to the nodes with its weights.
  void add_weighted(std::size_t b, std::size_t q, const Pack& value, std::array<Pack, N>& sums) const {
    const std::array<Pack, N> weights = nodal_weights(b, q);
    for (std::size_t a = 0; a < N; ++a) sums[a] += weights[a] * value;
  }
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
  /// Sets a local array at a batch's nodes to their vectors, except at derivative nodes.
  void set_nodal(std::size_t b, const Vectors& vectors, double* local) const {
    for_each_node(b, [&](std::size_t a, std::size_t lane, std::size_t node) {
      for (std::size_t i = 0; a < places && i < D; ++i) local[node * D + i] = vectors[a][i][lane];
    });
  }
  void add_weighted_nodal(std::size_t b, const Pack* values, double* by_node) const override {
    std::array<Pack, N> sums{};
    for (std::size_t q = 0; q < quadrature_.size(); ++q) add_weighted(b, q, values[q], sums);
    add_nodal(b, sums, by_node);
  }
  void add_nodal_measure(CountedSides& counted, double* measure_by_node) const override {
    for (std::size_t b = 0; b < size(); ++b) {
      std::array<bool, pack_width> counts{};
      for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
        counts[lane] = counted.insert(numbers_[b * static_cast<std::size_t>(pack_width) + lane]).second;
      for (std::size_t q = 0; q < quadrature_.size(); ++q) {
        const std::array<Pack, N> weights = nodal_weights(b, q);
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
            if (counts[lane])
              measure_by_node[static_cast<std::size_t>(batches_.first_dof(b, a, lane)) / D] +=
                  batches_.scale(b, a, lane) * weights[a][lane] * area(b)[q][lane];
      }
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
  std::array<double, 3> place_of_point(std::size_t b, std::size_t q, std::size_t lane) const {
    std::array<double, 3> place{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) place[d] += quadrature_.value[q][a] * reference_[b][a][d][lane];
    return place;
  }

  /// Returns the value at a quadrature point of numbers by local node. The first nodes of a side are its corners.
  double between_corners(const std::vector<double>& by_node, std::size_t b, std::size_t q, std::size_t lane) const {
    using Plain = std::conditional_t<HasRule<SideElement>::value, Tri3, Multilinear<static_cast<int>(D) - 1>>;
    std::array<double, Plain::nodes> shape;
    std::array<std::array<double, D - 1>, Plain::nodes> slope;
    Plain::evaluate(quadrature_.point[q], shape, slope);
    double sum = 0;
    for (std::size_t a = 0; a < shape.size(); ++a)
      sum += shape[a] * by_node[static_cast<std::size_t>(batches_.first_dof(b, a, lane)) / D];
    return sum;
  }

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

  /// Returns the rule with that many points along each direction; 0: 5, beyond order 2 more.
  static QuadratureRule<D - 1> rule(int points) {
    return element_rule<SideElement>(points > 0 ? points : most_nodes_along()[0] > 3 ? 8 : 5);
  }

  /// Returns the order + 1, or more, along each direction.
  static constexpr std::array<int, D - 1> most_nodes_along() {
    if constexpr (HasRule<SideElement>::value) {
      return {CellTraits<SideElement>::order + 1, CellTraits<SideElement>::order + 1};
    } else {
      return SideElement::default_points;
    }
  }

  static std::array<int, D - 1> grid_counts() {
    std::array<int, D - 1> result = most_nodes_along();
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

  /// Returns 2 pi R at a quadrature point of an axisymmetric mesh. Returns 1 instead of 0, on sides along the axis.
  Pack ring(std::size_t b, std::size_t q) const {
    const Pack length = circumference(reference_[b], quadrature_.value[q]);
    return select(length > 0.0, length, Pack(1.0));
  }

  /// Returns 1 at the nodes of a batch that are on the axis and whose int N_a dA is less than a twentieth of the
  /// longest ring times int N_a ds, otherwise 0. On sides of order 1 and 3 and of Hermite functions it is 0.13 to 0.33
  /// of that, on straight sides of order 2 and 4 it is 0.
  std::array<Pack, N> nodes_without_ring(std::size_t b, const std::vector<bool>& axis) const {
    std::array<Pack, N> result{};
    for (std::size_t a = 0; a < N; ++a) {
      Pack ring_area = 0.0, length = 0.0, longest = 0.0;
      for (std::size_t q = 0; q < quadrature_.size(); ++q) {
        const Pack measure = quadrature_.value[q][a] * this->measure_[b * quadrature_.size() + q];
        ring_area += measure;
        length += measure / ring(b, q);
        longest = std::experimental::max(longest, ring(b, q));
      }
      for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
        if (axis[static_cast<std::size_t>(batches_.first_dof(b, a, lane)) / D])
          result[a][lane] = ring_area[lane] < 0.05 * longest[lane] * length[lane] ? 1.0 : 0.0;
    }
    return result;
  }

  /// Returns 2 pi R of an axisymmetric mesh, otherwise 1.
  Pack around(const LocalMesh& mesh, const Small<Pack, N, D>& x, std::size_t q) const {
    if constexpr (D == 2)
      if (mesh.axisymmetric) return circumference(x, quadrature_.value[q]);
    return 1.0;
  }

  std::vector<std::array<int, 3>> numbers_;  ///< local block, cell and side
  ShapeTable<SideElement> quadrature_;
  std::vector<std::array<double, N>> grid_;  ///< shape functions at the points of lowest_point()
  ElementBatches<N, D> batches_;
  std::vector<Vectors> reference_;
  std::vector<std::array<Pack, N>> no_ring_;  ///< see nodes_without_ring(); empty if the mesh is not axisymmetric
};

}  // namespace ixos
