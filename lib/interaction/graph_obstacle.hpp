/// Walls that are graphs z = h(a): waves and rough surfaces.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "interaction/closest_point_search.hpp"
#include "interaction/frame.hpp"
#include "interaction/obstacle.hpp"
#include "parameters/options.hpp"

namespace ixos {

/// How the gap to a graph is measured.
enum class GapMeasure {
  Distance,  ///< to the nearest point
  Vertical   ///< z - h(a): cheaper, smooth everywhere, and right for flat bodies and small slopes
};

/// Adds the parameter "Gap" of a struct with a member `measure`.
template <class Parameters>
void add_gap_measure(Options<Parameters>& options) {
  options.choose("Gap", &Parameters::measure, {{"Distance", GapMeasure::Distance}, {"Vertical", GapMeasure::Vertical}},
                 "Distance: the gap is the distance from the nearest point of the wall; a law must end within the "
                 "radius of the deepest trough (Cutoff). Vertical: it is the height above the wall, for flat bodies "
                 "and slopes below 0.1.");
}

/// The wall z <= h(a) in the coordinates of a frame. At the projection of a point, w = sqrt(1 + p.p) and n = (-p,
/// 1)/w, the distance is g = (x - closest point) . n, and its second derivatives are -tau S tau^T/w with tau = [I; p^T]
/// and S = (I + p p^T)^-1 B J^-1. The vertical gap z - h has the gradient (-p, 1), which is no unit vector, and the
/// second derivatives -B.
///
/// `Surface` is that of find_closest_point(), and has highest() >= h, steepest() >= |p|, deepest(), the largest
/// eigenvalue of B, and to_edge(place): the distance from the edge along the wall, infinity without an edge. Places
/// beyond the edge have the gap minus infinity.
template <class Surface>
class GraphObstacle final : public Obstacle {
  static constexpr std::size_t M = Surface::variables;

 public:
  GraphObstacle(Surface surface, const Frame& frame, GapMeasure measure)
      : surface_(std::move(surface)),
        frame_(frame),
        measure_(measure),
        stretch_(std::sqrt(1 + surface_.steepest() * surface_.steepest())) {}

  /// A point farther than 1/max eigenvalue of B has no point of the graph as its only nearest one: where two have, a
  /// curve between them bends at least as much as the sphere about the point that touches both.
  double reach() const override {
    const bool smooth = measure_ == GapMeasure::Vertical || surface_.deepest() <= 0;
    return smooth ? std::numeric_limits<double>::infinity() : 1 / surface_.deepest();
  }

  [[gnu::flatten]] ObstacleGap at(const PackPoint& x) const override { return obstacle_gap<true>(x); }
  [[gnu::flatten]] ObstacleGap gap_and_normal(const PackPoint& x) const override { return obstacle_gap<false>(x); }

  [[gnu::flatten]] Pack gap(const PackPoint& x) const override {
    const PackPoint local = frame_.to_local(x);
    return within_edge(local, measure_ == GapMeasure::Vertical ? height_above(local) : nearest(local).gap);
  }

  /// Above the highest point, the height over it. Elsewhere above the graph, the distance is at least the height over
  /// the largest w; below, it is at most the height.
  Pack gap_or_less(const PackPoint& x) const override {
    const PackPoint local = frame_.to_local(x);
    const Pack over_all = local[2] - surface_.highest();
    if (everywhere(over_all > 0.0)) return within_edge(local, over_all);
    const Pack height = height_above(local);
    const bool vertical = measure_ == GapMeasure::Vertical;
    return within_edge(local, vertical ? height : select(height > 0.0, Pack(height / stretch_), height));
  }

  /// From lower_gap(), and no farther than the edge.
  Pack free_way(const PackPoint& x, const Pack& least) const override {
    const PackPoint local = frame_.to_local(x);
    return smaller(lower_gap(local) - least / slowest(), surface_.to_edge(along(local)));
  }

  /// From 9 points of the path: between two of them the gap falls by no more than the length allows.
  Pack least_gap(const PackPoint& x0, const PackPoint& x1) const override {
    constexpr int parts = 8;
    PackPoint d;
    for (std::size_t i = 0; i < 3; ++i) d[i] = x1[i] - x0[i];
    const Pack length = length_of(d) / parts;
    Pack result = std::numeric_limits<double>::infinity(), before = 0.0;
    for (int k = 0; k <= parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      const PackPoint x{x0[0] + s * d[0], x0[1] + s * d[1], x0[2] + s * d[2]};
      const PackPoint local = frame_.to_local(x);
      const Pack gap = within_edge(local, lower_gap(local));
      if (k > 0) result = smaller(result, Pack(0.5 * (before + gap - length)));
      before = gap;
    }
    return slowest() * result;
  }

  /// Roundings of the coordinates, and of the height through the slope.
  Pack size_at(const PackPoint& x) const override {
    return 8 * stretch_ * (length_of(frame_.to_local(x)) + length_of(x));
  }

 private:
  static GraphPoint<M> along(const PackPoint& local) {
    GraphPoint<M> place;
    for (std::size_t i = 0; i < M; ++i) place[i] = local[i];
    return place;
  }

