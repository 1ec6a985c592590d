#include "measuring/surface_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

TEST(SurfacePlane, ThroughThreePointsItsFrontIsWhereTheyAreCounterClockwise) {
  const SurfacePlane plane = planeThrough({Vec3(0, 0, 2), Vec3(1, 0, 2), Vec3(0, 1, 2)});
  EXPECT_NEAR((plane.normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(plane.distance(Vec3(7, -3, 5)), 3.0, 1e-12);
  EXPECT_NEAR(plane.distance(Vec3(7, -3, 0)), -2.0, 1e-12);
}

TEST(SurfacePlane, FitHalvesTheErrors) {
  std::vector<Vec3> points;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) points.emplace_back(x, y, 4.0 + 0.5 * x + ((x + y) % 2 == 0 ? 0.01 : -0.01));
  const SurfacePlane up = planeFit(points, Vec3::UnitZ());
  EXPECT_NEAR(up.normal.dot(Vec3(-0.5, 0, 1).normalized()), 1.0, 1e-5);
  for (const Vec3& p : points) EXPECT_LT(std::abs(up.distance(p)), 0.012);
  const SurfacePlane down = planeFit(points, -Vec3::UnitZ());
  EXPECT_NEAR(up.distance(Vec3(1, 2, 30)), -down.distance(Vec3(1, 2, 30)), 1e-9);
}

TEST(SurfacePlane, RefusesPointsOnALine) {
  EXPECT_THROW(static_cast<void>(planeThrough({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)})), InvalidInput);
  const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}};
  EXPECT_THROW(static_cast<void>(planeFit(line, Vec3::UnitZ())), InvalidInput);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(planeThrough({Vec3(0, 0, nan), Vec3(1, 0, 0), Vec3(0, 1, 0)})), InvalidInput);
  EXPECT_THROW(static_cast<void>(planeFit(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, Vec3::UnitZ())), InvalidInput);
}

}  // namespace
}  // namespace vantage
