#include "registration/registration_scale.h"

#include <gtest/gtest.h>

#include "registration/icp.h"
#include "registration/multi_view.h"

namespace vantage {
namespace {

TEST(RegistrationScale, GatesFollowSpacingAndNoise) {
  EXPECT_DOUBLE_EQ(fineGate({2.0, 0.5, 100.0}), 0.5 * 2.0 + 6.0 * 0.5);
  const IcpOptions options = resolved(IcpOptions(), {1.0, 0.0, 120.0});
  EXPECT_DOUBLE_EQ(*options.finalGate, 0.5);
  EXPECT_DOUBLE_EQ(*options.coarseGate, 10.0);
  EXPECT_DOUBLE_EQ(*options.hiddenDepth, 10.0);
  EXPECT_DOUBLE_EQ(*options.limits.maxPoseSigma, 0.08);
}

TEST(RegistrationScale, AToothAndAStatueHaveTheSameOptionsInTheirOwnSize) {
  const RegistrationScale tooth{0.09, 0.004, 9.0};
  const double size = 150.0;
  const RegistrationScale statue{size * tooth.spacing, size * tooth.noise, size * tooth.extent};
  const MultiViewOptions small = resolved(MultiViewOptions(), tooth);
  const MultiViewOptions large = resolved(MultiViewOptions(), statue);
  EXPECT_NEAR(*large.finalGate, size * *small.finalGate, 1e-9);
  EXPECT_NEAR(*large.coarseGate, size * *small.coarseGate, 1e-9);
  EXPECT_NEAR(*large.hiddenDepth, size * *small.hiddenDepth, 1e-9);
  EXPECT_NEAR(looseShift(statue), size * looseShift(tooth), 1e-9);
}

TEST(RegistrationScale, WhatIsSetStaysAndTheRestFits) {
  IcpOptions options;
  options.coarseGate = 0.2;
  EXPECT_LE(*resolved(options, {1.0, 0.1, 120.0}).finalGate, 0.2);
  options.coarseGate.reset();
  options.finalGate = 40.0;
  EXPECT_GE(*resolved(options, {1.0, 0.1, 120.0}).coarseGate, 40.0);
}

TEST(RegistrationScale, OfViewsIsTheMedian) {
  const std::vector<RegistrationScale> views{{1.0, 0.3, 50.0}, {2.0, 0.1, 80.0}, {9.0, 0.2, 60.0}};
  const RegistrationScale scale = scaleOf(views);
  EXPECT_DOUBLE_EQ(scale.spacing, 2.0);
  EXPECT_DOUBLE_EQ(scale.noise, 0.2);
  EXPECT_DOUBLE_EQ(scale.extent, 80.0);
}

}  // namespace
}  // namespace vantage
