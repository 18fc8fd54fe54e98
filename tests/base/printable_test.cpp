#include "base/printable.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

TEST(PrintableTest, ControlCharactersAreSpelt) {
  EXPECT_EQ(printable("plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80\n\tend"),
            "plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80\n\tend");
  EXPECT_EQ(printable("\x1b[2J\r\x07\x7f"), "\\x1b[2J\\x0d\\x07\\x7f");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");  // CSI in one character
}

TEST(PrintableTest, WhatIsNotUtf8IsSpelt) {
  // A lone continuation, an overlong slash, a surrogate, beyond U+10FFFF, cut off: RFC 3629.
  EXPECT_EQ(printable("\x80"), "\\x80");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");
}

TEST(PrintableTest, OfALongTextBothEndsStay) {
  const std::string text = "begin" + std::string(1000000, 'x') + "end";
  const std::string shown = printable(text);
  EXPECT_LT(shown.size(), 4000U);
  EXPECT_EQ(shown.rfind("begin", 0), 0U);
  EXPECT_EQ(shown.substr(shown.size() - 3), "end");
}

TEST(PrintableTest, TheFirstUnfitByteIsFound) {
  EXPECT_EQ(first_unfit_byte("fit \xc3\xa9"), std::string::npos);
  EXPECT_EQ(first_unfit_byte("two\nlines"), 3U);
  EXPECT_EQ(first_unfit_byte("ab\xff"), 2U);
}

}  // namespace
}  // namespace ixos
