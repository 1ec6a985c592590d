#include "void_space/ray_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/errors.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::makePlate;
using testing::parallelScanner;
using testing::scanView;

TEST(RayIndex, RayThroughAPointPassesIt) {
  const std::vector<View> views{scanView(makePlate(0, -25, 25), parallelScanner())};
  const auto passage = RayIndex(views).through(0, {10, 3.25, 44.5});
  ASSERT_TRUE(passage);
  EXPECT_TRUE(passage->line.direction.isApprox(Vec3(-1, 0, 0), 1e-9));
  EXPECT_NEAR((passage->line.origin - Vec3(300, 3.25, 44.5)).norm(), 0.0, 1e-3);
  EXPECT_NEAR(passage->depth, 290.0, 1e-9);
  EXPECT_NEAR(passage->spacing, 1.0, 1e-9);
  EXPECT_NEAR(passage->position.row, 24.5, 1e-3);
  EXPECT_NEAR(passage->position.column, 33.25, 1e-3);
  ASSERT_TRUE(passage->sampleDepth) << "the plate at x = 0";
  EXPECT_NEAR(*passage->sampleDepth, 300.0, 1e-4);
}

TEST(RayIndex, AnswersInObjectCoordinatesForATurnedView) {
  // Position 9 of 36 turns the scanner by 90 degrees: it looks along -y.
  const std::vector<View> views{scanView(makePlate(0, -25, 25), parallelScanner("[50, 0, 0]"), 9)};
  const RayIndex index(views);
  const auto passage = index.through(0, {5, 10, 50});
  ASSERT_TRUE(passage);
  EXPECT_TRUE(passage->line.direction.isApprox(Vec3(0, -1, 0), 1e-9));
  EXPECT_NEAR(passage->depth, 290.0, 1e-9);
  EXPECT_FALSE(passage->sampleDepth) << "the plate is seen edge-on";
  const std::vector<Vec3> receivers = index.receivers(*passage);
  ASSERT_EQ(receivers.size(), 1U);
  EXPECT_NEAR((receivers[0] - Vec3(5 - 50, 300, 50)).norm(), 0.0, 1e-6) << "right of a scanner that looks along -y";
}

TEST(RayIndex, FindsNothingBesideTheSamplingArea) {
  const std::vector<View> views{scanView(makePlate(0, -25, 25), parallelScanner())};
  const RayIndex index(views);
  EXPECT_TRUE(index.through(0, {0, 30.4, 50}));
  EXPECT_FALSE(index.through(0, {0, 31, 50}));
  EXPECT_FALSE(index.through(0, {0, 0, 81}));
  EXPECT_FALSE(index.through(0, {400, 0, 50})) << "behind the scanner";
}

TEST(RayIndex, HintDoesNotChangeTheAnswer) {
  const std::vector<View> views{scanView(makePlate(0, -25, 25), parallelScanner())};
  const RayIndex index(views);
  const auto free = index.through(0, {10, 3.25, 44.5});
  const auto hinted = index.through(0, {10, 3.25, 44.5}, GridPosition{2.0, 60.0});
  ASSERT_TRUE(free && hinted);
  EXPECT_NEAR(free->position.row, hinted->position.row, 1e-3);
  EXPECT_NEAR(free->position.column, hinted->position.column, 1e-3);
}

TEST(RayIndex, RayOfASampleIsThatRay) {
  const std::vector<View> views{scanView(makePlate(0, -25, 25), parallelScanner())};
  const auto sample = static_cast<std::uint32_t>(views[0].image->rays->index(30, 30));
  const RayPassage passage = RayIndex(views).ofSample(0, sample, {0, 0.5, 50});
  EXPECT_EQ(passage.ray, sample);
  EXPECT_EQ(passage.line.origin, views[0].image->rays->ray(sample).origin);
  EXPECT_DOUBLE_EQ(passage.position.row, 30.0);
  EXPECT_DOUBLE_EQ(passage.position.column, 30.0);
  EXPECT_NEAR(passage.depth, 300.0, 1e-9);
  EXPECT_NEAR(passage.sampleDepth.value_or(0.0), 300.0, 1e-4);
}

TEST(RayIndex, DepthsAroundAreThoseOfTheNineNearestRays) {
  const std::vector<View> views{scanView(testing::makeStep(), parallelScanner())};
  const RayIndex index(views);
  std::vector<double> depths = index.depthsAround(*index.through(0, {20, 0, 50}));
  ASSERT_EQ(depths.size(), 9U);
  std::sort(depths.begin(), depths.end());
  EXPECT_NEAR(depths[5], 280.0, 1e-4) << "six rays, y = -1 and 0, meet the near plate";
  EXPECT_NEAR(depths[6], 320.0, 1e-4) << "three rays, y = 1, the far one";
}

TEST(RayIndex, RefusesAViewWithoutAnImage) {
  const std::vector<View> views(1);
  EXPECT_THROW(RayIndex{views}, InvalidInput);
}

}  // namespace
}  // namespace vantage
