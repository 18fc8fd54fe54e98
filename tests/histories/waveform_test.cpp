#include "histories/waveform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/snapshot.hpp"

namespace ixos {
namespace {

/// A polynomial of degree 5, which a waveform reproduces from its ends.
TimeValue polynomial(double t) {
  return {1 + t * (2 + t * (-3 + t * (4 + t * (-5 + t * 6)))), 2 + t * (-6 + t * (12 + t * (-20 + t * 30))),
          -6 + t * (24 + t * (-60 + t * 120))};
}

void expect_near(const TimeValue& value, const TimeValue& expected) {
  EXPECT_NEAR(value.value, expected.value, 1e-12);
  EXPECT_NEAR(value.rate, expected.rate, 1e-11);
  EXPECT_NEAR(value.acceleration, expected.acceleration, 1e-10);
}

TEST(WaveformTest, IsConstantUntilItIsSet) {
  const Waveform waveform(0.3);
  for (const double time : {-5.0, 0.0, 1e6}) expect_near(waveform.at(time), {0.3, 0, 0});
}

TEST(WaveformTest, ReproducesAPolynomialOfDegreeFive) {
  Waveform waveform;
  waveform.set(-0.5, polynomial(-0.5), 0.75, polynomial(0.75));
  for (const double time : {-0.5, -0.2, 0.0, 0.4, 0.75}) expect_near(waveform.at(time), polynomial(time));
  EXPECT_EQ(waveform.last().rate, polynomial(0.75).rate);
}

TEST(WaveformTest, IsDefinedOnItsIntervalOnly) {
  Waveform waveform;
  waveform.set(0, {1, 0, 0}, 2, {2, 0, 0});
  EXPECT_TRUE(std::isnan(waveform.at(-1e-6).value));
  EXPECT_TRUE(std::isnan(waveform.at(2.000001).acceleration));
  EXPECT_NEAR(waveform.at(2 + 1e-9).value, 2, 1e-15) << "a sum of steps has rounding errors";
}

TEST(WaveformTest, RefusesTimesAndValuesThatAreNotAllowed) {
  Waveform waveform;
  EXPECT_THROW(waveform.set(1, {}, 1, {}), InputError);
  EXPECT_THROW(waveform.set(2, {}, 1, {}), InputError);
  EXPECT_THROW(waveform.set(0, {}, 1, {0, std::nan(""), 0}), InputError);
  EXPECT_EQ(waveform.at(7).value, 0) << "nothing was set";
}

TEST(WaveformTest, ComesBackFromARecord) {
  Waveform waveform;
  Snapshot snapshot([&](Record& record) { waveform.transfer(record); });
  waveform.set(0, {1, 2, 3}, 2, {4, 5, 6});
  const TimeValue middle = waveform.at(1.2);
  snapshot.save();
  waveform.set(2, {4, 5, 6}, 3, {0, 0, 0});
  snapshot.restore();
  EXPECT_EQ(waveform.at(1.2).value, middle.value);
  EXPECT_EQ(waveform.at(1.2).acceleration, middle.acceleration);
}

}  // namespace
}  // namespace ixos
