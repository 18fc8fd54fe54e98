/// Functions of time for tests, and checks that every one must pass.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "histories/time_function.hpp"

namespace ixos::test {

/// Returns rate t + acceleration t^2/2.
inline std::shared_ptr<const TimeFunction> polynomial(double rate, double acceleration) {
  return function_of_time([=](double t) {
    return TimeValue{t * (rate + t * acceleration / 2), rate + t * acceleration, acceleration};
  });
}

inline void expect_value(const TimeFunction& function, double time, double value, double rate, double acceleration) {
  const TimeValue f = function.at(time);
  EXPECT_NEAR(f.value, value, 1e-13 * (1 + std::abs(value))) << "t = " << time;
  EXPECT_NEAR(f.rate, rate, 1e-13 * (1 + std::abs(rate))) << "t = " << time;
  EXPECT_NEAR(f.acceleration, acceleration, 1e-13 * (1 + std::abs(acceleration))) << "t = " << time;
}

/// Derivatives against central differences.
inline void expect_derivatives(const TimeFunction& function, const std::vector<double>& times) {
  const double h = 1e-5;
  for (double time : times) {
    const TimeValue before = function.at(time - h), f = function.at(time), after = function.at(time + h);
    EXPECT_NEAR(f.rate, (after.value - before.value) / (2 * h), 1e-7) << "t = " << time;
    EXPECT_NEAR(f.acceleration, (after.rate - before.rate) / (2 * h), 1e-7) << "t = " << time;
  }
}

/// Value, rate and, where `twice`, acceleration do not jump at `time`.
inline void expect_continuous(const TimeFunction& function, double time, bool twice) {
  const double h = 1e-9;
  const TimeValue before = function.at(time - h), f = function.at(time), after = function.at(time + h);
  for (const TimeValue& near : {before, after}) {
    EXPECT_NEAR(near.value, f.value, 1e-7) << "t = " << time;
    EXPECT_NEAR(near.rate, f.rate, 1e-7) << "t = " << time;
    if (twice) {
      EXPECT_NEAR(near.acceleration, f.acceleration, 1e-6) << "t = " << time;
    }
  }
}

}  // namespace ixos::test
