#include "composites/alignment_limits.h"

#include <gtest/gtest.h>

#include <array>

namespace vantage {
namespace {

std::array<double, 11> allOf(const AlignmentLimits& limits) {
  return {limits.voxel(),     limits.margin(),     limits.coarseGate(),   limits.nearGate(),
          limits.closeGate(), limits.mediumGate(), limits.sampleGate(),   limits.fineGate(),
          limits.conflict(),  limits.reliefStep(), limits.distinctShift()};
}

TEST(AlignmentLimits, GrowWithTheObjectAndItsSampling) {
  const auto tooth = allOf(limitsOf({0.1, 0.01, 12.0}, {0.1, 0.01, 11.0}));
  const auto statue = allOf(limitsOf({10.0, 1.0, 1200.0}, {10.0, 1.0, 1100.0}));
  for (std::size_t i = 0; i < tooth.size(); ++i) EXPECT_NEAR(statue[i], 100.0 * tooth[i], 1e-9 * statue[i]) << i;
}

TEST(AlignmentLimits, AreThoseOfTheWorseOfBoth) {
  const AlignmentLimits limits = limitsOf({1.0, 0.2, 100.0}, {2.0, 0.1, 200.0});
  EXPECT_EQ(limits.scale.spacing, 2.0);
  EXPECT_EQ(limits.scale.noise, 0.2);
  EXPECT_EQ(limits.size, 200.0);
}

TEST(AlignmentLimits, FallFromCoarseToFine) {
  const AlignmentLimits limits = limitsOf({1.2, 0.1, 160.0}, {1.2, 0.1, 160.0});
  EXPECT_GT(limits.coarseGate(), limits.nearGate());
  EXPECT_GT(limits.nearGate(), limits.mediumGate());
  EXPECT_GT(limits.mediumGate(), limits.sampleGate());
  EXPECT_GT(limits.sampleGate(), limits.fineGate());
  EXPECT_GT(limits.conflict(), limits.sampleGate());
  EXPECT_NEAR(limits.conflict(), 1.5, 1e-12);
}

}  // namespace
}  // namespace vantage
