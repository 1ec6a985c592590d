#include "finishing/patch_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"

namespace vantage {
namespace {

// A flat disc of long triangles between the vertices of its border.
Mesh fanDisc(int count, double radius) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * i / count;
    mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  for (int i = 1; i + 1 < count; ++i)
    mesh.triangles.push_back({0, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)});
  return mesh;
}

double smallestAngle(const Mesh& mesh) {
  double smallest = kPi;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]];
      const Vec3 v = mesh.vertices[t[(k + 2) % 3]] - mesh.vertices[t[k]];
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  return smallest;
}

TEST(PatchRefinement, LeavesTheBorderAndCutsWhatIsTooLong) {
  const Mesh before = fanDisc(60, 10.0);
  Mesh patch = before;
  refinePatch(patch, 1.0, {});
  ASSERT_GT(patch.vertices.size(), 60U + 200U);
  for (std::size_t v = 0; v < 60; ++v) EXPECT_EQ(patch.vertices[v], before.vertices[v]);
  const MeshMeasures m = measure(patch);
  EXPECT_EQ(m.boundaryEdges, 60U);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_EQ(m.components, 1U);
  EXPECT_NEAR(m.area, area(before), 1e-9);
  for (const Triangle& t : patch.triangles) {
    EXPECT_GT(areaVector(patch, t).z(), 0.0);
    for (int k = 0; k < 3; ++k) EXPECT_LE((patch.vertices[t[k]] - patch.vertices[t[(k + 1) % 3]]).norm(), 1.8);
  }
  EXPECT_GT(smallestAngle(patch), radians(15.0));
}

TEST(PatchRefinement, TurnsEdgesButNotIntoOnesThatTheSurfaceHas) {
  Mesh kite;
  kite.vertices = {{-5, 0, 0}, {0, -1, 0}, {5, 0, 0}, {0, 1, 0}};
  kite.triangles = {{0, 1, 2}, {0, 2, 3}};
  Mesh turned = kite;
  turnEdges(turned, {});
  for (const Triangle& t : turned.triangles) EXPECT_NE(std::find(t.begin(), t.end(), 1U), t.end());
  Mesh kept = kite;
  turnEdges(kept, [](std::uint32_t a, std::uint32_t b) { return a + b == 4 && a != b; });
  EXPECT_EQ(kept.triangles, kite.triangles);
}

}  // namespace
}  // namespace vantage
