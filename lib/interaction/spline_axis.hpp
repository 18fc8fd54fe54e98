/// Cubic splines along one axis of a grid.
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/pack.hpp"

namespace ixos {

/// Samples in equal distances, the middle of them at 0. A cubic spline through them has two continuous derivatives. It
/// is periodic with the period n d, or natural: beyond the first and the last of n samples in distances d it continues
/// linearly.
class SplineAxis {
 public:
  /// Throws InputError unless samples >= 4 and the distance d is positive.
  SplineAxis(std::size_t samples, double distance, bool periodic);

  std::size_t samples() const { return samples_; }
  double distance() const { return distance_; }
  double per_distance() const { return scale_; }  ///< 1/distance
  bool periodic() const { return periodic_; }
  /// Returns the number of pieces, and of coefficients: those of piece i are i to i + 3.
  std::size_t pieces() const { return periodic_ ? samples_ : samples_ - 1; }
  std::size_t coefficients() const { return pieces() + 3; }

  /// Returns the coefficients of the B-splines, de Boor 1978, from the samples.
  std::vector<double> coefficients_of(const std::vector<double>& values) const;

  /// The piece of a place, and the values and derivatives of its four B-splines there by the place over the distance.
  struct Weights {
    Pack piece;
    std::array<Pack, 4> value, slope, bend;
  };
  Weights at(const Pack& place) const;

  /// Returns the distance to the nearer end, negative beyond; infinity if the axis is periodic.
  Pack to_end(const Pack& place) const;

 private:
  std::size_t samples_;
  double distance_, scale_, start_;  ///< scale = 1/distance
  bool periodic_;
};

inline SplineAxis::Weights SplineAxis::at(const Pack& place) const {
  const auto count = static_cast<double>(pieces());
  Pack u = (place - start_) * scale_, beyond = 0.0;
  if (periodic_) {
    u -= count * std::experimental::floor(u * (1 / count));
  } else {
    const Pack inside = std::experimental::max(smaller(u, Pack(count)), Pack(0.0));
    beyond = u - inside;
    u = inside;
  }
  Weights result;
  const Pack piece = smaller(std::experimental::floor(u), Pack(count - 1));
  result.piece = select(piece >= 0.0 && piece < count, piece, Pack(0.0));  // what is no number included
  const Pack t = u - piece, s = 1.0 - t;
  constexpr double sixth = 1.0 / 6;
  result.value = {sixth * s * s * s, t * t * (0.5 * t - 1.0) + 4 * sixth, s * s * (0.5 * s - 1.0) + 4 * sixth,
                  sixth * t * t * t};
  result.slope = {-0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t};
  result.bend = {s, 3.0 * t - 2.0, 3.0 * s - 2.0, t};
  if (periodic_) return result;
  for (std::size_t k = 0; k < 4; ++k) {
    result.value[k] += beyond * result.slope[k];
    result.bend[k] = select(beyond == 0.0, result.bend[k], Pack(0.0));
  }
  return result;
}

inline Pack SplineAxis::to_end(const Pack& place) const {
  if (periodic_) return std::numeric_limits<double>::infinity();
  return -start_ - std::experimental::abs(place);
}

}  // namespace ixos
