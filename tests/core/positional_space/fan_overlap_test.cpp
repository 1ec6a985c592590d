#include "positional_space/fan_overlap.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "base/random.h"

namespace vantage {
namespace {

// Numbers of few values, so that borders meet often, and now and then one that is none.
float slope(Random& random) {
  if (random.below(50) == 0) return std::numeric_limits<float>::quiet_NaN();
  if (random.below(50) == 0) return random.below(2) == 0 ? 1e30F : -1e30F;
  return 0.25F * static_cast<float>(random.below(17)) - 2.0F;
}

FanReach randomReach(Random& random, std::size_t cells) {
  FanReach reach;
  for (auto* list : {&reach.lowAcross, &reach.highAcross, &reach.lowUp, &reach.highUp})
    for (std::size_t k = 0; k < cells; ++k) list->push_back(slope(random));
  return reach;
}

TEST(FanOverlap, BordersOverlapAndEachDirectionDecides) {
  const FanReach reach{
      {0.0F, 1.0F, 1.1F, 0.0F}, {0.5F, 2.0F, 2.0F, 0.5F}, {0.0F, 0.0F, 0.0F, 3.0F}, {1.0F, 1.0F, 1.0F, 4.0F}};
  // Cells 0 and 1 touch the range across, cell 2 begins beyond it, cell 3 lies beside it upward.
  EXPECT_EQ(PortableFanOverlap({{0.5F, 1.0F}, {1.0F, 2.0F}})(reach, 0), 0b0011U);
  EXPECT_EQ(PortableFanOverlap({{0.5F, 1.0F}, {1.5F, 3.0F}})(reach, 0), 0b1000U);
}

TEST(FanOverlap, AnswersTheSameOnAnyMachine) {
  Random random(5);
  std::array<int, 16> count{};
  for (int round = 0; round < 200; ++round) {
    const FanReach reach = randomReach(random, 64);
    const FanRange seen{{slope(random), slope(random)}, {slope(random), slope(random)}};
    const FastFanOverlap fast(seen);
    const PortableFanOverlap portable(seen);
    for (std::uint32_t first = 0; first + kFanLanes <= 64; ++first) {
      const unsigned answer = portable(reach, first);
      ASSERT_EQ(fast(reach, first), answer) << "round " << round << ", cell " << first;
      ++count.at(answer);
    }
  }
  for (const int n : count) EXPECT_GT(n, 0);
}

}  // namespace
}  // namespace vantage
