#include "units/ratio.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"

namespace ixos {

Ratio::Ratio(std::uint64_t n, int exponent) : n_(n), ten_(exponent) { normalize(); }

Ratio Ratio::pi() {
  Ratio result;
  result.pi_ = 1;
  return result;
}

Ratio::Wide Ratio::divisor(Wide a, Wide b) {
  while (b != 0) {
    a %= b;
    std::swap(a, b);
  }
  return a;
}

/// Leaves room for ten times the result, see nearest().
Ratio::Wide Ratio::product(Wide a, Wide b) {
  constexpr Wide limit = static_cast<Wide>(1) << 120U;
  if (a != 0 && b > limit / a) throw InputError("its number and units have too many digits");
  return a * b;
}

/// Moves powers of ten to the exponent.
void Ratio::normalize() {
  if (n_ == 0) {
    d_ = 1;
    ten_ = 0;
    return;
  }
  for (; n_ % 10 == 0; n_ /= 10) ++ten_;
  for (; d_ % 10 == 0; d_ /= 10) --ten_;
}

Ratio Ratio::operator*(const Ratio& other) const {
  Ratio result;
  const Wide left = divisor(n_, other.d_), right = divisor(other.n_, d_);
  result.n_ = product(n_ / left, other.n_ / right);
  result.d_ = product(d_ / right, other.d_ / left);
  result.ten_ = ten_ + other.ten_;
  result.pi_ = pi_ + other.pi_;
  result.normalize();
  return result;
}

Ratio Ratio::operator/(const Ratio& other) const {
  Ratio inverse = other;
  std::swap(inverse.n_, inverse.d_);
  inverse.ten_ = -other.ten_;
  inverse.pi_ = -other.pi_;
  return *this * inverse;
}

Ratio Ratio::power(int exponent) const {
  Ratio result;
  for (int i = 0; i < std::abs(exponent); ++i) result = exponent > 0 ? result * *this : result / *this;
  return result;
}

double Ratio::nearest() const {
  if (n_ == 0) return 0;
  // The digits of n/d. A number half-way between two doubles has fewer than 770, so the last one, which stands for all
  // that follow, decides nothing else.
  std::string digits;
  for (Wide whole = n_ / d_; whole != 0; whole /= 10) digits += static_cast<char>('0' + static_cast<int>(whole % 10));
  std::reverse(digits.begin(), digits.end());
  Wide rest = n_ % d_;
  int exponent = ten_;
  for (; rest != 0 && digits.size() < 800; --exponent) {
    rest *= 10;
    digits += static_cast<char>('0' + static_cast<int>(rest / d_));
    rest %= d_;
  }
  if (rest != 0) {
    digits += '1';
    --exponent;
  }
  digits += "e" + std::to_string(exponent);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (pi_ != 0) value = static_cast<double>(value * std::pow(static_cast<long double>(M_PIl), pi_));
  if (error != std::errc() || !std::isfinite(value) || value < std::numeric_limits<double>::min())
    throw InputError("it is beyond the range of numbers");
  return value;
}

}  // namespace ixos
