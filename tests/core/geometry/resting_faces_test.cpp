#include "geometry/resting_faces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "base/random.h"
#include "support/meshes.h"

namespace vantage {
namespace {

TEST(RestingFaces, OfABoxAreItsSidesTheLargestFirst) {
  const auto faces = restingFaces(testing::makeBox(Vec3(0, 0, 0), Vec3(20, 30, 60), 3).vertices);
  ASSERT_EQ(faces.size(), 6U);
  double shares = 0.0;
  for (const RestingFace& face : faces) shares += face.share;
  EXPECT_NEAR(shares, 1.0, 1e-9);
  // The largest side is 30 x 60: the centroid is 10 above it, its foot 15 from the nearest edge.
  EXPECT_NEAR(std::abs(faces[0].normal.x()), 1.0, 1e-9);
  EXPECT_NEAR(faces[0].height, 10.0, 1e-9);
  EXPECT_NEAR(faces[0].margin, std::atan2(15.0, 10.0), 1e-9);
  EXPECT_NEAR(faces[5].height, 30.0, 1e-9);
  EXPECT_NEAR(faces[5].margin, std::atan2(10.0, 30.0), 1e-9);
}

TEST(RestingFaces, TopHeavyConeRollsOffItsTip) {
  std::vector<Vec3> points{Vec3(0, 0, 0)};
  for (int i = 0; i < 60; ++i)
    points.emplace_back(30.0 * std::cos(i * kPi / 30.0), 30.0 * std::sin(i * kPi / 30.0), 50.0);
  const auto faces = restingFaces(points);
  for (const RestingFace& face : faces) EXPECT_GT(face.normal.z(), -0.9);
  EXPECT_NEAR(faces[0].normal.z(), 1.0, 1e-9);
}

TEST(RestingFaces, NoiseOfTheScannerMakesNoFacesOfItsOwn) {
  Random random(3);
  std::vector<Vec3> points = testing::makeBox(Vec3(0, 0, 0), Vec3(40, 50, 60), 20).vertices;
  for (Vec3& p : points) p += 0.1 * Vec3(random.normal(), random.normal(), random.normal());
  const auto faces = restingFaces(points);
  EXPECT_EQ(faces.size(), 6U);
  for (const RestingFace& face : faces) EXPECT_GT(face.normal.cwiseAbs().maxCoeff(), std::cos(radians(3.0)));
}

TEST(RestingFaces, AreAtMostAsManyAsAskedFor) {
  const Mesh ball = testing::makeSphere(30.0, 40);
  EXPECT_EQ(restingFaces(ball.vertices).size(), 16U);
  RestingFaceOptions few;
  few.atMost = 3;
  EXPECT_EQ(restingFaces(ball.vertices, few).size(), 3U);
  EXPECT_THROW(static_cast<void>(restingFaces(std::vector<Vec3>(5, Vec3::Zero()))), InvalidInput);
}

TEST(RestingFaces, BodyRestsOnTheTable) {
  const Mesh box = testing::makeBox(Vec3(5, 6, 7), Vec3(25, 36, 67), 2);
  for (const RestingFace& face : restingFaces(box.vertices)) {
    const Pose T_table_body = restingPose(face);
    double lowest = 1e9;
    for (const Vec3& p : box.vertices) lowest = std::min(lowest, (T_table_body * p).z());
    EXPECT_NEAR(lowest, 0.0, 1e-9);
    EXPECT_LT((T_table_body * Vec3(15, 21, 37) - Vec3(0, 0, face.height)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace vantage
