#include "units/ratio.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

using Integer = boost::multiprecision::cpp_int;

[[noreturn]] void refuse() { throw InputError("it is beyond the range of numbers"); }

/// Returns n/d, rounded once if the result is a normal double. Both are positive.
double quotient(Integer n, Integer d) {
  // 63 or 64 bits of the quotient. The lowest one also stands for all that follow: it is below those of a double, so it
  // decides only on which side of the middle between two doubles the quotient is.
  const int shift = 63 - static_cast<int>(msb(n)) + static_cast<int>(msb(d));
  (shift > 0 ? n : d) <<= std::abs(shift);
  Integer whole, rest;
  divide_qr(n, d, whole, rest);
  auto bits = static_cast<std::uint64_t>(whole);
  if (rest != 0) bits |= 1U;
  return std::ldexp(static_cast<double>(bits), -shift);
}

}  // namespace

Ratio::Ratio(std::uint64_t n, int exponent) : ten_(exponent) {
  if (n != 1) exponents_[n] = 1;
}

Ratio Ratio::pi() {
  Ratio result;
  result.pi_ = 1;
  return result;
}

Ratio Ratio::operator*(const Ratio& other) const {
  Ratio result = *this;
  for (const auto& [base, exponent] : other.exponents_)
    if ((result.exponents_[base] += exponent) == 0) result.exponents_.erase(base);
  result.ten_ += other.ten_;
  result.pi_ += other.pi_;
  return result;
}

Ratio Ratio::operator/(const Ratio& other) const { return *this * other.power(-1); }

Ratio Ratio::power(int exponent) const {
  if (exponent == 0) return {};
  Ratio result = *this;
  for (auto& factor : result.exponents_) factor.second *= exponent;
  result.ten_ *= exponent;
  result.pi_ *= exponent;
  return result;
}

bool Ratio::is_zero() const { return exponents_.count(0) > 0; }

double Ratio::nearest() const {
  if (is_zero()) return 0;
  double size = ten_ + pi_ * std::log10(M_PI);
  for (const auto& [base, exponent] : exponents_) size += exponent * std::log10(static_cast<double>(base));
  if (std::abs(size) > 320) refuse();  // which also bounds the work below
  Integer n = 1, d = 1;
  const auto multiply = [&](std::uint64_t base, int exponent) {
    (exponent > 0 ? n : d) *= pow(Integer(base), static_cast<unsigned>(std::abs(exponent)));
  };
  for (const auto& [base, exponent] : exponents_) multiply(base, exponent);
  multiply(10, ten_);
  double value = quotient(std::move(n), std::move(d));
  if (pi_ != 0) value = static_cast<double>(value * std::pow(static_cast<long double>(M_PIl), pi_));
  if (!std::isfinite(value) || value < std::numeric_limits<double>::min()) refuse();
  return value;
}

}  // namespace ixos
