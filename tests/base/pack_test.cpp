#include "base/pack.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace ixos {
namespace {

constexpr std::size_t width = Pack::size();

Pack packed(const std::vector<double>& values) {
  Pack result(0.0);
  for (std::size_t i = 0; i < width; ++i) result[i] = values[i];
  return result;
}

/// Numbers of both signs without order: of two such packs each is the smaller in some lanes.
std::vector<double> numbers(double phase) {
  std::vector<double> values;
  for (std::size_t i = 0; i < width; ++i) values.push_back(std::sin(phase += 2.0));
  return values;
}

TEST(PackTest, LanesAreTheNumbersPutIn) {
  EXPECT_EQ(static_cast<std::size_t>(pack_width), width);
  const std::vector<double> values = numbers(0.3);
  const Pack pack = packed(values);
  for (std::size_t i = 0; i < width; ++i) EXPECT_EQ(lane(pack, i), values[i]);
  EXPECT_EQ(lane(2.5, 3), 2.5);
}

TEST(PackTest, SelectAgreesWithScalars) {
  // All ways of choosing among the lanes: bit i of a counter decides lane i.
  const std::vector<double> yes = numbers(0.3), no = numbers(1.1);
  for (std::size_t choice = 0; choice < (std::size_t{1} << width); ++choice) {
    std::vector<double> sign(width);
    for (std::size_t i = 0; i < width; ++i) sign[i] = (choice >> i) % 2 == 1 ? 1.0 : -1.0;
    const Pack result = select(packed(sign) > 0.0, packed(yes), packed(no));
    for (std::size_t i = 0; i < width; ++i) EXPECT_EQ(lane(result, i), select(sign[i] > 0.0, yes[i], no[i]));
  }
  EXPECT_EQ(select(true, 1.0, 2.0), 1.0);
  EXPECT_EQ(select(false, 1.0, 2.0), 2.0);
}

TEST(PackTest, SelectKeepsNotANumberOfTheOtherSideOut) {
  const Pack bad(std::numeric_limits<double>::quiet_NaN());
  const Pack good = packed(numbers(0.3));
  const Pack first = select(good < 2.0, good, bad), second = select(good > 2.0, bad, good);
  for (std::size_t i = 0; i < width; ++i) {
    EXPECT_EQ(lane(first, i), lane(good, i));
    EXPECT_EQ(lane(second, i), lane(good, i));
  }
}

TEST(PackTest, LeastIsFoundInEveryLane) {
  for (std::size_t i = 0; i < width; ++i) {
    std::vector<double> values = numbers(0.3);
    values[i] = -2.0;
    EXPECT_EQ(least(packed(values)), -2.0);
  }
  EXPECT_EQ(least(-3.5), -3.5);
}

TEST(PackTest, TotalIsTheSumOfTheLanes) {
  // Powers of two: the sum is exact in any order and shows every lane that is missing or counted twice.
  std::vector<double> values;
  for (double power = 1.0; values.size() < width; power *= 2.0) values.push_back(power);
  EXPECT_EQ(total(packed(values)), 2.0 * values.back() - 1.0);
  EXPECT_EQ(total(-3.5), -3.5);
}

TEST(PackTest, SmallerAgreesWithScalars) {
  const std::vector<double> a = numbers(0.3), b = numbers(1.1);
  const Pack result = smaller(packed(a), packed(b)), swapped = smaller(packed(b), packed(a));
  for (std::size_t i = 0; i < width; ++i) {
    EXPECT_EQ(lane(result, i), a[i] < b[i] ? a[i] : b[i]);
    EXPECT_EQ(lane(swapped, i), smaller(a[i], b[i]));
  }
}

}  // namespace
}  // namespace ixos
