/// The quadrature points of a surface before an obstacle of any shape.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "interaction/gap_law.hpp"
#include "term/curved_sides.hpp"

namespace ixos {

/// Sides of one element type, the law that acts on them, and the obstacle. At a point x with gap g, normal n and second
/// derivatives H of the gap, the force per reference area is -T n and its tangent psi'' n n^T - T H.
template <class SideElement>
class CurvedPoints {
 protected:
  using Sides = CurvedSides<SideElement>;
  using Ends = typename Sides::Ends;
  static constexpr std::size_t D = Sides::D;
  using Matrix = Small<Pack, D>;

  CurvedPoints(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
               const std::shared_ptr<const GapLaw>& law, std::shared_ptr<const Obstacle> obstacle, int points)
      : law_(law), obstacle_(std::move(obstacle)), sides_(mesh, sides, pattern, points) {}

  /// Returns the derivative of the force at a quadrature point by its displacement at the end of the segment, times the
  /// measure. The convex kind leaves out each part that is negative.
  Matrix stiffness(const Ends& ends, std::size_t b, std::size_t q, const Rule& rule, Tangent kind) const {
    const bool convex = kind == Tangent::Convex;
    const auto kept = [&](const Pack& x) { return convex ? select(x > 0.0, x, Pack(0.0)) : x; };
    Matrix k{};
    for (const RulePoint& point : rule.points) {
      const Sight sight = obstacle_->at(ends.at(q, point));
      const double weight = point.weight * point.to;
      const Pack along = weight * kept(law_.stiffness(sight.gap)), across = weight * bending_factor(sight, convex);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          k[i][j] += along * (sight.normal[i] * sight.normal[j]) + across * sight.bend[i][j];
    }
    if (rule.mean != Mean::Points) {
      const PackPoint from = ends.from(q), to = ends.to(q);
      const Sight end = obstacle_->at(to);
      const Pack start_gap = obstacle_->at(from).gap;
      const MeanSight mean = obstacle_->mean(from, to);
      const Pack along = kept(law_.mean_stiffness(start_gap, end.gap));
      const Pack across = convex ? Pack(0.0) : Pack(-law_.mean_traction(start_gap, end.gap));
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          k[i][j] += along * (mean.normal[i] * end.normal[j]) + across * mean.slope[i][j];
    }
    for (auto& row : k)
      for (Pack& value : row) value *= sides_.measure(b)[q];
    return k;
  }

  /// Returns the sum of visit(place, sight, weight) over the points of sides that count on this rank; `weight` is the
  /// measure.
  template <class Visit>
  double sum_over_points(const double* u, const Visit& visit) const {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      const Ends ends(sides_, b, {nullptr, nullptr, u});
      for (std::size_t q = 0; q < sides_.quadrature().size(); ++q) {
        const PackPoint x = ends.to(q);
        sum += visit(x, obstacle_->at(x), Pack(sides_.owned(b) * sides_.measure(b)[q]));
      }
    }
    return total(sum);
  }

  AnyGapLaw law_;
  std::shared_ptr<const Obstacle> obstacle_;
  Sides sides_;

 private:
  /// Returns -T, the factor of H. The convex kind leaves it out where -T H has a negative trace: before convex
  /// obstacles in repulsion, in cavities in attraction.
  Pack bending_factor(const Sight& sight, bool convex) const {
    Pack trace = 0.0;
    for (std::size_t i = 0; i < D; ++i) trace += sight.bend[i][i];
    const Pack factor = -law_.traction(sight.gap);
    return convex ? select(factor * trace > 0.0, factor, Pack(0.0)) : factor;
  }
};

}  // namespace ixos