  /// Returns how much the gap changes at most over a unit of length.
  double slowest() const { return measure_ == GapMeasure::Vertical ? stretch_ : 1.0; }

  /// Returns the gap of a point on the graph's side of the edge, minus infinity beyond.
  Pack within_edge(const PackPoint& local, const Pack& gap) const {
    return select(surface_.to_edge(along(local)) >= 0.0, gap, Pack(-std::numeric_limits<double>::infinity()));
  }

  Pack height_above(const PackPoint& local) const { return local[2] - surface_.at(along(local)).value; }

  /// Returns the gap over slowest(), or less. Above the graph, the distance is at least the height over the largest w,
  /// and at least the reach where the closest point is beyond it. Below, it is at most that of any closest point.
  Pack lower_gap(const PackPoint& local) const {
    const Pack height = height_above(local);
    if (measure_ == GapMeasure::Vertical) return height / stretch_;
    const Pack gap = nearest(local).gap, known = smaller(gap, Pack(share_of_reach / surface_.sharpest()));
    return select(height > 0.0, std::experimental::max(Pack(height / stretch_), known), gap);
  }

  template <bool bends>
  ObstacleGap obstacle_gap(const PackPoint& x) const {
    const PackPoint local = frame_.to_local(x);
    ObstacleGap found = measure_ == GapMeasure::Vertical ? vertical(local) : from<bends>(nearest(local));
    found.gap = within_edge(local, found.gap);
    return found;
  }

  ObstacleGap vertical(const PackPoint& local) const {
    const Height<M> height = surface_.at(along(local));
    Small<Pack, M> bend;
    for (std::size_t i = 0; i < M; ++i)
      for (std::size_t j = 0; j < M; ++j) bend[i][j] = -height.bend[i][j];
    ObstacleGap found;
    found.gap = local[2] - height.value;
    found.normal = frame_.to_space(upward(height.slope));
    set_bend(
        bend,
        [](std::size_t k) {
          PackPoint e{};
          e[k] = 1.0;
          return e;
        },
        found);
    return found;
  }

  /// The nearest point of the graph.
  struct Nearest {
    ClosestPoint<M> projection;
    Pack lift, inverse_w, gap;  ///< height over the closest point, 1/w, distance
  };

  Nearest nearest(const PackPoint& local) const {
    const GraphPoint<M> x = along(local);
    Nearest result{find_closest_point(surface_, x, local[2]), {}, {}, {}};
    const ClosestPoint<M>& projection = result.projection;
    result.lift = local[2] - projection.height.value;
    Pack square = 1.0, gap = result.lift;
    for (std::size_t i = 0; i < M; ++i) {
      square += projection.height.slope[i] * projection.height.slope[i];
      gap -= (x[i] - projection.place[i]) * projection.height.slope[i];
    }
    result.inverse_w = 1.0 / std::experimental::sqrt(square);
    result.gap = gap * result.inverse_w;
    return result;
  }

  /// S is adj(G) B adj(J)/(w^2 det J), because det G = w^2.
  template <bool bends>
  ObstacleGap from(const Nearest& nearest) const {
    const std::array<Pack, M>& p = nearest.projection.height.slope;
    const Pack& w = nearest.inverse_w;
    PackPoint normal = upward(p);
    for (Pack& component : normal) component *= w;
    ObstacleGap found;
    found.gap = nearest.gap;
    found.normal = frame_.to_space(normal);
    if (!bends) return found;

    const GraphMetric<M> metric(nearest.projection.height, nearest.lift);
    const Small<Pack, M> jacobian = metric.positive_jacobian();
    const Pack factor = -w * w * w / determinant(jacobian);
    Small<Pack, M> s = product(adjugate(metric.g), product(nearest.projection.height.bend, adjugate(jacobian)));
    for (auto& row : s)
      for (Pack& value : row) value *= factor;
    set_bend(
        s,
        [&](std::size_t k) {
          PackPoint e{};
          e[k] = 1.0;
          e[2] = p[k];
          return e;
        },
        found);
    return found;
  }

  static PackPoint upward(const std::array<Pack, M>& slope) {
    PackPoint result{};
    for (std::size_t i = 0; i < M; ++i) result[i] = -slope[i];
    result[2] = 1.0;
    return result;
  }

  /// Sets the second derivatives sum_kl s_kl t_k t_l^T with the tangents t_k of given coordinates; s is symmetric.
  template <class Tangent>
  void set_bend(const Small<Pack, M>& s, const Tangent& tangent, ObstacleGap& found) const {
    std::array<PackPoint, M> t, st{};  // st_k = sum_l s_kl t_l
    for (std::size_t k = 0; k < M; ++k) t[k] = frame_.to_space(tangent(k));
    for (std::size_t k = 0; k < M; ++k)
      for (std::size_t l = 0; l < M; ++l)
        for (std::size_t i = 0; i < 3; ++i) st[k][i] += s[k][l] * t[l][i];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) {
        for (std::size_t k = 0; k < M; ++k) found.bend[i][j] += t[k][i] * st[k][j];
        found.bend[j][i] = found.bend[i][j];
      }
  }

  Surface surface_;
  Frame frame_;
  GapMeasure measure_;
  double stretch_;  ///< largest w
};

}  // namespace ixos
