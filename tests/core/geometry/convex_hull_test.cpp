#include "geometry/convex_hull.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "support/meshes.h"

namespace vantage {
namespace {

TEST(ConvexHull, OfABoxHasItsCornersVolumeAndCentre) {
  const Mesh box = testing::makeBox(Vec3(1, 2, 3), Vec3(5, 8, 11), 4);
  const ConvexHull hull = convexHull(box.vertices);
  EXPECT_EQ(hull.mesh.vertices.size(), 8U);
  EXPECT_NEAR(hull.volume, 4.0 * 6.0 * 8.0, 1e-9);
  EXPECT_LT((hull.centroid - Vec3(3, 5, 7)).norm(), 1e-9);
  for (std::size_t i = 0; i < hull.point.size(); ++i)
    EXPECT_EQ(hull.mesh.vertices[i], box.vertices[hull.point[i]]) << i;
}

TEST(ConvexHull, IsClosedOutwardAndHoldsAllPoints) {
  Random random(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(random.normal(), 2.0 * random.normal(), 3.0 * random.normal());
  const ConvexHull hull = convexHull(points);
  const MeshMeasures measures = measure(hull.mesh);
  EXPECT_EQ(measures.boundaryEdges + measures.nonManifoldEdges, 0U);
  EXPECT_GT(hull.volume, 0.0);
  for (std::size_t t = 0; t < hull.mesh.triangles.size(); ++t) {
    EXPECT_GT(hull.normals[t].dot(triangleNormal(hull.mesh, hull.mesh.triangles[t])), 0.999) << t;
    const double plane = hull.normals[t].dot(hull.mesh.vertices[hull.mesh.triangles[t][0]]);
    for (const Vec3& p : points) ASSERT_LT(hull.normals[t].dot(p), plane + 1e-9);
  }
}

TEST(ConvexHull, RefusesWhatHasNoVolume) {
  EXPECT_THROW(static_cast<void>(convexHull(testing::makeGrid(3, 3, 1.0).vertices)), InvalidInput);
  EXPECT_THROW(static_cast<void>(convexHull(std::vector<Vec3>(3, Vec3::Zero()))), InvalidInput);
}

}  // namespace
}  // namespace vantage
