#include "composites/composite_alignment.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "base/errors.h"
#include "base/random.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

CompositeAlignmentOptions quick() {
  CompositeAlignmentOptions options;
  options.search.starts = 400;
  options.refined = 2;
  return options;
}

TEST(CompositeAlignment, ABodyWithoutSymmetryIsAlignedForSure) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const CompositeAlignment found = alignComposites(stands.reference, stands.moved, quick());
  ASSERT_EQ(found.verdict(), AlignmentVerdict::Good) << name(found.judgement.reason);
  ASSERT_FALSE(found.poses.empty());
  const AlignedPose& best = found.poses[found.judgement.choice[0]];
  EXPECT_LT(testing::poseError(stands.moved, best.T_reference_moved, stands.T_reference_moved), 0.15);
  ASSERT_TRUE(best.refinement);
  EXPECT_EQ(best.refinement->moved.size(), stands.moved.composite().views.size());
  EXPECT_GT(best.leastInformation, 1e-3);
}

TEST(CompositeAlignment, APlainBarSlides) {
  const Mesh bar = testing::makeRoundBar();
  const CompositeModel a(testing::acquireStand(bar, testing::standOn(bar, 0, 0.0), 6, 1));
  const CompositeModel b(testing::acquireStand(bar, testing::standOn(bar, 0, 1.0), 6, 2));
  const CompositeAlignment found = alignComposites(a, b, quick());
  ASSERT_FALSE(found.poses.empty());
  EXPECT_NE(found.verdict(), AlignmentVerdict::Good);
}

TEST(CompositeAlignment, ABoxIsAmbiguous) {
  const Mesh box = testing::makeBox(Vec3(-25, -20, 0), Vec3(25, 20, 70), 6);
  const CompositeModel a(testing::acquireStand(box, Pose::Identity(), 8, 1));
  const CompositeModel b(testing::acquireStand(box, Pose(Eigen::AngleAxisd(1.0, Vec3::UnitZ())), 8, 2));
  const CompositeAlignment found = alignComposites(a, b, quick());
  EXPECT_EQ(found.verdict(), AlignmentVerdict::Ambiguous);
}

TEST(CompositeAlignment, AnotherObjectIsRefused) {
  const Mesh other = testing::joined(testing::makeSphere(24, 20, {0, 0, 24}), testing::makeSphere(15, 16, {22, 8, 40}));
  const CompositeModel another(testing::acquireStand(other, testing::standOn(other, 0, 0.3), 6, 4));
  const CompositeAlignment found = alignComposites(testing::oddBodyInTwoStands().reference, another, quick());
  EXPECT_EQ(found.verdict(), AlignmentVerdict::Failed) << name(found.judgement.reason);
  EXPECT_TRUE(found.judgement.choice.empty());
}

TEST(CompositeAlignment, PicksReplaceTheSearchAndNotTheCheck) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  Random random(8);
  const auto off = [&] { return Vec3(2.0 * Vec3(random.normal(), random.normal(), random.normal()).normalized()); };
  std::vector<PickedPair> pairs;
  for (const Vec3& p : {Vec3(28, 0, 20), Vec3(-28, 10, 25), Vec3(0, -20, 10)}) {
    const auto near = stands.reference.field().nearest(stands.reference.centroid() + p - Vec3(0, 0, 15));
    ASSERT_TRUE(near);
    const Vec3 q = stands.reference.surface().point(*near);
    pairs.push_back({q + off(), stands.T_reference_moved.inverse() * q + off()});
  }
  const CompositeAlignment right = alignPicked(stands.reference, stands.moved, pairs, quick());
  ASSERT_EQ(right.verdict(), AlignmentVerdict::Good) << name(right.judgement.reason);
  EXPECT_LT(testing::poseError(stands.moved, right.poses[0].T_reference_moved, stands.T_reference_moved), 0.15);
  std::swap(pairs[0].moved, pairs[1].moved);
  EXPECT_EQ(alignPicked(stands.reference, stands.moved, pairs, quick()).verdict(), AlignmentVerdict::Failed);
}

TEST(CompositeAlignment, IsTheSameForAnyNumberOfThreads) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  CompositeAlignmentOptions options = quick();
  options.search.starts = 60;
  options.refined = 1;
  const auto one = alignComposites(stands.reference, stands.moved, options);
  const auto three = alignComposites(stands.reference, stands.moved, options, Progress().withThreads(3));
  ASSERT_EQ(one.poses.size(), three.poses.size());
  for (std::size_t i = 0; i < one.poses.size(); ++i) {
    EXPECT_TRUE(one.poses[i].T_reference_moved.matrix() == three.poses[i].T_reference_moved.matrix()) << i;
    EXPECT_EQ(one.poses[i].score, three.poses[i].score) << i;
  }
}

TEST(CompositeAlignment, StopsWhenAsked) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  for (const std::string_view step : {"search", "refine", "check"}) {
    std::stop_source source;
    const Progress progress(
        [&](double, std::string_view running) {
          if (running == step) source.request_stop();
        },
        source.get_token(), 1);
    EXPECT_THROW(static_cast<void>(alignComposites(stands.reference, stands.moved, quick(), progress)), Cancelled)
        << step;
  }
}

}  // namespace
}  // namespace vantage
