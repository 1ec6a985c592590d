#include "geometry/measures.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeGrid;
using testing::makeSphere;

// V - E + F with E = (3 F + boundary edges) / 2.
long eulerCharacteristic(const MeshMeasures& m) {
  const std::size_t edges = (3 * m.triangles + m.boundaryEdges) / 2;
  return static_cast<long>(m.vertices) - static_cast<long>(edges) + static_cast<long>(m.triangles);
}

TEST(Measures, GridByHand) {
  const MeshMeasures m = measure(makeGrid(4, 3, 2.0));
  EXPECT_EQ(m.vertices, 20U);
  EXPECT_EQ(m.triangles, 24U);
  EXPECT_EQ(m.boundaryEdges, 14U);
  EXPECT_EQ(m.boundaryLoops, 1U);
  EXPECT_EQ(m.components, 1U);
  EXPECT_DOUBLE_EQ(m.area, 48.0);
  EXPECT_NEAR(m.meanEdgeLength, (2.0 + 2.0 + 2.0 * std::sqrt(2.0)) / 3.0, 1e-12);
  EXPECT_EQ(m.box.min, Vec3(0, 0, 0));
  EXPECT_EQ(m.box.max, Vec3(8, 6, 0));
}

TEST(Measures, EulerCharacteristicOfDiscSphereAndTwoSpheres) {
  EXPECT_EQ(eulerCharacteristic(measure(makeGrid(5, 5, 1.0))), 1);
  EXPECT_EQ(eulerCharacteristic(measure(makeSphere(1.0, 9))), 2);
  EXPECT_EQ(eulerCharacteristic(measure(makeBox(Vec3(0, 0, 0), Vec3(1, 1, 1), 4))), 2);
  const Mesh two = joined(makeSphere(1.0, 6), makeSphere(1.0, 6, Vec3(5, 0, 0)));
  EXPECT_EQ(eulerCharacteristic(measure(two)), 4);
  EXPECT_EQ(measure(two).components, 2U);
}

TEST(Measures, AreaOfABoxIsExact) {
  const MeshMeasures m = measure(makeBox(Vec3(-1, 0, 2), Vec3(1, 3, 6), 5));
  EXPECT_NEAR(m.area, 2.0 * (2 * 3 + 3 * 4 + 2 * 4), 1e-9);
  EXPECT_TRUE(m.box.size().isApprox(Vec3(2, 3, 4)));
  EXPECT_TRUE(m.box.centre().isApprox(Vec3(0, 1.5, 4)));
}

TEST(Measures, AreaOfASphereApproachesTheFormulaFromBelow) {
  const double exact = 4.0 * kPi * 25.0;
  const double coarse = area(makeSphere(5.0, 16));
  const double fine = area(makeSphere(5.0, 64));
  EXPECT_LT(coarse, fine);
  EXPECT_LT(fine, exact);
  EXPECT_NEAR(fine, exact, 2e-3 * exact);
}

TEST(Measures, AHoleIsASecondBoundaryLoop) {
  Mesh mesh = makeGrid(5, 5, 1.0);
  const std::size_t middle = 2 * (2 * 5 + 2);  // both triangles of the middle square
  mesh.triangles.erase(mesh.triangles.begin() + middle, mesh.triangles.begin() + middle + 2);
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.boundaryLoops, 2U);
  EXPECT_EQ(m.boundaryEdges, 24U);
  EXPECT_EQ(eulerCharacteristic(m), 0);
}

TEST(Measures, TheBoxLeavesOutUnusedVertices) {
  Mesh mesh = makeGrid(1, 1, 1.0);
  mesh.vertices.emplace_back(100, 100, 100);
  EXPECT_EQ(measure(mesh).box.max, Vec3(1, 1, 0));
  EXPECT_EQ(boundingBox(mesh).max, Vec3(100, 100, 100));
}

TEST(Measures, NothingIsNothing) {
  const MeshMeasures m = measure(Mesh{});
  EXPECT_EQ(m.triangles, 0U);
  EXPECT_EQ(m.components, 0U);
  EXPECT_EQ(m.boundaryLoops, 0U);
  EXPECT_EQ(m.area, 0.0);
  EXPECT_EQ(m.box.size(), Vec3(0, 0, 0));
}

TEST(Measures, RefuseAnIndexOutOfRange) {
  EXPECT_THROW(static_cast<void>(measure(Mesh{{Vec3(0, 0, 0)}, {{0, 1, 2}}})), InvalidInput);
}

}  // namespace
}  // namespace vantage
