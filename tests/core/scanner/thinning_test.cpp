#include "scanner/thinning.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

std::shared_ptr<const RayGrid> camera(int rows, int columns) {
  return std::make_shared<const RayGrid>(
      makeRays(Pinhole{Vec3(300, 0, 0), Vec3::Zero(), rows, columns, radians(30), radians(30)}, {Vec3(60, 0, 0)}));
}

// A wall at right angles to the axis, 300 mm away; the sample of ray i has the colour i.
std::shared_ptr<const RangeImage> wall(const std::shared_ptr<const RayGrid>& rays) {
  RangeImage image;
  image.rays = rays;
  image.T_table_scanner.translation() = Vec3(1, 2, 3);
  image.station = {2, 7};
  for (std::size_t i = 0; i < rays->size(); ++i) {
    image.range.push_back(static_cast<float>(-300.0 / rays->ray(i).direction.x()));
    image.colours.push_back({static_cast<std::uint8_t>(i % 256), static_cast<std::uint8_t>(i / 256), 0});
  }
  return std::make_shared<const RangeImage>(std::move(image));
}

TEST(Thinning, KeepsEveryNthRowAndColumnAndLeavesOutAsManyOnEitherSide) {
  const auto rays = camera(8, 11);
  const auto some = thinnedRays(rays, 3);
  ASSERT_EQ(some->rows(), 3);     // 0, 3, 6 of 0..7
  ASSERT_EQ(some->columns(), 4);  // 0, 3, 6, 9 of 0..10
  for (std::size_t i = 0; i < some->size(); ++i) {
    const std::size_t before = rayBeforeThinning(*rays, 3, i);
    EXPECT_EQ(some->ray(i).direction, rays->ray(before).direction) << i;
    EXPECT_EQ(some->receivers(i)[0], rays->receivers(before)[0]) << i;
  }
  EXPECT_EQ(rayBeforeThinning(*camera(9, 9), 3, 0), 9U + 1U);  // 1, 4, 7 of 0..8
}

TEST(Thinning, AnImageKeepsWhatItIsOf) {
  const auto image = wall(camera(8, 11));
  const auto some = thinned(image, 2);
  ASSERT_EQ(some->range.size(), some->rays->size());
  EXPECT_EQ(some->T_table_scanner.matrix(), image->T_table_scanner.matrix());
  EXPECT_EQ(some->station, image->station);
  for (std::size_t i = 0; i < some->range.size(); ++i) {
    const std::size_t before = rayBeforeThinning(*image->rays, 2, i);
    EXPECT_EQ(some->range[i], image->range[before]);
    EXPECT_EQ(some->colours[i], image->colours[before]);
  }
}

TEST(Thinning, StepOneIsTheImageItself) {
  const auto image = wall(camera(5, 5));
  EXPECT_EQ(thinned(image, 1), image);
  EXPECT_EQ(thinnedRays(image->rays, 1), image->rays);
}

TEST(Thinning, RaysThatAreTheSameAreShared) {
  const auto rays = camera(20, 20);
  const auto some = thinnedRays(rays, 2);
  EXPECT_EQ(thinnedRays(rays, 2, some), some);
  EXPECT_NE(thinnedRays(rays, 3, some), some);
  EXPECT_NE(thinnedRays(camera(20, 21), 2, some), some);
}

TEST(Thinning, OfAScannerWithUsefullyManyRaysNothingIsLeftOut) {
  EXPECT_EQ(thinningStep(*wall(camera(300, 400)), {}), 1);
}

TEST(Thinning, AFiveMegapixelHeadIsWorkedOnWithEveryThirdRowAndColumn) {
  RangeImage image;
  image.rays = camera(2048, 2448);
  image.range.assign(image.rays->size(), kNoSample);
  EXPECT_EQ(thinningStep(image, {}), 3);
  EXPECT_EQ(thinningStep(image, {0.0}), 1);
}

TEST(Thinning, TheStepFollowsTheSpacing) {
  const auto image = wall(camera(101, 101));  // 300 mm away: 2 * 300 * tan(15 deg) / 101 = 1.59 mm
  EXPECT_EQ(thinningStep(*image, {1.0}), 1);
  EXPECT_EQ(thinningStep(*image, {3.5}), 2);
  EXPECT_EQ(thinningStep(*image, {5.0}), 3);
  EXPECT_EQ(thinningStep(*image, {1e9}), 100);
  EXPECT_EQ(thinnedRays(image->rays, 100)->size(), 4U);
}

TEST(Thinning, RefusesToLeaveNoGrid) {
  EXPECT_THROW(static_cast<void>(thinnedRays(camera(5, 9), 5)), InvalidInput);
  EXPECT_THROW(static_cast<void>(thinnedRays(camera(5, 9), 0)), InvalidInput);
}

}  // namespace
}  // namespace vantage
