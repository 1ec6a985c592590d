#include "finishing/border_loops.h"

#include <gtest/gtest.h>

#include "geometry/measures.h"
#include "opened_meshes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeGrid;
using testing::makeSphere;
using testing::tube;
using testing::without;

TEST(BorderLoops, AClosedSurfaceHasNone) {
  EXPECT_TRUE(borderLoops(makeSphere(10.0, 12)).empty());
}

TEST(BorderLoops, ATubeHasTwoAsLongAndWideAsItsEnds) {
  const std::vector<BorderLoop> loops = borderLoops(tube());
  ASSERT_EQ(loops.size(), 2U);
  for (const BorderLoop& loop : loops) {
    EXPECT_EQ(loop.vertices.size(), 60U);
    EXPECT_NEAR(loop.length, 60.0 * 20.0 * std::sin(kPi / 60.0), 1e-9);
    EXPECT_NEAR(loop.width, 20.0, 1e-9);
  }
}

TEST(BorderLoops, GoAboutTheOpeningSoThatAFillingAgreesWithTheSurface) {
  Mesh mesh = without(makeGrid(6, 6, 1.0), [](const Vec3& p) { return (p - Vec3(3, 3, 0)).norm() < 1.2; });
  const std::vector<BorderLoop> loops = borderLoops(mesh);
  ASSERT_EQ(loops.size(), 2U);
  const BorderLoop& hole = loops[0].vertices.size() < loops[1].vertices.size() ? loops[0] : loops[1];
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(3.0, 3.0, 0.0);
  for (std::size_t i = 0; i < hole.vertices.size(); ++i)
    mesh.triangles.push_back({hole.vertices[i], hole.vertices[(i + 1) % hole.vertices.size()], middle});
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_EQ(m.boundaryLoops, 1U);
  EXPECT_NEAR(m.area, 36.0, 1e-9);
}

TEST(BorderLoops, PassABowTieFanByFan) {
  // Two squares that share a corner only.
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}};
  EXPECT_EQ(countBowTies(mesh), 1U);
  EXPECT_EQ(borderLoops(mesh).size(), 2U);
  EXPECT_EQ(splitBowTies(mesh), (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(countBowTies(mesh), 0U);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.vertices[7], mesh.vertices[2]);
}

}  // namespace
}  // namespace vantage
