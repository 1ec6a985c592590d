#include "scanner/profile_size.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

std::size_t saidBy(const char* json) {
  return raysSaidBy({"head.json", json, {}});
}

TEST(ProfileSize, IsSaidByRowsAndColumnsOrByStripes) {
  EXPECT_EQ(saidBy(R"({"scanner": {"type": "pinhole", "rows": 3000, "columns": 3000}})"), 9'000'000U);
  EXPECT_EQ(saidBy(R"({"scanner": {"type": "rotating_stripe", "samples_per_stripe": 40, "stripes": 30}})"), 1200U);
}

TEST(ProfileSize, OfWhatIsNoProfileIsNotSaid) {
  EXPECT_EQ(saidBy("no JSON"), 0U);
  EXPECT_EQ(saidBy("[]"), 0U);
  EXPECT_EQ(saidBy(R"({"scanner": 7})"), 0U);
  EXPECT_EQ(saidBy(R"({"scanner": {"rows": -4, "columns": "many"}})"), 0U);
}

TEST(MemoryNeeded, GrowsWithTheRaysAndLessWithThoseThatAreNotWorkedOn) {
  const MemoryNeeded small = memoryFor(1'000'000, {});
  EXPECT_EQ(small.worked, 1'000'000U);
  const MemoryNeeded large = memoryFor(9'000'000, {});
  EXPECT_EQ(large.worked, 562'500U);  // every 4th row and column
  EXPECT_GT(large.megabytes, small.megabytes);
  EXPECT_LT(large.everyScan, small.everyScan);
  const MemoryNeeded whole = memoryFor(9'000'000, {0.0});
  EXPECT_EQ(whole.worked, 9'000'000U);
  EXPECT_GT(whole.megabytes, large.megabytes);
  EXPECT_DOUBLE_EQ(whole.with(3), whole.megabytes + 2 * whole.everyScan);
}

}  // namespace
}  // namespace vantage
