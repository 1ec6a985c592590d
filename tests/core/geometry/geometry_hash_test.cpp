#include "geometry/geometry_hash.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

Mesh oneTriangle() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0)}, {{0, 1, 2}}};
}

// Written down from session files: these numbers must never change.
TEST(GeometryHash, ValuesAreThoseThatFilesHold) {
  ContentHash hash;
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(1, 2, 3);
  addPose(hash, pose);
  EXPECT_EQ(hash.value(), 0x58fff2a4f837ca9bULL);
  EXPECT_EQ(contentHash(oneTriangle()), 0xaaccc797e57e8e1dULL);
}

TEST(GeometryHash, OfAMeshKnowsPositionsAndTriangles) {
  Mesh moved = oneTriangle();
  moved.vertices[2].z() = 1e-300;
  EXPECT_NE(contentHash(moved), contentHash(oneTriangle()));
  Mesh turned = oneTriangle();
  turned.triangles[0] = {0, 2, 1};
  EXPECT_NE(contentHash(turned), contentHash(oneTriangle()));
}

}  // namespace
}  // namespace vantage
