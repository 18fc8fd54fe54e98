// Headers of netCDF's classic format, put together byte by byte as the specification says.
#include "io/classic_layout.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "support/files.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// The tags of the lists, and the numbers of the types, in the specification.
constexpr std::uint64_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;
constexpr std::uint64_t char_type = 2, int_type = 4, float_type = 5, double_type = 6;

/// Returns the number with the high byte first.
std::string number(std::uint64_t value, int bytes = 4) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>((value >> shift) & 0xff);
  return text;
}

/// Returns the text, followed by zeros up to a multiple of four bytes.
std::string padded(std::string text) {
  text.resize((text.size() + 3) / 4 * 4, '\0');
  return text;
}

std::string name(const std::string& text) { return number(text.size()) + padded(text); }

std::string list(std::uint64_t tag, const std::vector<std::string>& elements) {
  std::string text = number(tag) + number(elements.size());
  for (const std::string& element : elements) text += element;
  return text;
}
const std::string absent = number(0) + number(0);  // the form of an empty list

/// The numbers of the dimensions: "time_step", which grows, and "num_nodes".
constexpr std::uint64_t time_step = 0, num_nodes = 1;

const std::string dimensions = list(dimension_tag, {name("time_step") + number(0), name("num_nodes") + number(3)});
// Neither text fills its last four bytes.
const std::string attributes = list(attribute_tag, {name("title") + number(char_type) + number(5) + padded("hello"),
                                                    name("version") + number(float_type) + number(1) + number(7)});

std::string variable(const std::string& text, const std::vector<std::uint64_t>& numbers_of_dimensions,
                     std::uint64_t begin, std::uint64_t type = double_type) {
  std::string result = name(text) + number(numbers_of_dimensions.size());
  for (const std::uint64_t dimension : numbers_of_dimensions) result += number(dimension);
  return result + list(attribute_tag, {name("units") + number(char_type) + number(1) + padded("m")}) + number(type) +
         number(0) + number(begin, 8);  // the number before the beginning is a size that follows from the rest
}

std::string header(const std::vector<std::string>& variables) {
  return "CDF\x02" + number(0) + dimensions + attributes + list(variable_tag, variables);
}

std::string path() { return testing::TempDir() + "classic_layout.nc"; }

ClassicLayout layout_of(const std::string& bytes) {
  std::ofstream(path(), std::ios::binary) << bytes;
  return read_classic_layout(DiskFile(path(), DiskFile::Mode::Read), path());
}

std::string refusal(const std::string& bytes) {
  return test::refusal([&] { layout_of(bytes); });
}

std::string damaged() { return path() + ": its header is damaged"; }

// Three variables grow; two do not, one of which holds integers.
std::string sound_header() {
  return header({variable("coordx", {num_nodes}, 500), variable("time_whole", {time_step}, 600),
                 variable("node_num_map", {num_nodes}, 524, int_type),
                 variable("vals_nod_var1", {time_step, num_nodes}, 608), variable("energy", {time_step}, 632)});
}

TEST(ClassicLayoutTest, RecordsHoldOneRowOfEachVariableThatGrows) {
  const ClassicLayout layout = layout_of(sound_header());
  EXPECT_EQ(layout.first_record, 600U);
  EXPECT_EQ(layout.record_bytes, 8U * (1 + 3 + 1));
  ASSERT_EQ(layout.variables.size(), 3U);
  const char* const names[] = {"time_whole", "vals_nod_var1", "energy"};
  const std::uint64_t offsets[] = {0, 8, 32}, numbers[] = {1, 3, 1};
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_EQ(layout.variables[v].name, names[v]);
    EXPECT_EQ(layout.variables[v].offset, offsets[v]);
    EXPECT_EQ(layout.variables[v].numbers, numbers[v]);
  }
  EXPECT_EQ(layout.end(0), 600U);
  EXPECT_EQ(layout.end(3), 600U + 3 * 40);
  // The product is larger than 32 bits hold.
  EXPECT_EQ(layout.end(1000000000), 600U + 40000000000U);
}

