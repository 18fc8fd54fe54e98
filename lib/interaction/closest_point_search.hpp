/// The point of a graph that is nearest to a place above or below it.
#pragma once
#include <array>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"

namespace ixos {

/// A height z = h(a) over M = 1 or 2 coordinates, with its first and second derivatives.
template <std::size_t M>
struct Height {
  Pack value;
  std::array<Pack, M> slope;  ///< p
  Small<Pack, M> bend;        ///< B
};

template <std::size_t M>
using GraphPoint = std::array<Pack, M>;

/// Returns the matrix of cofactors of a symmetric matrix, its inverse times its determinant.
template <std::size_t M>
Small<Pack, M> adjugate(const Small<Pack, M>& a) {
  if constexpr (M == 1)
    return {{{Pack(1.0)}}};
  else
    return {{{a[1][1], -a[0][1]}, {-a[1][0], a[0][0]}}};
}

/// The metric G = I + p p^T of a graph, and J = G - lift B at a height `lift` above it. J is positive definite at a
/// nearest point.
template <std::size_t M>
struct GraphMetric {
  GraphMetric(const Height<M>& height, const Pack& lift) {
    for (std::size_t i = 0; i < M; ++i)
      for (std::size_t j = 0; j < M; ++j) {
        g[i][j] = (i == j ? 1.0 : 0.0) + height.slope[i] * height.slope[j];
        jacobian[i][j] = g[i][j] - lift * height.bend[i][j];
      }
  }
  /// Returns G where J is not positive definite by a margin, and J elsewhere.
  Small<Pack, M> positive_jacobian() const {
    constexpr double margin = 0.02;
    auto positive = jacobian[0][0] > margin * g[0][0];
    if constexpr (M == 2) positive = positive && determinant(jacobian) > (margin * margin) * determinant(g);
    Small<Pack, M> result;
    for (std::size_t i = 0; i < M; ++i)
      for (std::size_t j = 0; j < M; ++j) result[i][j] = select(positive, jacobian[i][j], g[i][j]);
    return result;
  }
  Small<Pack, M> g, jacobian;
};

/// The closest point of a place: its coordinates and the height there.
template <std::size_t M>
struct ClosestPoint {
  GraphPoint<M> place;
  Height<M> height;
};

/// Returns what Newton's method subtracts from the closest point of the place (x, z).
template <std::size_t M>
std::array<Pack, M> newton_step(const ClosestPoint<M>& projection, const GraphPoint<M>& x, const Pack& z) {
  const Pack lift = z - projection.height.value;
  const Small<Pack, M> jacobian = GraphMetric<M>(projection.height, lift).positive_jacobian(),
                       factors = adjugate(jacobian);
  const Pack inverse = 1.0 / determinant(jacobian);
  GraphPoint<M> gradient;
  for (std::size_t i = 0; i < M; ++i)
    gradient[i] = ((projection.place[i] - x[i]) - lift * projection.height.slope[i]) * inverse;
  std::array<Pack, M> step{};
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t j = 0; j < M; ++j) step[i] += factors[i][j] * gradient[j];
  return step;
}

/// Subtracts a last step of Newton's method, in which the height follows its tangent and its bend.
template <std::size_t M>
void finish(const std::array<Pack, M>& step, ClosestPoint<M>& projection) {
  for (std::size_t i = 0; i < M; ++i) {
    projection.place[i] -= step[i];
    projection.height.value -= projection.height.slope[i] * step[i];
  }
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t j = 0; j < M; ++j) {
      projection.height.value += 0.5 * step[i] * projection.height.bend[i][j] * step[j];
      projection.height.slope[i] -= projection.height.bend[i][j] * step[j];
    }
}

/// See find_closest_point().
inline constexpr double share_of_reach = 0.95;

