/// Exact factors between units.
#pragma once
#include <cstdint>

namespace ixos {

/// An exact factor n/d 10^k pi^p, so that a conversion is rounded once. n and d have at most 36 digits, which no
/// product of sensible units and numbers exceeds.
class Ratio {
 public:
  Ratio() = default;  ///< 1
  /// n 10^exponent; n may be 0.
  explicit Ratio(std::uint64_t n, int exponent = 0);
  static Ratio pi();

  /// Throw InputError if the result has too many digits. The divisor must not be 0.
  Ratio operator*(const Ratio& other) const;
  Ratio operator/(const Ratio& other) const;
  Ratio power(int exponent) const;

  bool is_zero() const { return n_ == 0; }
  /// Returns the double nearest to the value; with a power of pi, one within 2 units in its last place. Throws
  /// InputError if the value is beyond the range of normal doubles.
  double nearest() const;

 private:
  __extension__ using Wide = unsigned __int128;
  static Wide divisor(Wide a, Wide b);
  static Wide product(Wide a, Wide b);
  void normalize();

  Wide n_ = 1, d_ = 1;
  int ten_ = 0, pi_ = 0;
};

}  // namespace ixos
