/// Sides before an obstacle of any shape: from displacements to the places of quadrature points.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>

#include "interaction/obstacle.hpp"
#include "term/wall/surface_sides.hpp"

namespace ixos {

/// Nodal arrays of a batch of sides are vectors. Where sides are made, term/wall/curved_sides_of.hpp is included.
template <class SideElement>
class CurvedSides final : public SurfaceSides<SideElement, CurvedWallSides<SideElement::dimension + 1>> {
  using Base = SurfaceSides<SideElement, CurvedWallSides<SideElement::dimension + 1>>;
  using Interface = CurvedWallSides<SideElement::dimension + 1>;
  using typename Interface::GapOf;

 public:
  using Base::Base;
  using Base::batches;
  using Base::D;
  using Base::N;
  using Base::quadrature;
  using typename Base::Vectors;

  /// Returns nodal places at displacement u, and the change of the places under a change of u. Those of a Hermite
  /// side's derivative nodes are derivatives.
  Vectors places_of(std::size_t b, const double* u) const {
    Vectors x = change_of(b, u);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) x[a][i] += this->reference(b)[a][i];
    return x;
  }
  Vectors change_of(std::size_t b, const double* local) const {
    Vectors values;
    batches().gather(b, local, values);
    return values;
  }

  /// Returns a nodal array's vector at quadrature point q.
  PackPoint interpolate(std::size_t q, const Vectors& nodal) const { return interpolate(quadrature().value[q], nodal); }
  /// Returns it where the shape functions have these values.
  static PackPoint interpolate(const std::array<double, N>& shape, const Vectors& nodal) {
    PackPoint sum{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) sum[i] += shape[a] * nodal[a][i];
    return sum;
  }

  /// Returns the gaps of a batch's nodes; `obstacle_gap`(place) is the obstacle's ObstacleGap. At derivative nodes they
  /// are the gap's derivatives: n . x_s, and for a mixed derivative n . x_st + x_s . H x_t with the gap's second
  /// derivatives H.
  template <class GapOf>
  std::array<Pack, N> nodal_gaps(std::size_t b, const double* u, const GapOf& obstacle_gap) const {
    const Vectors x = places_of(b, u);
    std::array<Pack, N> gaps;
    for (std::size_t a = 0; a < N; ++a) {
      PackPoint point{};
      for (std::size_t i = 0; i < D; ++i) point[i] = x[Base::place_of(a)][i];
      const ObstacleGap found = obstacle_gap(point);
      gaps[a] = found.gap;
      if (a < Base::places) continue;
      gaps[a] = 0.0;
      for (std::size_t i = 0; i < D; ++i) gaps[a] += found.normal[i] * x[a][i];
      if ((a - Base::places) % Base::derivatives < 2) continue;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) gaps[a] += found.bend[i][j] * x[a - 2][i] * x[a - 1][j];
    }
    return gaps;
  }

  /// Returns the obstacle's unit normals at a batch's nodes, nothing at derivative nodes. Zero where the gap has no
  /// direction.
  template <class GapOf>
  Vectors nodal_normals(std::size_t b, const double* u, const GapOf& obstacle_gap) const {
    const Vectors x = places_of(b, u);
    Vectors normals{};
    for (std::size_t a = 0; a < Base::places; ++a) {
      PackPoint point{};
      for (std::size_t i = 0; i < D; ++i) point[i] = x[a][i];
      const ObstacleGap found = obstacle_gap(point);
      Pack square = 0.0;
      for (std::size_t i = 0; i < D; ++i) square += found.normal[i] * found.normal[i];
      // The gradient of a vertical gap is longer than 1.
      const Pack length = std::experimental::sqrt(select(square > 0.0, square, Pack(1.0)));
      for (std::size_t i = 0; i < D; ++i) normals[a][i] = found.normal[i] / length;
    }
    return normals;
  }

  void places(std::size_t b, const double* u, PackPoint* x) const override { interpolate_all(places_of(b, u), x); }
  void changes(std::size_t b, const double* local, PackPoint* x) const override {
    interpolate_all(change_of(b, local), x);
  }

  void add_forces(std::size_t b, const PackPoint* t, double* f) const override {
    Vectors force{};
    for (std::size_t q = 0; q < quadrature().size(); ++q) {
      const auto& shape = quadrature().value[q];
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) force[a][i] += shape[a] * t[q][i];
    }
    batches().scatter_force(b, force, f);
  }
  void add_tangent(std::size_t b, const Small<Pack, D>* k, double* values) const override {
    Small<Pack, N * D> tangent;
    sum_over_points(quadrature(), k, tangent);
    batches().scatter_tangent(b, tangent, values);
  }
  void add_row_sums(std::size_t b, const PackPoint* t, double* sums) const override {
    Vectors rows{};
    for (std::size_t q = 0; q < quadrature().size(); ++q) {
      const auto& shape = quadrature().value[q];
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) rows[a][i] += std::abs(shape[a]) * t[q][i];
    }
    batches().scatter_force(b, rows, sums);
  }
  std::unique_ptr<typename Interface::Matrices> create_matrices() const override;

  Pack longest_way_square(std::size_t b, const double* from, const double* to) const override {
    const Vectors start = places_of(b, from), end = places_of(b, to);
    Pack square = 0.0;
    for (std::size_t a = 0; a < N; ++a) {
      Pack own = 0.0;
      for (std::size_t i = 0; i < D; ++i) own += (end[a][i] - start[a][i]) * (end[a][i] - start[a][i]);
      square = std::experimental::max(square, own);
    }
    return square;
  }
  LowestPoint lowest_gap(const double* u, const std::function<Pack(const PackPoint&)>& gap_of) const override {
    return this->lowest_point(u, [&](std::size_t b) {
      return [&gap_of, x = places_of(b, u)](const auto& shape) { return gap_of(interpolate(shape, x)); };
    });
  }
  void lower_nodal_gaps(const double* u, const GapOf& obstacle_gap, double* by_node) const override {
    for (std::size_t b = 0; b < this->size(); ++b) this->lower_nodal(b, nodal_gaps(b, u, obstacle_gap), by_node);
  }
  void set_nodal_normals(const double* u, const GapOf& obstacle_gap, double* local) const override {
    for (std::size_t b = 0; b < this->size(); ++b) this->set_nodal(b, nodal_normals(b, u, obstacle_gap), local);
  }

  /// Sets a tangent to the sum of N_a k N_c over the points of an element's table with a matrix k at each. The blocks
  /// of two nodes (a, c) and (c, a) are equal.
  template <class Element>
  static void sum_over_points(const ShapeTable<Element>& table, const Small<Pack, D>* matrices,
                              Small<Pack, Element::nodes * D>& tangent) {
    for (std::size_t a = 0; a < Element::nodes; ++a)
      for (std::size_t c = a; c < Element::nodes; ++c) {
        Small<Pack, D> sum{};  // stays in registers
        for (std::size_t q = 0; q < table.size(); ++q) {
          const double weight = table.value[q][a] * table.value[q][c];
          for (std::size_t i = 0; i < D; ++i)
            for (std::size_t j = 0; j < D; ++j) sum[i][j] += weight * matrices[q][i][j];
        }
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) tangent[a * D + i][c * D + j] = tangent[c * D + i][a * D + j] = sum[i][j];
      }
  }

 private:
  void interpolate_all(const Vectors& nodal, PackPoint* x) const {
    for (std::size_t q = 0; q < quadrature().size(); ++q) x[q] = interpolate(q, nodal);
  }
};

}  // namespace ixos
