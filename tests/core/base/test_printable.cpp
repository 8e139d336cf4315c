#include <gtest/gtest.h>

#include "core/base/printable.h"

namespace trivet {
namespace {

TEST(Printable, KeepsTextAndReplacesWhatIsNone) {
  EXPECT_EQ(printable("a \xc3\xa4 \xe2\x82\xac \xf0\x9f\x8d\xb5"),
            "a \xc3\xa4 \xe2\x82\xac \xf0\x9f\x8d\xb5");
  EXPECT_EQ(printable("two\nlines\tand\x01\x7f"), "two lines and??");
  EXPECT_EQ(printable("\xff\xfe x \x80"), "?? x ?");
  EXPECT_EQ(printable("\xc3"), "?");                 // cut short
  EXPECT_EQ(printable("\xe2\x82"), "??");            // likewise
  EXPECT_EQ(printable("\xc0\xaf"), "??");            // longer than need be
  EXPECT_EQ(printable("\xed\xa0\x80"), "???");       // half of a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "????");  // beyond the last
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a?b");
  EXPECT_EQ(printable("\xc2\x80\xc2\x85\xc2\x9b\xc2\x9f"), "????");  // C1: they steer terminals
  EXPECT_EQ(printable("\xc2\xa0"), "\xc2\xa0");
  EXPECT_EQ(printable("a\xe2\x80\xa8"
                      "b\xe2\x80\xa9"
                      "c"),
            "a b c");  // ends of lines
  EXPECT_EQ(printable("\xe2\x80\xa7\xe2\x80\xaa"), "\xe2\x80\xa7\xe2\x80\xaa");
}

TEST(Printable, CutsBetweenCharacters) {
  EXPECT_EQ(printable("abcdef", 6), "abcdef");
  EXPECT_EQ(printable("abcdef", 5), "abcde...");
  EXPECT_EQ(printable("abc\xe2\x82\xac", 5), "abc...");
  EXPECT_EQ(printable("abc\xe2\x82\xac", 6), "abc\xe2\x82\xac");
}

TEST(Utf8, IsWhatARoundTripThroughCodePointsGives) {
  const auto encoded = [](unsigned c) {
    std::string out;
    if (c < 0x80) return std::string(1, static_cast<char>(c));
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    out += static_cast<char>((0xff00u >> (more + 1) & 0xff) | c >> (6 * more));
    for (int k = more - 1; k >= 0; --k) out += static_cast<char>(0x80 | (c >> (6 * k) & 0x3f));
    return out;
  };
  for (unsigned c = 0; c < 0x120000; c += c < 0x900 ? 1 : 61) {
    const bool valid = c < 0xd800 || (c > 0xdfff && c < 0x110000);
    EXPECT_EQ(is_utf8("x" + encoded(c) + "y"), valid) << c;
  }
}

}  // namespace
}  // namespace trivet
