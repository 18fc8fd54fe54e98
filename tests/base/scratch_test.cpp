#include "base/scratch.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "base/pack.hpp"

namespace ixos {
namespace {

TEST(ScratchTest, HoldsItsElements) {
  for (const std::size_t size : {0U, 1U, 32U, 33U, 200U}) {
    Scratch<Pack> numbers(size);
    ASSERT_EQ(numbers.size(), size);
    for (std::size_t i = 0; i < size; ++i) numbers[i] = static_cast<double>(i);
    const Scratch<Pack>& same = numbers;
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(double(same.data()[i][0]), static_cast<double>(i));
      EXPECT_EQ(&same[i], same.data() + i);
    }
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % alignof(Pack), 0U);
  }
}

}  // namespace
}  // namespace ixos
