#include "base/simd_width.hpp"

#include <gtest/gtest.h>

#include "base/pack.hpp"

namespace {

// The tests and the library are built for one instruction set, unless the loader has found a faster library.
TEST(SimdWidthTest, TheLibraryIsAtLeastAsWideAsThePrograms) {
  EXPECT_GE(ixos::simd_width(), ixos::pack_width);
  const int width = ixos::simd_width();
  EXPECT_TRUE(width == 2 || width == 4 || width == 8) << width;
}

TEST(SimdWidthTest, TheProcessorHasTheInstructionSet) {
  if (ixos::simd_width() == 8) {
    EXPECT_TRUE(__builtin_cpu_supports("avx512f"));
  }
  if (ixos::simd_width() == 4) {
    EXPECT_TRUE(__builtin_cpu_supports("avx"));
  }
}

}  // namespace