/// Finds the closest point a of the place (x, z), where (x - a) + (z - h) p = 0, by Newton's method with -J, as a
/// descent of the squared distance. Let r = 1/max|eigenvalues of B|. Within the distance r of the graph the closest
/// point is the only stationary point that near, so a descent finds it from any point of the graph within r of the
/// place. The search starts straight below the place, at a level less than r above the graph, and raises the level by
/// less than r minus the distance until it is z. A closest point nearer than share_of_reach r is therefore the nearest
/// one. Otherwise the true distance is at least share_of_reach r, and the result may be another stationary point.
///
/// The search ends with a step s in which the slope follows the second derivatives. They change by about their size 1/r
/// over the bend length l, so that the error of the slope is about s^2/(r l). The second derivatives are those before
/// that step: they are off by about s/(r l).
///
/// `Surface` has `variables`; reader(), whose at(place) returns the height; sharpest() = 1/r; bend_length() = l; and
/// kept(place, x): the place, or the end of the range that has the projection of x.
template <class Surface>
ClosestPoint<Surface::variables> find_closest_point(const Surface& surface, const GraphPoint<Surface::variables>& x,
                                                    const Pack& z) {
  constexpr std::size_t M = Surface::variables;
  constexpr int rounds = 96;     // Newton's method takes 1 to 3; the others are for steep walls far away
  constexpr double near = 0.05;  // turn of the normal in a step after which the level is raised
  constexpr double small = 1e-15, rounding = 1e-14;  // errors of the slope, of the squared distance
  auto&& heights = surface.reader();
  const double sharpest = surface.sharpest(), reach = share_of_reach / sharpest;
  const double last_square = small * surface.bend_length() / sharpest;  // of a step that needs no new height
  const auto between = [](const Pack& value, const Pack& bound) {
    return std::experimental::max(smaller(value, bound), Pack(-bound));
  };

  ClosestPoint<M> projection{x, heights.at(x)};
  const Pack lift_of_all = z - projection.height.value;
  Pack level = select(std::experimental::abs(lift_of_all) <= reach, z,
                      Pack(projection.height.value + between(lift_of_all, Pack(reach))));
  Pack share = 1.0;
  for (int round = 0; round < rounds; ++round) {
    const std::array<Pack, M> step = newton_step(projection, x, level);
    Pack step_square = 0.0;
    for (std::size_t i = 0; i < M; ++i) step_square += step[i] * step[i];
    const auto arrived = level == z;
    if (everywhere(arrived && step_square <= last_square)) {
      finish(step, projection);
      break;
    }

    GraphPoint<M> place;
    for (std::size_t i = 0; i < M; ++i) place[i] = projection.place[i] - share * step[i];
    place = surface.kept(place, x);
    const Height<M> height = heights.at(place);
    const Pack lift_before = level - projection.height.value, lift = level - height.value;
    Pack before = lift_before * lift_before, after = lift * lift, way = 0.0;
    for (std::size_t i = 0; i < M; ++i) {
      const Pack from_x = place[i] - x[i], before_from_x = projection.place[i] - x[i],
                 change = place[i] - projection.place[i];
      before += before_from_x * before_from_x;
      after += from_x * from_x;
      way += change * change;
    }
    const auto descends = after <= before * (1 + rounding);
    for (std::size_t i = 0; i < M; ++i) {
      projection.place[i] = select(descends, place[i], projection.place[i]);
      projection.height.slope[i] = select(descends, height.slope[i], projection.height.slope[i]);
      for (std::size_t j = 0; j < M; ++j)
        projection.height.bend[i][j] = select(descends, height.bend[i][j], projection.height.bend[i][j]);
    }
    projection.height.value = select(descends, height.value, projection.height.value);
    share = select(descends, Pack(1.0), Pack(0.25 * share));
    if (everywhere(arrived)) continue;

    const auto rises = !arrived && descends && (sharpest * sharpest) * way <= near * near;
    const Pack room = reach - std::experimental::sqrt(after);
    // Beyond the reach the level need not be raised with care.
    const Pack raised =
        select(room > 0.01 * reach, Pack(level + between(z - level, std::experimental::max(room, Pack(0.0)))), z);
    level = select(rises, raised, level);
  }
  return projection;
}

}  // namespace ixos
