#include "geometry/patch_bound.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"

namespace ixos {
namespace {

std::array<Vec<2>, 2> axes_along(const std::array<Vec<2>, 1>& tangents) {
  const Vec<2> t = 1 / length(tangents[0]) * tangents[0];
  return {{t, {t[1], -t[0]}}};
}

std::array<Vec<3>, 3> axes_along(const std::array<Vec<3>, 2>& tangents) {
  const Vec<3> t = 1 / length(tangents[0]) * tangents[0], across = cross(tangents[0], tangents[1]);
  const Vec<3> n = 1 / length(across) * across;
  return {{t, cross(n, t), n}};
}

/// Returns the derivatives of the parameters by a place on the tangent plane, along which the tangents lie.
std::array<Vec<2>, 1> slopes_of(const std::array<Vec<2>, 1>& tangents) {
  return {{1 / inner(tangents[0], tangents[0]) * tangents[0]}};
}

std::array<Vec<3>, 2> slopes_of(const std::array<Vec<3>, 2>& tangents) {
  const Vec<3>&a = tangents[0], &b = tangents[1];
  const double m00 = inner(a, a), m01 = inner(a, b), m11 = inner(b, b), det = m00 * m11 - m01 * m01;
  return {{1 / det * (m11 * a - m01 * b), 1 / det * (m00 * b - m01 * a)}};
}

}  // namespace

template <std::size_t D>
PatchBound<D>::PatchBound(const PlacedPatch<D>& patch) {
  PatchParameters<D> middle;
  middle.fill(0.5);
  const auto frame = patch.frame(middle);
  middle_ = frame.place;
  axes_ = axes_along(frame.tangents);
  const auto slopes = slopes_of(frame.tangents);
  if (std::all_of(slopes.begin(), slopes.end(), [](const Vec<D>& s) { return std::isfinite(length(s)); }))
    slopes_ = slopes;
  const bool found = std::all_of(axes_.begin(), axes_.end(), [](const Vec<D>& e) { return std::isfinite(length(e)); });
  if (!found)  // the patch is folded at its middle
    for (std::size_t k = 0; k < D; ++k) {
      axes_[k] = {};
      axes_[k][k] = 1;
    }
  low_.fill(HUGE_VAL);
  high_.fill(-HUGE_VAL);
  const auto hull = patch.hull();
  points_ = hull.size();
  for (std::size_t i = 0; i < points_; ++i)
    for (std::size_t k = 0; k < D; ++k) hull_[k][i] = hull[i][k];
  for (const Vec<D>& p : hull)
    for (std::size_t k = 0; k < D; ++k) {
      const double along = inner(axes_[k], p);
      low_[k] = std::min(low_[k], along);
      high_[k] = std::max(high_[k], along);
    }
}

template <std::size_t D>
double PatchBound<D>::distance(const Vec<D>& place) const {
  double square = 0, size = 0;
  for (std::size_t k = 0; k < D; ++k) {
    const double along = inner(axes_[k], place);
    const double beyond = std::max({low_[k] - along, 0.0, along - high_[k]});
    square += beyond * beyond;
    size += std::abs(along) + std::abs(low_[k]) + std::abs(high_[k]);
  }
  return std::max(0.0, std::sqrt(square) - 1e-13 * size);
}

template <std::size_t D>
PatchParameters<D> PatchBound<D>::start(const Vec<D>& place) const {
  PatchParameters<D> xi;
  for (std::size_t k = 0; k < D - 1; ++k) xi[k] = std::clamp(0.5 + inner(slopes_[k], place - middle_), 0.0, 1.0);
  return xi;
}

template <std::size_t D>
double PatchBound<D>::distance(const Vec<D>& place, const Vec<D>& point) const {
  const Vec<D> way = place - point;
  std::array<double, PlacedPatch<D>::most> along{};
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t i = 0; i < points_; ++i) along[i] += way[k] * (hull_[k][i] - point[k]);
  const double square = inner(way, way), nearest = square - *std::max_element(along.begin(), along.begin() + points_);
  return std::max(0.0, nearest / std::sqrt(square) - 1e-13 * (length(place) + length(point)));
}

template class PatchBound<2>;
template class PatchBound<3>;

}  // namespace ixos
