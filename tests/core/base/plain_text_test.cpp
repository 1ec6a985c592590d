#include "base/plain_text.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(PlainText, LeavesWordsOfAnyLanguageAsTheyAre) {
  for (const char* text : {"", "mug.ply", "Drehteller ä 1°", "회전대", "поворотный стол", "\xF0\x9F\x8D\xB5"})
    EXPECT_EQ(plainText(text), text);
}

TEST(PlainText, TakesOutWhatSteersATerminalOrAnEditor) {
  EXPECT_EQ(plainText("A\x1b[31mB"), "A\uFFFD[31mB");
  EXPECT_EQ(plainText("one\nscans: 99\ttwo\r"), "one\uFFFDscans: 99\uFFFDtwo\uFFFD");
  EXPECT_EQ(plainText("a\u202Eb\u2066c\u200Fd\u061Ce"), "a\uFFFDb\uFFFDc\uFFFDd\uFFFDe");
  EXPECT_EQ(plainText("a\u0085b\u2028c\x7f"), "a\uFFFDb\uFFFDc\uFFFD");
}

TEST(PlainText, TakesOutBytesThatAreNoText) {
  EXPECT_EQ(plainText("a\xFF"), "a\uFFFD");
  EXPECT_EQ(plainText("\xC0\xAF"), "\uFFFD\uFFFD");
  EXPECT_EQ(plainText("\xE2\x82"), "\uFFFD\uFFFD");
  EXPECT_EQ(plainText("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(plainText("\xF5z"), "\uFFFDz");
}

TEST(PlainText, LinesStayLinesWhereTheyMay) {
  EXPECT_EQ(plainLines("a\nb\tc\n"), "a\nb\uFFFDc\n");
}

}  // namespace
}  // namespace vantage
