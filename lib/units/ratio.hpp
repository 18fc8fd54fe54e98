/// Exact factors between units.
#pragma once
#include <cstdint>
#include <map>

namespace ixos {

/// An exact factor: a product of powers of whole numbers, of 10 and of pi, so that a conversion is rounded once.
class Ratio {
 public:
  Ratio() = default;  ///< 1
  /// n 10^exponent; n may be 0.
  explicit Ratio(std::uint64_t n, int exponent = 0);
  static Ratio pi();

  Ratio operator*(const Ratio& other) const;
  Ratio operator/(const Ratio& other) const;  ///< the divisor must not be 0
  Ratio power(int exponent) const;            ///< the exponent of 0 must be positive

  bool is_zero() const;
  /// Returns the double nearest to the value; with a power of pi, one within 2 units in its last place. Throws
  /// InputError if the value is beyond the range of normal doubles.
  double nearest() const;

 private:
  std::map<std::uint64_t, int> exponents_;  ///< by base: 0 or above 1, with exponents other than 0
  int ten_ = 0, pi_ = 0;
};

}  // namespace ixos
