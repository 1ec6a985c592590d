#include "cli/text.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(CommandLineText, CountsInWords) {
  EXPECT_EQ(counted(1, "opening"), "1 opening");
  EXPECT_EQ(counted(0, "opening"), "0 openings");
  EXPECT_EQ(counted(3, "opening"), "3 openings");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(2, "vertex", "vertices"), "2 vertices");
}

TEST(CommandLineText, WritesNumbersWithFixedDecimals) {
  EXPECT_EQ(number(2.0, 2), "2.00");
  EXPECT_EQ(number(-0.126, 2), "-0.13");
}

}  // namespace
}  // namespace vantage
