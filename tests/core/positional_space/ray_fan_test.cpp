#include "positional_space/ray_fan.h"

#include <gtest/gtest.h>

#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

std::shared_ptr<const RayGrid> camera(int rows, int columns) {
  return std::make_shared<const RayGrid>(
      makeRays(Pinhole{Vec3(400, 0, 0), Vec3::Zero(), rows, columns, radians(40), radians(30)}, {}));
}

SurfaceCell cellAt(double y, double z) {
  SurfaceCell cell;
  cell.centre = Vec3(150, y, z);
  return cell;
}

TEST(UsefulRays, AreAllOfASmallScanner) {
  const auto rays = camera(900, 1100);
  EXPECT_EQ(usefulRays(rays), rays);
}

TEST(UsefulRays, AreSoFewOfALargeOne) {
  const auto some = usefulRays(camera(1000, 1500));
  EXPECT_EQ(some->rows(), 334);  // every third
  EXPECT_EQ(some->columns(), 500);
}

TEST(RayFan, OfALargeScannerIsThatOfASmallOneWithTheSameView) {
  const auto large = camera(1000, 1500);
  const RayFan many(large, 600.0);
  const RayFan few(camera(100, 150), 600.0);
  for (const double y : {-60.0, 0.0, 35.0}) {
    for (const double z : {-40.0, 5.0}) {
      std::optional<GridPosition> hint;
      std::optional<GridPosition> otherHint;
      const auto one = many.through(cellAt(y, z), Pose::Identity(), hint);
      const auto two = few.through(cellAt(y, z), Pose::Identity(), otherHint);
      ASSERT_TRUE(one && two);
      EXPECT_TRUE(one->direction.isApprox((Vec3(400, 0, 0) - Vec3(150, y, z)).normalized(), 1e-4));
      EXPECT_TRUE(one->direction.isApprox(two->direction, 1e-4));
      EXPECT_TRUE(one->fan.isApprox(two->fan, 0.01)) << one->fan << " and " << two->fan;
      // The ranging ray next to it, counted in the whole grid: within one and a half of its 0.03 degrees.
      EXPECT_GT(-one->direction.dot(large->ray(one->sample).direction), std::cos(radians(0.07)));
    }
  }
}

}  // namespace
}  // namespace vantage
