// What is told of text from outside, whatever its bytes are.
#include "solver/program/text/input_error.hpp"

#include <gtest/gtest.h>

namespace stationary {
namespace {

TEST(Printable, EscapesWhatIsNoCharacter) {
  EXPECT_EQ(printable("\u03bd = \u00bd, \U0001D54A"), "\u03bd = \u00bd, \U0001D54A");
  EXPECT_EQ(printable("a\tb\x7f"), "a\\x09b\\x7F");
  EXPECT_EQ(printable("mot\xe9on"), "mot\\xE9on");
  EXPECT_EQ(printable("\xff\xce"), "\\xFF\\xCE");
  EXPECT_EQ(printable("\xe2\x82"), "\\xE2\\x82");  // one that is cut short
  EXPECT_EQ(printable("\xc0\xaf"), "\\xC0\\xAF");  // one that is longer than it need be
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9B31m");  // what a terminal may obey
  EXPECT_EQ(printable("\u009b31m\u0085\u2028\u00a0"),
            "\\xC2\\x9B31m\\xC2\\x85\\xE2\\x80\\xA8\u00a0");
}

TEST(Printable, CutsBetweenCharacters) {
  std::string text;
  for (int k = 0; k < 150; ++k) text += "\u03bd";
  EXPECT_EQ(printable(text), text.substr(0, 200) + "...");
  EXPECT_EQ(printable("x" + text), "x" + text.substr(0, 200) + "...");
}

TEST(InputError, KeysFromOutsideArePrintable) {
  const InputError error(Origin::in_file("x\xff.csv", 1, 2), "mot\xe9on.nu", "found it", "");
  EXPECT_STREQ(error.what(), "x\\xFF.csv:1:2: mot\\xE9on.nu: found it");
}

}  // namespace
}  // namespace stationary
