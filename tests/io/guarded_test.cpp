#include "io/guarded.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <vector>

#include "base/error.hpp"
#include "support/sanitized.hpp"

namespace ixos {
namespace {

constexpr std::uint64_t mebibyte = 1U << 20U;

TEST(TrialTest, WhatIsThrownComesBackInWords) {
  int changed = 0;
  EXPECT_EQ(trial([&] { changed = 1; }, 64 * mebibyte, 10), "");
  EXPECT_EQ(changed, 0) << "the child's memory is its own";
  EXPECT_EQ(trial([] { throw std::runtime_error("no"); }, 64 * mebibyte, 10), "no");
  EXPECT_EQ(trial([] { throw std::runtime_error(std::string(100000, 'x')); }, 64 * mebibyte, 10),
            std::string(4000, 'x'));
}

TEST(TrialTest, CrashesAreSeen) {
  EXPECT_EQ(trial([] { std::raise(SIGSEGV); }, 64 * mebibyte, 10), "reading it crashes");
  EXPECT_EQ(trial([] { std::raise(SIGABRT); }, 64 * mebibyte, 10), "reading it crashes");
}

TEST(TrialTest, EndlessWorkIsEnded) {
  volatile bool on = true;
  EXPECT_EQ(trial(
                [&] {
                  while (on) {
                  }
                },
                64 * mebibyte, 1),
            "reading it takes too long");
}

TEST(TrialTest, EndlessWaitingIsEnded) {
  EXPECT_EQ(trial([] { pause(); }, 64 * mebibyte, 1), "reading it takes too long");
}

TEST(TrialTest, MemoryIsBounded) {
  const auto take = [](std::size_t bytes) {
    std::vector<char> memory(bytes, 1);
    if (memory.back() != 1) std::raise(SIGSEGV);
  };
  EXPECT_EQ(trial([&] { take(32 * mebibyte), std::raise(SIGABRT); }, 512 * mebibyte, 60), "reading it crashes")
      << "it has room";
  const char* end = test::sanitized() ? "reading it crashes" : "reading it takes too much memory";
  EXPECT_EQ(trial([&] { take(4096 * mebibyte), std::raise(SIGILL); }, 512 * mebibyte, 60), end);
}

TEST(TrialTest, AFileThatCrashesItsReaderIsRefused) {
  try {
    try_reading("file.e", [] { std::raise(SIGBUS); });
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "file.e: is damaged: reading it crashes");
  }
}

}  // namespace
}  // namespace ixos
