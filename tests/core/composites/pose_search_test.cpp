#include "composites/pose_search.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

#include "base/errors.h"
#include "scenes.h"

namespace vantage {
namespace {

PoseSearchOptions fewStarts() {
  PoseSearchOptions options;
  options.starts = 400;
  return options;
}

TEST(PoseSearch, FindsTheTruthWithoutAHint) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const auto found = searchPoses(stands.reference, stands.moved, fewStarts());
  ASSERT_FALSE(found.empty());
  EXPECT_LT(testing::poseError(stands.moved, found[0].T_reference_moved, stands.T_reference_moved), 0.3);
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_LE(found[i].score, found[i - 1].score);
    const PoseDistance d = distanceOf(found[i].T_reference_moved, found[0].T_reference_moved, stands.moved.centroid());
    EXPECT_TRUE(d.turn > radians(2.0) || d.shift > 1.0) << i;
  }
}

TEST(PoseSearch, IsTheSameForAnyNumberOfThreads) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  PoseSearchOptions options;
  options.starts = 60;
  const auto one = searchPoses(stands.reference, stands.moved, options);
  const auto four = searchPoses(stands.reference, stands.moved, options, Progress().withThreads(4));
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_TRUE(one[i].T_reference_moved.matrix() == four[i].T_reference_moved.matrix()) << i;
}

TEST(PoseSearch, StopsWhenAsked) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(
      static_cast<void>(searchPoses(stands.reference, stands.moved, fewStarts(), Progress({}, source.get_token(), 1))),
      Cancelled);
}

TEST(PoseSearch, ARoughPoseIsFitted) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  Pose rough = stands.T_reference_moved;
  rough.rotate(Eigen::AngleAxisd(radians(5.0), Vec3::UnitX()));
  const auto found = fitPoses(stands.reference, stands.moved, std::vector<Pose>{rough}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(testing::poseError(stands.moved, found[0].T_reference_moved, stands.T_reference_moved), 0.3);
}

TEST(PoseSearch, AScoreFallsWithEveryKindOfEvidence) {
  const AlignmentLimits limits = limitsOf({1.2, 0.1, 160.0}, {1.2, 0.1, 160.0});
  const PoseEvidence good{0.5, 0.1, 0.0, 0.0, 0.0};
  const double best = scoreOf(good, limits, 0.01);
  EXPECT_NEAR(best, 0.5, 0.02);
  EXPECT_LT(scoreOf({0.4, 0.1, 0.0, 0.0, 0.0}, limits, 0.01), best);
  EXPECT_LT(scoreOf({0.5, 0.3, 0.0, 0.0, 0.0}, limits, 0.01), best);
  EXPECT_NEAR(scoreOf({0.5, 0.1, 0.01, 0.0, 0.0}, limits, 0.01), best / std::exp(1.0), 1e-12);
  EXPECT_NEAR(scoreOf({0.5, 0.1, 0.0, 0.01, 0.0}, limits, 0.01), best / std::exp(1.0), 1e-12);
  EXPECT_NEAR(scoreOf({0.5, 0.1, 0.0, 0.0, 0.02}, limits, 0.01), best / std::exp(1.0), 1e-12);
  EXPECT_EQ(scoreOf({0.5, 5.0, 0.0, 0.0, 0.0}, limits, 0.01), 0.0);
}

}  // namespace
}  // namespace vantage
