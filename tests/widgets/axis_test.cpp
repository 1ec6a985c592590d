#include "charts/axis.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

using Marks = std::vector<double>;

TEST(RoundMarks, AreRoundAndReachTheMaximum) {
  EXPECT_EQ(roundMarks(10.0, 5), (Marks{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
  EXPECT_EQ(roundMarks(2500.0, 3), (Marks{0.0, 1000.0, 2000.0}));
}

TEST(RoundMarks, ThereIsOnlyZeroToMarkOnNothing) {
  EXPECT_EQ(roundMarks(0.0, 4), Marks{0.0});
  EXPECT_EQ(roundMarks(-1.0, 4), Marks{0.0});
}

TEST(ShortNumber, HasThreeDigitsAndThinSpaces) {
  EXPECT_EQ(shortNumber(0.0), "0");
  EXPECT_EQ(shortNumber(0.1234), "0.123");
  EXPECT_EQ(shortNumber(7.0), "7");
  EXPECT_EQ(shortNumber(12.34), "12.3");
  EXPECT_EQ(shortNumber(1234567.8), QString::fromUtf8("1\u2009234\u2009568"));
  EXPECT_EQ(shortNumber(-1500.0), QString::fromUtf8("-1\u2009500"));
}

}  // namespace
}  // namespace vantage
