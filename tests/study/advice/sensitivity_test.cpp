// Predictable, sensitive and chaotic numbers.
#include "study/advice/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ixos {
namespace {

TEST(SensitivityTest, KindsByTheChange) {
  EXPECT_EQ(sensitivity(2, 2 + 1e-9, 0.01).kind, Predictability::Predictable);
  EXPECT_EQ(sensitivity(2, 2.002, 0.01).kind, Predictability::Sensitive);
  EXPECT_NEAR(sensitivity(2, 2.002, 0.01).change, 0.001, 1e-5);
  EXPECT_EQ(sensitivity(2, 2.02, 0.01).kind, Predictability::Chaotic);
  EXPECT_EQ(sensitivity(2, 2.02, 0.05).kind, Predictability::Sensitive) << "within a third of the tolerance";
  EXPECT_EQ(sensitivity(-1, 1, 0.5).kind, Predictability::Chaotic);
}

TEST(SensitivityTest, SmallChangesAreNoChaosForSmallTolerances) {
  EXPECT_EQ(sensitivity(1, 1 + 5e-6, 1e-7).kind, Predictability::Sensitive);
}

TEST(SensitivityTest, NumbersThatAreZeroOrNone) {
  EXPECT_EQ(sensitivity(0, 0, 0.01).kind, Predictability::Predictable);
  EXPECT_EQ(sensitivity(1, std::numeric_limits<double>::quiet_NaN(), 0.01).kind, Predictability::Chaotic);
}

}  // namespace
}  // namespace ixos
