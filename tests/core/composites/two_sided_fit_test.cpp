#include "composites/two_sided_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "composites/alignment_limits.h"
#include "scenes.h"

namespace vantage {
namespace {

TwoSidedFit fitOf(const testing::TwoStands& stands, PointLevel level, TwoSidedFit::Lookup lookup) {
  return {stands.reference, stands.moved, level, lookup, 2.0};
}

TEST(TwoSidedFit, FindsBackToTheTruthFromSomeDegreesOff) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  Pose start = stands.T_reference_moved;
  start.rotate(Eigen::AngleAxisd(radians(6.0), Vec3(1, 2, 3).normalized())).pretranslate(Vec3(2, -1, 1));
  const Pose coarse = fitOf(stands, PointLevel::Coarse, TwoSidedFit::Lookup::Field).run(start, {10.0, 4.0, 12});
  const Pose fine = fitOf(stands, PointLevel::Fine, TwoSidedFit::Lookup::Exact).run(coarse, {4.0, 1.5, 12});
  EXPECT_GT(testing::poseError(stands.moved, start, stands.T_reference_moved), 3.0);
  EXPECT_LT(testing::poseError(stands.moved, coarse, stands.T_reference_moved), 1.5);
  EXPECT_LT(testing::poseError(stands.moved, fine, stands.T_reference_moved), 0.2);
}

TEST(TwoSidedFit, TellsARightPoseFromOneUpsideDown) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const TwoSidedFit fit = fitOf(stands, PointLevel::Medium, TwoSidedFit::Lookup::Exact);
  const FitQuality right = fit.quality(stands.T_reference_moved, 2.0);
  EXPECT_GT(right.overlap, 0.3);
  EXPECT_LT(right.rms, 0.6);
  // The field is as coarse as its cubes.
  EXPECT_LT(right.conflict + right.table, 0.03);
  Pose wrong = Pose::Identity();
  wrong.rotate(Eigen::AngleAxisd(kPi, Vec3::UnitX()));
  wrong.translation() = stands.reference.centroid() - wrong.linear() * stands.moved.centroid();
  const FitQuality off = fit.quality(wrong, 2.0);
  EXPECT_GT(off.conflict + off.table, 3.0 * (right.conflict + right.table));
  EXPECT_LT(off.overlap, right.overlap);
}

TEST(TwoSidedFit, PairsOfBothSidesAreOnTheReference) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  const TwoSidedFit fit = fitOf(stands, PointLevel::Coarse, TwoSidedFit::Lookup::Exact);
  const auto pairs = fit.pairs(stands.T_reference_moved, 1.5);
  ASSERT_EQ(pairs.size(),
            stands.moved.points(PointLevel::Coarse).size() + stands.reference.points(PointLevel::Coarse).size());
  std::size_t paired = 0;
  for (const Pair& pair : pairs) {
    if (pair.state != PairState::Paired) continue;
    ++paired;
    EXPECT_LE(std::abs(pair.distance), 1.5);
    const auto near = stands.reference.field().nearest(pair.point);
    ASSERT_TRUE(near);
    EXPECT_LT(
        (stands.reference.surface().point(stands.reference.surface().walkTo(pair.point, *near)) - pair.point).norm(),
        4.0);
  }
  EXPECT_GT(paired, 100U);
}

TEST(TwoSidedFit, StaysWhereNothingIsNear) {
  const testing::TwoStands& stands = testing::oddBodyInTwoStands();
  Pose away = stands.T_reference_moved;
  away.pretranslate(Vec3(1000, 0, 0));
  const Pose stays = fitOf(stands, PointLevel::Coarse, TwoSidedFit::Lookup::Field).run(away, {10.0, 4.0, 3});
  EXPECT_TRUE(stays.isApprox(away));
}

}  // namespace
}  // namespace vantage
