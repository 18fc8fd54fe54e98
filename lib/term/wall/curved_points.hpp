/// The quadrature points of a surface before an obstacle of any shape.
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/scratch.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/passage.hpp"
#include "term/wall/point_laws.hpp"
#include "term/wall/side_ends.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos {

/// Sides in D dimensions, the law that acts on them, and the obstacle. At a point x with gap g, normal n and second
/// derivatives H of the gap, the force per reference area is -T n and its tangent psi'' n n^T - T H.
template <std::size_t D>
class CurvedPoints {
 protected:
  using Sides = CurvedWallSides<D>;
  using Ends = SideEnds<D>;
  using Matrix = Small<Pack, D>;

  CurvedPoints(const LocalMesh& mesh, const std::vector<LocalSide>& group, std::unique_ptr<Sides> sides,
               const std::shared_ptr<const GapLaw>& law, std::shared_ptr<const Obstacle> obstacle)
      : obstacle_(std::move(obstacle)),
        sides_(std::move(sides)),
        laws_(mesh, group, sides_->reference_places(), law),
        range_(law->range()) {}

  /// The force and its derivative at a quadrature point, times the measure.
  struct Response {
    PackPoint traction{};  ///< T n, the mean over the rule
    Matrix stiffness{};    ///< the derivative of -traction by the displacement at the end of the segment
    Pack least_gap = std::numeric_limits<double>::infinity();  ///< of the time points and the end
  };

  /// Returns the traction if With has Traction, the stiffness if it has Stiffness, and the least gap with the traction.
  /// The convex kind leaves out each part of the stiffness that is negative.
  enum With { Traction = 1, Stiffness = 2 };
  template <int What>
  Response respond(const PointLaws::Kept& laws, const Ends& ends, std::size_t b, std::size_t q, const Rule& rule,
                   Tangent kind = Tangent::Exact) const {
    constexpr bool traction = (What & Traction) != 0, stiffness = (What & Stiffness) != 0;
    const bool convex = kind == Tangent::Convex;
    const GapLawAt law = laws.at(b, q);
    const auto kept = [&](const Pack& x) { return convex ? select(x > 0.0, x, Pack(0.0)) : x; };
    Response result;
    bool end_is_seen = false;
    for (const RulePoint& point : rule.points) {
      const PackPoint x = ends.at(q, point);
      if (is_out_of_range(x)) continue;
      const ObstacleGap found = stiffness ? obstacle_->at(x) : obstacle_->gap_and_normal(x);
      const Pack pressure = law.traction(found.gap);
      if (traction) {
        add(point.weight * pressure, found.normal, found.gap, result);
        end_is_seen = end_is_seen || (point.to == 1 && point.from == 0 && point.velocity == 0);
      }
      if (!stiffness) continue;
      const double weight = point.weight * point.to;
      const Pack along = weight * kept(law.stiffness(found.gap));
      const Pack across = weight * bending_factor(found, pressure, convex);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          result.stiffness[i][j] += along * (found.normal[i] * found.normal[j]) + across * found.bend[i][j];
    }
    if (rule.mean != Mean::Points) {
      const MeanGap mean = obstacle_->mean(ends.from(q), ends.to(q));
      const Pack pressure = law.mean_traction(mean.start_gap, mean.end_gap);
      if (traction) add(pressure, mean.normal, mean.end_gap, result);
      const Pack along = stiffness ? kept(law.mean_stiffness(mean.start_gap, mean.end_gap)) : Pack(0.0);
      const Pack across = convex ? Pack(0.0) : Pack(-pressure);
      for (std::size_t i = 0; stiffness && i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          result.stiffness[i][j] += along * (mean.normal[i] * mean.end_normal[j]) + across * mean.slope[i][j];
    } else if (traction && !end_is_seen) {
      result.least_gap = smaller(result.least_gap, obstacle_->gap_or_less(ends.to(q)));
    }
    const Pack& measure = sides_->measure(b)[q];
    if (traction)
      for (Pack& value : result.traction) value *= measure;
    if (stiffness)
      for (auto& row : result.stiffness)
        for (Pack& value : row) value *= measure;
    return result;
  }

  /// Returns whether a state with that least gap is admissible. Minus infinity is beyond the edge of the obstacle.
  bool is_allowed(const Pack& least_gap) const {
    const bool positive = laws_.domain() == GapDomain::Positive;
    return least(least_gap) > (positive ? 0 : -std::numeric_limits<double>::infinity());
  }

  Matrix stiffness(const PointLaws::Kept& laws, const Ends& ends, std::size_t b, std::size_t q, const Rule& rule,
                   Tangent kind) const {
    return respond<Stiffness>(laws, ends, b, q, rule, kind).stiffness;
  }

  /// Returns the sum of visit(law, place, found, weight, area) over the points of sides that count on this rank;
  /// `weight` is the measure, `area` the one without the factor.
  template <class Visit>
  double sum_over_points(const PointLaws::Kept& laws, const double* u, const Visit& visit) const {
    Pack sum = 0.0;
    for_each_place(u, [&](std::size_t b, std::size_t q, const PackPoint& x) {
      const Pack& owned = sides_->owned(b);
      sum += visit(laws.at(b, q), x, obstacle_->at(x), Pack(owned * sides_->measure(b)[q]),
                   Pack(owned * sides_->area(b)[q]));
    });
    return total(sum);
  }

  /// Calls visit(batch, quadrature point, place).
  template <class Visit>
  void for_each_place(const double* u, const Visit& visit) const {
    Scratch<PackPoint> x(sides_->points());
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      sides_->places(b, u, x.data());
      for (std::size_t q = 0; q < x.size(); ++q) visit(b, q, x[q]);
    }
  }

