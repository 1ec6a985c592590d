#include "io/text_scanner.h"

#include <cmath>

#include "core/io/expect_error.h"

namespace vantage {
namespace {

using testing::expectError;

TEST(TextScanner, CountsLinesThatEndInAnyWay) {
  TextScanner text("a b\nc\r\nd\re", "file");
  EXPECT_EQ(text.field(), "a");
  EXPECT_EQ(text.fieldOnLine(), "b");
  EXPECT_EQ(text.fieldOnLine(), "");
  EXPECT_EQ(text.field(), "c");
  EXPECT_EQ(text.line(), 2U);
  EXPECT_EQ(text.field(), "d");
  EXPECT_EQ(text.line(), 3U);
  EXPECT_EQ(text.field(), "e");
  EXPECT_EQ(text.line(), 4U);
  EXPECT_EQ(text.field(), "");
}

TEST(TextScanner, NamesFileLineAndValueOfWhatIsNoNumber) {
  TextScanner text("1\n2 x3", "some.off");
  EXPECT_EQ(text.number("a length"), 1.0);
  EXPECT_EQ(text.integer("a count"), 2);
  expectError<InvalidInput>([&] { static_cast<void>(text.number("a height")); },
                            {"some.off", "line 2", "'x3'", "a height"});
  expectError<InvalidInput>([&] { static_cast<void>(text.number("a height")); }, {"the file ends"});
}

TEST(TextScanner, ReadsNumbersInEverySpellingButNothingElse) {
  EXPECT_EQ(parseNumber("+1.5e2"), 150.0);
  EXPECT_EQ(parseNumber("-.5"), -0.5);
  EXPECT_EQ(parseNumber("2."), 2.0);
  EXPECT_TRUE(std::isnan(parseNumber("nan").value()));
  EXPECT_EQ(parseNumber("1e-400"), 0.0);
  EXPECT_TRUE(std::isinf(parseNumber("1e400").value()));
  for (const char* text : {"", "+", "+-1", "1,5", "1.0x", "0x10", "--1"}) EXPECT_FALSE(parseNumber(text)) << text;
  for (const char* text : {"", "1.0", "1e3", "99999999999999999999"}) EXPECT_FALSE(parseInteger(text)) << text;
}

TEST(TextScanner, ReadsDecimalCommasWhereTheyMayStand) {
  EXPECT_EQ(parseDecimal("-1,5e2"), -150.0);
  EXPECT_EQ(parseDecimal("2.5"), 2.5);
  for (const char* text : {"", ",", "1,5,5", "1,000.5", "1,x"}) EXPECT_FALSE(parseDecimal(text)) << text;
}

TEST(TextScanner, ShowsOnlyWhatCanBePrinted) {
  EXPECT_EQ(inQuotes("a\tb\xff"), "'a?b?'");
  EXPECT_EQ(inQuotes(std::string(50, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace vantage
