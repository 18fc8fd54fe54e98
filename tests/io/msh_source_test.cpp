#include "io/msh_source.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::refusal;

template <class T>
std::string bytes(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

TEST(MshSourceTest, NumbersInAsciiAreReadStrictly) {
  MshSource source("m.msh", "$Stuff\n-3 7 1e-3\n 0.1 12x 1.5 -1 nan 99999999999\n$EndStuff\n");
  EXPECT_EQ(source.next_section(), "Stuff");
  EXPECT_EQ(source.integer("a"), -3);
  EXPECT_EQ(source.size("a"), 7U);
  EXPECT_EQ(source.number("a"), 1e-3);
  EXPECT_EQ(source.number("a"), 0.1);
  EXPECT_EQ(refusal([&] { source.integer("a tag"); }),
            "m.msh: line 3: a tag is \"12x\"; an integer of 32 bits is allowed");
  EXPECT_EQ(refusal([&] { source.integer("a tag"); }),
            "m.msh: line 3: a tag is \"1.5\"; an integer of 32 bits is allowed");
  EXPECT_EQ(refusal([&] { source.size("a size"); }), "m.msh: line 3: a size is \"-1\"; an integer from 0 is allowed");
  EXPECT_EQ(refusal([&] { source.number("x"); }), "m.msh: line 3: x is nan; a finite number is allowed");
  EXPECT_EQ(refusal([&] { source.integer("a tag"); }),
            "m.msh: line 3: a tag is \"99999999999\"; an integer of 32 bits is allowed");
  EXPECT_EQ(refusal([&] { source.number("x"); }), "m.msh: line 4: x is \"$EndStuff\"; a number is allowed");
  EXPECT_EQ(refusal([&] { source.number("x"); }), "m.msh: ends inside $Stuff, before x: the file is truncated");
}

TEST(MshSourceTest, NumbersMayHaveAPlusSign) {
  MshSource source("m.msh", "$Stuff\n+0 +3 +1.5e3 +.5 1.5E+3 -0 +-3 ++3 + +x +inf\n$EndStuff\n");
  source.next_section();
  EXPECT_EQ(source.integer("a"), 0);
  EXPECT_EQ(source.size("a"), 3U);
  EXPECT_EQ(source.number("a"), 1500);
  EXPECT_EQ(source.number("a"), 0.5);
  EXPECT_EQ(source.number("a"), 1500);
  EXPECT_EQ(source.number("a"), 0);
  for (const char* word : {"+-3", "++3", "+", "+x", "+inf"})
    EXPECT_EQ(refusal([&] { source.number("x"); }),
              "m.msh: line 2: x is \"" + std::string(word) + "\"; a number is allowed");
}

TEST(MshSourceTest, AByteOrderMarkIsSkipped) {
  MshSource source("m.msh", "\xef\xbb\xbf$One\n1\n$EndOne\n");
  EXPECT_EQ(source.next_section(), "One");
  EXPECT_EQ(source.integer("a"), 1);
  source.end_section();
  EXPECT_EQ(source.next_section(), "");
  MshSource other("m.msh", "\xff\xfe$One\n");  // of UTF-16
  EXPECT_NE(refusal([&] { other.next_section(); }), "");
}

TEST(MshSourceTest, NumbersInBinaryAreReadAsTheyAre) {
  MshSource source("m.msh", "$Stuff\n" + bytes(std::int32_t{-3}) + bytes(std::uint64_t{7}) + bytes(0.1) +
                                bytes(1 / 0.0) + "\n$EndStuff\n$Next\n" + "ab");
  source.set_binary(true);
  EXPECT_EQ(source.next_section(), "Stuff");
  EXPECT_EQ(source.integer("a"), -3);
  EXPECT_EQ(source.size("a"), 7U);
  EXPECT_EQ(source.number("a"), 0.1);
  EXPECT_EQ(refusal([&] { source.number("x"); }), "m.msh: byte 27: x is inf; a finite number is allowed");
  source.end_section();
  EXPECT_EQ(source.next_section(), "Next");
  EXPECT_EQ(refusal([&] { source.integer("a"); }), "m.msh: ends inside $Next: the file is truncated");
}

TEST(MshSourceTest, SectionsBeginAndEndByName) {
  MshSource source("m.msh", "\n$One\r\n1\r\n$EndOne\r\n$Two\nwhat ever\n$EndTwo\n$One\n1 2\n$EndOne\nrest");
  EXPECT_EQ(source.next_section(), "One");
  EXPECT_EQ(source.integer("a"), 1);
  source.end_section();
  EXPECT_EQ(source.next_section(), "Two");
  source.skip_section();
  EXPECT_EQ(source.next_section(), "One");
  EXPECT_EQ(source.integer("a"), 1);
  EXPECT_EQ(refusal([&] { source.end_section(); }), "m.msh: line 9: \"2\" stands where $EndOne has to");
  source.end_section();
  EXPECT_EQ(refusal([&] { source.next_section(); }), "m.msh: line 11: \"rest\" stands where a section has to begin");
  EXPECT_EQ(source.next_section(), "");
  MshSource open("m.msh", "$One\n1 2 3\n");
  open.next_section();
  EXPECT_EQ(refusal([&] { open.skip_section(); }), "m.msh: ends inside $One: the file is truncated");
}

TEST(MshSourceTest, CountsBeyondTheFileAreRefused) {
  MshSource ascii("m.msh", "3 1 2 3");  // two bytes each, or more
  EXPECT_EQ(ascii.count("the count", {1, 0, 0}), 3U);
  MshSource few("m.msh", "4 1 2 3");
  EXPECT_EQ(refusal([&] {
              few.count("the count", {1, 0, 0});
            }),
            "m.msh: line 1: the count is 4, more than the rest of the file can hold");
  MshSource huge("m.msh", "18446744073709551615 1 2 3");
  EXPECT_NE(refusal([&] { huge.count("the count", {0, 1, 3}); }), "");
  for (const std::uint64_t count : {2, 3}) {
    MshSource binary("m.msh", bytes(count) + std::string(2 * (4 + 8 + 3 * 8), '\0'));
    binary.set_binary(true);
    EXPECT_EQ(refusal([&] { binary.count("the count", {1, 1, 3}); }).empty(), count == 2);
  }
}

TEST(MshSourceTest, WhatIsNoFileIsRefused) {
  const std::string pipe = testing::TempDir() + "pipe.msh";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {testing::TempDir() + "nowhere.msh", testing::TempDir(), pipe})
    EXPECT_EQ(refusal([&] { MshSource{path}; }), path + ": the mesh file cannot be read");
  const std::string path = testing::TempDir() + "some.msh";
  std::ofstream(path) << "$One\n";
  EXPECT_EQ(MshSource(path).next_section(), "One");
}

}  // namespace
}  // namespace ixos