  /// See Admissibility::passage().
  LowestPoint find_passage(const double* from, const double* to) const {
    const double scale = laws_.equilibrium_gap(), short_way = scale / 8;
    LowestPoint lowest;
    Ends ends(*sides_, Ends::Of::Places, {from, nullptr, to});
    for (std::size_t b = 0; b < sides_->size(); ++b) {
      if (everywhere(sides_->longest_way_square(b, from, to) <= short_way * short_way)) continue;
      ends.set(b);
      for (std::size_t q = 0; q < sides_->points(); ++q) {
        const PackPoint &x0 = ends.from(q), &x1 = ends.to(q);
        const Pack looks = may_pass(*obstacle_, x0, x1, scale);
        if (everywhere(looks == 0.0)) continue;
        for (std::size_t k = 0; k < sides_->lanes(b); ++k) {
          if (looks[k] == 0) continue;
          const std::array<double, 3> last{x1[0][k], x1[1][k], x1[2][k]};
          const WayThrough way = way_through(*obstacle_, {x0[0][k], x0[1][k], x0[2][k]}, last);
          if (has_passed(way, scale) && way.deepest < lowest.gap) lowest = {way.deepest, last};
        }
      }
    }
    return lowest;
  }

  /// See SurfaceInteractionTerm.
  template <class Visit>
  void for_each_gap(const double* u, const Visit& visit) const {
    for_each_place(u, [&](std::size_t b, std::size_t q, const PackPoint& x) {
      visit(b, q, obstacle_->gap(x), Pack(sides_->owned(b) * sides_->measure(b)[q]));
    });
  }

  std::shared_ptr<const Obstacle> obstacle_;
  std::unique_ptr<Sides> sides_;
  PointLaws laws_;

 private:
  /// Returns whether no force acts at a place in any lane.
  bool is_out_of_range(const PackPoint& x) const {
    return range_ < std::numeric_limits<double>::infinity() && least(obstacle_->gap_or_less(x)) >= range_;
  }

  double range_;

  static void add(const Pack& pressure, const PackPoint& normal, const Pack& gap, Response& response) {
    for (std::size_t i = 0; i < D; ++i) response.traction[i] += pressure * normal[i];
    response.least_gap = smaller(response.least_gap, gap);
  }

  /// Returns -T, the factor of H. The convex kind leaves it out where -T H has a negative trace: before convex
  /// obstacles in repulsion, in cavities in attraction.
  static Pack bending_factor(const ObstacleGap& found, const Pack& pressure, bool convex) {
    Pack trace = 0.0;
    for (std::size_t i = 0; i < D; ++i) trace += found.bend[i][i];
    const Pack factor = -pressure;
    return convex ? select(factor * trace > 0.0, factor, Pack(0.0)) : factor;
  }
};

}  // namespace ixos
