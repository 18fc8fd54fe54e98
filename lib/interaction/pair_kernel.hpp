/// The energy of two area elements of two bodies.
#pragma once
#include <cmath>
#include <vector>

#include "interaction/gap_power.hpp"

namespace ixos {

/// The volumes of two bodies attract each other by a pair potential -lap W(r). By Gauss's theorem their energy is then
/// the integral of (n1 . n2) W(r) over both closed surfaces. Between two half-spaces it is psi(g) per area if W(r) =
/// -T(r)/(2 pi r), T = -psi'; in the plane, per length, W is the integral of that along a line at the distance r
/// (Argento, Jagota and Carter 1997, for the forces).
template <std::size_t D>
class PairKernel {
 public:
  /// W, W'/r and (W'/r)'/r.
  template <class T>
  struct Values {
    T value, slope, bend;
  };

  /// `traction`: the powers of T.
  explicit PairKernel(const std::vector<GapPower>& traction) {
    for (const GapPower& power : traction) {
      const double p = power.exponent;
      const double line = D == 3 ? 1 : std::sqrt(M_PI) * std::exp(std::lgamma(p / 2) - std::lgamma((p + 1) / 2));
      parts_.push_back({-power.factor / (2 * M_PI) * line, D == 3 ? p + 1 : p});
    }
  }

  /// Returns the kernel at a squared distance, double or Pack.
  template <class T>
  Values<T> at(const T& square) const {
    const T inverse = 1.0 / square;
    Values<T> sum{T(0.0), T(0.0), T(0.0)};
    for (const GapPower& part : parts_) {
      const T value = part.factor * power(inverse, part.exponent / 2), slope = -part.exponent * value * inverse;
      sum.value += value;
      sum.slope += slope;
      sum.bend += -(part.exponent + 2) * slope * inverse;
    }
    return sum;
  }

 private:
  /// Twice the exponent is a whole number.
  template <class T>
  static T power(const T& x, double exponent) {
    using std::sqrt;
    auto whole = static_cast<unsigned>(exponent);
    T result = exponent == whole ? T(1.0) : T(sqrt(x));
    for (T square = x; whole > 0; whole /= 2, square = square * square)
      if (whole % 2 == 1) result = result * square;
    return result;
  }

  std::vector<GapPower> parts_;  ///< of W
};

}  // namespace ixos
