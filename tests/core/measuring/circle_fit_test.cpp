#include "measuring/circle_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

// Of a circle in a slanted plane: an arc.
std::vector<Vec3> arc(const Vec3& centre, const Vec3& normal, double radius, double share, double noise) {
  const Vec3 x = normal.unitOrthogonal();
  const Vec3 y = normal.cross(x);
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * kPi * share * i / 40.0;
    const double r = radius + (i % 2 == 0 ? noise : -noise);
    points.emplace_back(centre + r * std::cos(angle) * x + r * std::sin(angle) * y);
  }
  return points;
}

TEST(CircleFit, ThroughThreePoints) {
  const Circle circle = circleThrough({Vec3(13, 2, 5), Vec3(3, 12, 5), Vec3(-7, 2, 5)});
  EXPECT_NEAR((circle.centre - Vec3(3, 2, 5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(circle.diameter(), 20.0, 1e-9);
  EXPECT_THROW(static_cast<void>(circleThrough({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)})), InvalidInput);
}

TEST(CircleFit, AnArcIsEnough) {
  const Vec3 normal = Vec3(1, -2, 2) / 3.0;
  for (const double share : {1.0, 0.5, 0.2}) {
    const Circle circle = circleFit(arc(Vec3(4, 5, 6), normal, 12.5, share, 0.0));
    EXPECT_NEAR(circle.radius, 12.5, 1e-6) << share;
    EXPECT_NEAR((circle.centre - Vec3(4, 5, 6)).norm(), 0.0, 1e-5) << share;
    EXPECT_NEAR(std::abs(circle.normal.dot(normal)), 1.0, 1e-9);
    EXPECT_NEAR(circle.rms, 0.0, 1e-6);
  }
}

TEST(CircleFit, NoiseIsSaidAndAveraged) {
  const Circle circle = circleFit(arc(Vec3(0, 0, 0), Vec3::UnitZ(), 10.0, 1.0, 0.1));
  EXPECT_NEAR(circle.radius, 10.0, 0.01);
  EXPECT_NEAR(circle.rms, 0.1, 0.01);
}

TEST(CircleFit, ACylinderIsFoundFromAPartOfItsWall) {
  const Vec3 axis = Vec3(1, 2, 5).normalized();
  const Vec3 x = axis.unitOrthogonal();
  const Vec3 y = axis.cross(x);
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 8; ++k) {
      const double angle = 2.0 * i / 12.0;  // about a third of the wall
      // The normals are off, as those of scans are.
      const Vec3 out = std::cos(angle) * x + std::sin(angle) * y;
      normals.push_back((out + 0.05 * (i % 2 == 0 ? 1.0 : -1.0) * axis).normalized());
      points.emplace_back(Vec3(7, 8, 9) + 15.0 * out + 2.0 * k * axis);
    }
  const Cylinder cylinder = cylinderFit(points, normals);
  EXPECT_NEAR(cylinder.diameter(), 30.0, 1e-4);
  EXPECT_NEAR(std::abs(cylinder.axis.dot(axis)), 1.0, 1e-8);
  const Vec3 offset = cylinder.point - Vec3(7, 8, 9);
  EXPECT_LT((offset - offset.dot(axis) * axis).norm(), 1e-4);
  EXPECT_LT(cylinder.rms, 1e-6);
}

TEST(CircleFit, RefusesWhatIsNoCylinder) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}};
  const std::vector<Vec3> flat(points.size(), Vec3::UnitZ());
  EXPECT_THROW(static_cast<void>(cylinderFit(points, flat)), InvalidInput);
  EXPECT_THROW(static_cast<void>(cylinderFit(std::span(points).first(5), std::span(flat).first(5))), InvalidInput);
  EXPECT_THROW(static_cast<void>(cylinderFit(points, std::span(flat).first(5))), InvalidInput);
}

}  // namespace
}  // namespace vantage
