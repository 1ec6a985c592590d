#include "scanner/ray_patterns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vantage {
namespace {

TEST(RotatingStripe, RaysByHand) {
  const RayGrid rays = makeRays(RotatingStripe{Vec3(300, 0, 150), 300, 3, 5, radians(60)}, {Vec3(60, 0, 0)});
  ASSERT_EQ(rays.rows(), 3);
  ASSERT_EQ(rays.columns(), 5);
  const RangingRay& middle = rays.ray(rays.index(1, 2));
  EXPECT_TRUE(middle.origin.isApprox(Vec3(300, 0, 150)));
  EXPECT_TRUE(middle.direction.isApprox(Vec3(-1, 0, 0)));
  const RangingRay& corner = rays.ray(rays.index(2, 4));
  EXPECT_TRUE(corner.origin.isApprox(Vec3(300, 0, 300)));
  EXPECT_TRUE(corner.direction.isApprox(Vec3(-std::cos(radians(30)), std::sin(radians(30)), 0)));
  EXPECT_TRUE(rays.ray(0).origin.isApprox(Vec3(300, 0, 0)));
  // right = forward x up; looking along -x with z up, right is +y.
  EXPECT_TRUE(rays.receivers(rays.index(1, 2))[0].isApprox(Vec3(300, 60, 150)));
}

TEST(RotatingStripe, ReceiversTurnWithTheHeadAndStayAtItsHeight) {
  const RayGrid rays = makeRays(RotatingStripe{Vec3(300, 0, 150), 300, 3, 5, radians(60)}, {Vec3(60, 0, 0)});
  const Vec3 receiver = rays.receivers(rays.index(2, 4))[0];
  EXPECT_TRUE(receiver.isApprox(Vec3(300 + 60 * std::sin(radians(30)), 60 * std::cos(radians(30)), 150)));
}

TEST(LinearStripe, RaysAndReceiversByHand) {
  const RayGrid rays = makeRays(LinearStripe{Vec3(300, 10, 150), 100, 3, 5, 40}, {Vec3(80, 0, 0), Vec3(-80, 5, 20)});
  const std::size_t i = rays.index(0, 4);
  EXPECT_TRUE(rays.ray(i).origin.isApprox(Vec3(300, 30, 100)));
  EXPECT_TRUE(rays.ray(i).direction.isApprox(Vec3(-1, 0, 0)));
  ASSERT_EQ(rays.receivers(i).size(), 2U);
  EXPECT_TRUE(rays.receivers(i)[0].isApprox(Vec3(300, 110, 150)));
  EXPECT_TRUE(rays.receivers(i)[1].isApprox(Vec3(280, -50, 155)));
}

TEST(Pinhole, RaysRunThroughPixelCentresRowZeroOnTop) {
  const Pinhole camera{Vec3(100, 0, 0), Vec3(0, 0, 0), 2, 2, radians(90), radians(90)};
  const RayGrid rays = makeRays(camera, {});
  // Pixel centres are half way between the axis and the edge of the image at 45 degrees. Seen from +x, +y is right.
  EXPECT_TRUE(rays.ray(rays.index(0, 0)).direction.isApprox(Vec3(-1, -0.5, 0.5).normalized()));
  EXPECT_TRUE(rays.ray(rays.index(1, 1)).direction.isApprox(Vec3(-1, 0.5, -0.5).normalized()));
  EXPECT_FALSE(rays.triangulates());
}

TEST(Pinhole, LooksWhereItIsToldAndKeepsZUp) {
  const RayGrid rays = makeRays(Pinhole{Vec3(200, 100, 300), Vec3(0, 0, 50), 3, 3, radians(40), radians(30)}, {});
  const RangingRay& middle = rays.ray(rays.index(1, 1));
  EXPECT_TRUE(middle.direction.isApprox((Vec3(0, 0, 50) - Vec3(200, 100, 300)).normalized()));
  EXPECT_GT(rays.ray(rays.index(0, 1)).direction.z(), middle.direction.z());
  EXPECT_NEAR(rays.ray(rays.index(1, 0)).direction.z(), rays.ray(rays.index(1, 2)).direction.z(), 1e-12);
}

}  // namespace
}  // namespace vantage
