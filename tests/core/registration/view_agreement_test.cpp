#include "registration/view_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "registration/registration_scale.h"
#include "scenes.h"

namespace vantage {
namespace {

// Views that all meet; those named contradict every other.
std::vector<Agreement> agreeing(std::size_t count, const std::vector<std::size_t>& odd) {
  std::vector<Agreement> all(count * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      const bool contradicts = std::count(odd.begin(), odd.end(), i) + std::count(odd.begin(), odd.end(), j) == 1;
      all[i * count + j].paired = 100.0;
      all[i * count + j].through = contradicts ? 60.0 : 0.0;
    }
  }
  return all;
}

TEST(ViewAgreement, TheOddOneLeavesTheSetAlsoWhenItIsTheFirst) {
  const std::vector<int> trust(5, 2);
  const auto out = contradicting(agreeing(5, {0}), trust, 0.02);
  ASSERT_TRUE(out[0]);
  EXPECT_NEAR(*out[0], 60.0 / 160.0, 1e-12);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_FALSE(out[i]) << i;
}

TEST(ViewAgreement, TheFewerLeaveTheMore) {
  const auto out = contradicting(agreeing(5, {1, 3}), std::vector<int>(5, 2), 0.02);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(out[i].has_value(), i == 1 || i == 3) << i;
}

TEST(ViewAgreement, OfTwoThatContradictTheDoubtfulOneLeaves) {
  const auto out = contradicting(agreeing(2, {0}), std::vector<int>{1, 2}, 0.02);
  EXPECT_TRUE(out[0]);
  EXPECT_FALSE(out[1]);
}

TEST(ViewAgreement, SomeEmptinessIsNoContradiction) {
  Agreement agreement;
  agreement.paired = 60.0;
  agreement.empty = 30.0;
  EXPECT_EQ(agreement.contradiction(), 0.0);
  agreement.empty = 140.0;
  EXPECT_NEAR(agreement.contradiction(), 0.7 - 0.4, 1e-12);
}

TEST(ViewAgreement, ScansInTheirPlacesDoNotContradictAndMovedOnesDo) {
  const auto profile = testing::makeProfile(0.05);
  const Mesh ball = testing::makeBall();
  const std::vector<View> views{testing::scanFrom(ball, profile, 0), testing::scanFrom(ball, profile, 9)};
  const auto prepared = prepareViews(views, {});
  std::vector<Pose> poses{views[0].T_object_scanner, views[1].T_object_scanner};
  const PairGates gates{2.5, 10.0, radians(35.0)};
  const Agreement right = agreements(prepared, poses, gates, 1000, {})[1];
  EXPECT_GT(right.paired, 100.0);
  EXPECT_LT(right.contradiction(), 0.005);
  poses[1].translation() += Vec3(8, 0, 0);
  EXPECT_GT(agreements(prepared, poses, gates, 1000, {})[1].contradiction() +
                agreements(prepared, poses, gates, 1000, {})[2].contradiction(),
            0.1);
}

}  // namespace
}  // namespace vantage
