#include "finishing/self_crossings.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeSphere;

TEST(SelfCrossings, WhatOnlyTouchesDoesNotCross) {
  EXPECT_EQ(countCrossings(makeSphere(10.0, 20)), 0U);
  EXPECT_EQ(countCrossings(makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1), 4)), 0U);
  EXPECT_EQ(countCrossings(joined(makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1)), makeBox(Vec3(1, 0, 0), Vec3(2, 1, 1)))), 0U);
}

TEST(SelfCrossings, ATriangleThroughAnotherIsOnePair) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {3, 3, 0.5}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(countCrossings(mesh), 1U);
  EXPECT_EQ(crossingsOf(mesh, 1), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(crossingsOf(mesh, 2).empty());
}

TEST(SelfCrossings, OfTwoThatShareACornerTheFarSidesCount) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1, -1}, {1, 2, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(countCrossings(mesh), 1U);
  mesh.vertices[3].z() = 1.0;
  EXPECT_EQ(countCrossings(mesh), 0U);
}

TEST(SelfCrossings, TwoSpheresCrossAlongACircleWhateverTheThreads) {
  const Mesh mesh = joined(makeSphere(10.0, 30), makeSphere(10.0, 30, Vec3(7, 1, 2)));
  const std::size_t count = countCrossings(mesh);
  EXPECT_GT(count, 60U);
  EXPECT_EQ(count, countCrossings(mesh, Progress({}, {}, 4)));
}

}  // namespace
}  // namespace vantage
