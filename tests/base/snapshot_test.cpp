#include "base/snapshot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ixos {
namespace {

struct State {
  bool flag = true;
  long count = -123456789012;
  double third = 1.0 / 3, none = std::nan("");
  std::string text = "two\nlines";
  std::vector<double> field{1, 2, 3}, share, array{4};

  void transfer(Record& record) {
    const Record::Section outer(record, "outer");
    record.number("flag", flag);
    record.number("count", count);
    {
      const Record::Section inner(record, "inner");
      record.number("third", third);
      record.number("none", none);
    }
    record.text("text", text);
    record.field("field", field, Extent::Local);
    record.share("share", share);
    record.array("array", array);
  }
};

TEST(SnapshotTest, AStateComesBackAsOftenAsWanted) {
  State state;
  Snapshot snapshot([&](Record& record) { state.transfer(record); });
  EXPECT_TRUE(snapshot.empty());
  snapshot.save();
  EXPECT_GE(snapshot.bytes(), 4 * 8);
  for (int time = 0; time < 2; ++time) {
    state.flag = false;
    state.count = 0;
    state.third = state.none = 0;
    state.text.clear();
    state.field = {};
    state.share = {7, 8};
    state.array = {9};
    snapshot.restore();
    EXPECT_TRUE(state.flag);
    EXPECT_EQ(state.count, -123456789012);
    EXPECT_EQ(state.third, 1.0 / 3);
    EXPECT_TRUE(std::isnan(state.none));
    EXPECT_EQ(state.text, "two\nlines");
    EXPECT_EQ(state.field, (std::vector<double>{1, 2, 3}));
    EXPECT_TRUE(state.share.empty());
    EXPECT_EQ(state.array, std::vector<double>{4});
  }
}

TEST(SnapshotTest, SavingAgainReplacesTheState) {
  double value = 1;
  Snapshot snapshot([&](Record& record) { record.number("value", value); });
  snapshot.save();
  value = 2;
  snapshot.save();
  value = 3;
  snapshot.restore();
  EXPECT_EQ(value, 2);
}

TEST(SnapshotTest, TheRecordKnowsItsSections) {
  bool outer = false, inner = true, part = true;
  Snapshot snapshot([&](Record& record) {
    EXPECT_TRUE(record.in_memory());
    double value = 0;
    if (record.loading()) {
      outer = record.has_section("outer");
      inner = record.has_section("inner");
      part = record.has_section("out");
    }
    const Record::Section section(record, "outer");
    record.number("value", value);
  });
  snapshot.save();
  snapshot.restore();
  EXPECT_TRUE(outer);
  EXPECT_FALSE(inner);
  EXPECT_FALSE(part);
}

TEST(SnapshotTest, NamesOfAnEarlierSaveAreForgotten) {
  bool more = true, section = false;
  Snapshot snapshot([&](Record& record) {
    double value = 5;
    record.number("value", value);
    if (record.loading()) section = record.has_section("more");
    if (!more) return;
    const Record::Section inner(record, "more");
    record.number("value", value);
  });
  snapshot.save();
  const double bytes = snapshot.bytes();
  snapshot.restore();
  EXPECT_TRUE(section);
  more = false;
  snapshot.save();
  EXPECT_LT(snapshot.bytes(), bytes);
  snapshot.restore();
  EXPECT_FALSE(section);
  more = true;
  EXPECT_THROW(snapshot.restore(), std::logic_error);
  snapshot.save();
  snapshot.restore();
  EXPECT_TRUE(section);
}

TEST(SnapshotTest, WhatWasNotSavedIsNotRestored) {
  bool more = false, fails = false;
  Snapshot snapshot([&](Record& record) {
    double value = 0;
    record.number("value", value);
    if (more) record.number("more", value);
    if (fails) throw InputError("it cannot be saved");
  });
  EXPECT_THROW(snapshot.restore(), std::logic_error);
  snapshot.save();
  more = true;
  EXPECT_THROW(snapshot.restore(), std::logic_error);
  more = false;
  snapshot.restore();
  fails = true;
  EXPECT_THROW(snapshot.save(), InputError);
  EXPECT_TRUE(snapshot.empty());
}

}  // namespace
}  // namespace ixos
