#include "registration/position_search.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace vantage {
namespace {

TEST(PositionSearch, FindsThePositionThatAScanWasTakenFrom) {
  const auto profile = testing::makeProfile(0.05, 90, 90);
  const Mesh ball = testing::makeBall();
  const std::vector<View> model{testing::scanFrom(ball, profile, 0), testing::scanFrom(ball, profile, 8)};
  const View scan = testing::scanFrom(ball, profile, 14, 5);
  const auto found =
      poseThatFits(ViewSurface(*scan.mesh, *scan.image->rays), profile->workspace.poses, RegistrationTarget(model), {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->candidate, 14U);
  EXPECT_EQ(found->rivalDistance, 0.0);
}

TEST(PositionSearch, FindsNoneForAnotherObject) {
  const auto profile = testing::makeProfile(0.05, 90, 90);
  const std::vector<View> model{testing::scanFrom(testing::makeBall(), profile, 0)};
  const View scan = testing::scanVase(profile, 14);
  EXPECT_FALSE(poseThatFits(ViewSurface(*scan.mesh, *scan.image->rays), profile->workspace.poses,
                            RegistrationTarget(model), {}));
}

}  // namespace
}  // namespace vantage
