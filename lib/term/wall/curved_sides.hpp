/// Sides before an obstacle of any shape: from displacements to the places of quadrature points.
#pragma once
#include <array>
#include <cstddef>

#include "interaction/obstacle.hpp"
#include "term/force_term.hpp"
#include "term/wall/surface_sides.hpp"

namespace ixos {

/// Nodal arrays of a batch of sides are vectors.
template <class SideElement>
class CurvedSides : public SurfaceSides<SideElement> {
  using Base = SurfaceSides<SideElement>;

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

  /// Returns the gaps of a batch's nodes; `sight_of`(place) is the obstacle's Sight. At derivative nodes they are the
  /// gap's derivatives: n . x_s, and for a mixed derivative n . x_st + x_s . H x_t with the gap's second derivatives H.
  template <class SightOf>
  std::array<Pack, N> nodal_gaps(std::size_t b, const double* u, const SightOf& sight_of) const {
    const Vectors x = places_of(b, u);
    std::array<Pack, N> gaps;
    for (std::size_t a = 0; a < N; ++a) {
      PackPoint point{};
      for (std::size_t i = 0; i < D; ++i) point[i] = x[Base::place_of(a)][i];
      const Sight sight = sight_of(point);
      gaps[a] = sight.gap;
      if (a < Base::places) continue;
      gaps[a] = 0.0;
      for (std::size_t i = 0; i < D; ++i) gaps[a] += sight.normal[i] * x[a][i];
      if ((a - Base::places) % Base::derivatives < 2) continue;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) gaps[a] += sight.bend[i][j] * x[a - 2][i] * x[a - 1][j];
    }
    return gaps;
  }

  /// Returns the obstacle's unit normals at a batch's nodes, nothing at derivative nodes. Zero where the gap has no
  /// direction.
  template <class SightOf>
  Vectors nodal_normals(std::size_t b, const double* u, const SightOf& sight_of) const {
    const Vectors x = places_of(b, u);
    Vectors normals{};
    for (std::size_t a = 0; a < Base::places; ++a) {
      PackPoint point{};
      for (std::size_t i = 0; i < D; ++i) point[i] = x[a][i];
      const Sight sight = sight_of(point);
      Pack square = 0.0;
      for (std::size_t i = 0; i < D; ++i) square += sight.normal[i] * sight.normal[i];
      // The gradient of a vertical gap is longer than 1.
      const Pack length = std::experimental::sqrt(select(square > 0.0, square, Pack(1.0)));
      for (std::size_t i = 0; i < D; ++i) normals[a][i] = sight.normal[i] / length;
    }
    return normals;
  }

  /// Adds the tangent of a batch from the matrices of its quadrature points.
  void scatter_tangent(std::size_t b, const Small<Pack, D>* matrices, double* values) const {
    Small<Pack, N * D> tangent;
    sum_over_points(quadrature(), matrices, tangent);
    batches().scatter_tangent(b, tangent, values);
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

  /// Places of one batch's quadrature points along a segment. The sides must outlive it.
  class Ends {
   public:
    Ends(const CurvedSides& sides, std::size_t b, const Segment& segment)
        : sides_(sides), has_from_(segment.from != nullptr), has_velocity_(segment.velocity != nullptr) {
      to_ = sides.places_of(b, segment.to);
      if (has_from_) from_ = sides.places_of(b, segment.from);
      if (has_velocity_) velocity_ = sides.change_of(b, segment.velocity);
    }
    PackPoint to(std::size_t q) const { return sides_.interpolate(q, to_); }
    /// Returns the place at the start. The segment must have one.
    PackPoint from(std::size_t q) const { return sides_.interpolate(q, from_); }
    /// Returns the place at a time point.
    PackPoint at(std::size_t q, const RulePoint& point) const {
      PackPoint x = to(q);
      for (Pack& component : x) component *= point.to;
      const auto add = [&](double factor, const PackPoint& part) {
        for (std::size_t i = 0; i < 3; ++i) x[i] += factor * part[i];
      };
      if (has_from_) add(point.from, from(q));
      if (has_velocity_) add(point.velocity, sides_.interpolate(q, velocity_));
      return x;
    }

   private:
    const CurvedSides& sides_;
    bool has_from_, has_velocity_;
    Vectors to_, from_, velocity_;
  };
};

}  // namespace ixos
