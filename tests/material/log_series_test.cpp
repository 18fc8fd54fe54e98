#include "material/log_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

TEST(LogSeriesTest, LogarithmAndInverseAreThoseOfLongDoubleUpToTheLimit) {
  for (const double size : {1.0, 0.9, 0.3, 1e-2, 1e-5, 1e-12})
    for (const double x : {size * log_and_inverse_limit, -size * log_and_inverse_limit}) {
      const long double exact = std::log1p(static_cast<long double>(x)),
                        quotient = 1 / (1 + static_cast<long double>(x));
      double log = 0, inverse = 0;
      log_and_inverse(x, log, inverse);
      EXPECT_NEAR(log, static_cast<double>(exact), 3e-16 * std::abs(x)) << x;
      EXPECT_NEAR(inverse, static_cast<double>(quotient), 4e-16) << x;
      Pack pack_log, pack_inverse;
      log_and_inverse(Pack(x), pack_log, pack_inverse);
      EXPECT_NEAR(pack_log[0], log, 3e-16 * std::abs(x)) << x;
      EXPECT_NEAR(pack_inverse[0], inverse, 3e-16) << x;
    }
}

/// Lanes on both sides of a series' limit have the values of lanes that are alone.
TEST(LogSeriesTest, QuotientsAreThoseOfLongDoubleOnBothSidesOfTheirSeries) {
  for (const double x : {-0.5, -0.021, -0.019, -1e-3, 1e-3, 0.019, 0.021, 0.5, 3.0}) {
    const long double y = x, log = std::log1p(y);
    const auto rest = static_cast<double>((y - log) / y), slope = static_cast<double>((y - (1 + y) * log) / (y * y));
    const double l = std::log1p(x);
    EXPECT_NEAR(minus_log1p_quotient(x, l), rest, 1e-13 * std::abs(rest)) << x;
    EXPECT_NEAR(log1p_quotient(x, l), static_cast<double>(log / y), 1e-14) << x;
    EXPECT_NEAR(scaled_log1p_quotient_slope(x, l), slope, 2e-12) << x;
    Pack mixed = 1e-4, logs = std::log1p(1e-4);
    mixed[0] = x;
    logs[0] = l;
    EXPECT_NEAR(Pack(scaled_log1p_quotient_slope(mixed, logs))[0], slope, 2e-12) << x;
    EXPECT_NEAR(Pack(minus_log1p_quotient(mixed, logs))[0], rest, 1e-13 * std::abs(rest)) << x;
  }
}

}  // namespace
}  // namespace ixos
