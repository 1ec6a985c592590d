#include "geometry/mesh_border.h"

#include <gtest/gtest.h>

#include "geometry/mesh_topology.h"
#include "support/meshes.h"

namespace vantage {
namespace {

TEST(BorderVertices, AreThoseOfTheTopology) {
  Mesh pierced = testing::makeGrid(12, 9, 1.0);
  pierced.triangles.erase(pierced.triangles.begin() + 100);
  // Two holes that meet in one vertex, and a vertex of no triangle.
  pierced.triangles.erase(pierced.triangles.begin() + 60);
  pierced.vertices.emplace_back(0, 0, 0);
  for (const Mesh& mesh : {testing::makeGrid(5, 4, 1.0), testing::makeSphere(10.0, 8),
                           testing::makeBox(Vec3::Zero(), Vec3::Ones(), 3), pierced, Mesh{}})
    EXPECT_EQ(borderVertices(mesh), MeshTopology(mesh).onBoundary());
}

TEST(BorderVertices, FanThatMeetsItselfInOneVertexIsBorder) {
  // A bow tie.
  const Mesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(-1, 0, 0), Vec3(-1, -1, 0)},
                  {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(borderVertices(mesh), MeshTopology(mesh).onBoundary());
}

TEST(BorderVertices, TrianglesThatNameAVertexTwiceHaveNoEdges) {
  Mesh mesh = testing::makeSphere(10.0, 6);
  mesh.triangles.push_back({4, 4, 9});
  EXPECT_EQ(borderVertices(mesh), MeshTopology(mesh).onBoundary());
}

}  // namespace
}  // namespace vantage