TEST(ClassicLayoutTest, ListsMayBeAbsent) {
  const std::string without =
      "CDF\x02" + number(0) + dimensions + absent + list(variable_tag, {variable("time_whole", {time_step}, 200)});
  EXPECT_EQ(layout_of(without).first_record, 200U);
  // An absent list has no elements.
  EXPECT_EQ(refusal("CDF\x02" + number(0) + dimensions + number(0) + number(1)), damaged());
}

TEST(ClassicLayoutTest, EveryHeaderThatEndsEarlyIsRefused) {
  const std::string whole = sound_header();
  EXPECT_EQ(refusal(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_EQ(refusal(whole.substr(0, length)), damaged()) << length;
}

TEST(ClassicLayoutTest, WhatTheFormatDoesNotAllowIsRefused) {
  const std::string time = variable("time_whole", {time_step}, 600);
  EXPECT_EQ(refusal(header({time})), "");
  std::string other_variant = header({time});
  other_variant[3] = '\x01';  // with positions of 32 bits
  EXPECT_EQ(refusal(other_variant), damaged());
  const std::string start = "CDF\x02" + number(0);
  EXPECT_EQ(refusal(start + list(variable_tag, {}) + attributes + list(variable_tag, {time})), damaged())
      << "a wrong tag";
  EXPECT_EQ(refusal(start + list(dimension_tag, {number(0xffffffff) + padded("time_step")})), damaged())
      << "a name longer than the file";
  for (const std::uint64_t type : {0, 7})
    EXPECT_EQ(refusal(start + dimensions + list(attribute_tag, {name("a") + number(type) + number(0)}) +
                      list(variable_tag, {time})),
              damaged())
        << "an attribute of type " << type;
  EXPECT_EQ(refusal(header({time, variable("vals", {time_step, 2}, 608)})), damaged()) << "a third dimension";
}

TEST(ClassicLayoutTest, RecordsThatIxosCannotWriteAreRefused) {
  const std::string time = variable("time_whole", {time_step}, 600);
  EXPECT_EQ(refusal(header({time, variable("vals", {time_step, num_nodes}, 608, float_type)})), damaged());
  EXPECT_EQ(refusal(header({variable("coordx", {num_nodes}, 500)})), damaged()) << "nothing grows";
  EXPECT_EQ(refusal(header({time, variable("vals", {time_step}, 592)})), damaged()) << "before the first record";
  EXPECT_EQ(refusal(header({variable("time_whole", {time_step}, 100)})), damaged()) << "within the header";
  EXPECT_EQ(refusal(header({time, variable("vals", {time_step, time_step}, 608)})), damaged()) << "grows twice";
  EXPECT_EQ(refusal(header({time, variable("vals", {time_step}, 608)})), "");
  EXPECT_EQ(refusal(header({time, variable("vals", {time_step}, 609)})), damaged()) << "beyond the end of a record";
}

TEST(ClassicLayoutTest, TheCountOfRecordsIsTheSecondNumberOfTheHeader) {
  std::ofstream(path(), std::ios::binary) << "CDF\x02????rest";
  DiskFile file(path(), DiskFile::Mode::Change);
  write_record_count(file, 0x01020304);
  file.close();
  EXPECT_EQ(test::contents(path()), "CDF\x02\x01\x02\x03\x04rest");
}

// The bytes are those of IEEE 754: a sign, 11 bits of exponent with an offset of 1023, 52 bits of fraction.
TEST(ClassicLayoutTest, NumbersAreAppendedWithTheHighByteFirst) {
  std::vector<char> record{'r'};
  append_numbers({1.0, -2.5}, record);
  append_numbers({}, record);
  append_numbers({std::numeric_limits<double>::denorm_min()}, record);
  const std::string expected = "r" + number(0x3ff0000000000000, 8) + number(0xc004000000000000, 8) + number(1, 8);
  EXPECT_EQ(std::string(record.begin(), record.end()), expected);
}

}  // namespace
}  // namespace ixos
