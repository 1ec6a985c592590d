#include "geometry/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/errors.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeBox;
using testing::makeGrid;
using testing::makeSphere;

// Two triangles over the diagonal 0-2 of a square.
Mesh square() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(MeshTopology, SquareByHand) {
  const MeshTopology topology(square());
  EXPECT_EQ(topology.neighbour(0, 0), kNoIndex);
  EXPECT_EQ(topology.neighbour(0, 1), kNoIndex);
  EXPECT_EQ(topology.neighbour(0, 2), 1U);
  EXPECT_EQ(topology.neighbour(1, 0), 0U);
  EXPECT_EQ(topology.nonManifoldEdges(), 0U);
  EXPECT_EQ(topology.onBoundary(), (std::vector<std::uint8_t>{1, 1, 1, 1}));
  const auto around = topology.trianglesOf(2);
  EXPECT_EQ(std::vector<std::uint32_t>(around.begin(), around.end()), (std::vector<std::uint32_t>{0, 1}));
}

TEST(MeshTopology, BoundaryEdgesAreDirectedAsInTheirTriangleAndOrderedByIt) {
  const auto edges = MeshTopology(square()).boundaryEdges();
  ASSERT_EQ(edges.size(), 4U);
  const std::vector<BoundaryEdge> expected{{0, 1, 0}, {1, 2, 0}, {2, 3, 1}, {3, 0, 1}};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(edges[i].from, expected[i].from);
    EXPECT_EQ(edges[i].to, expected[i].to);
    EXPECT_EQ(edges[i].triangle, expected[i].triangle);
  }
}

TEST(MeshTopology, NeighboursAreMutualOnClosedMeshes) {
  for (const Mesh& mesh : {makeSphere(5.0, 8), makeBox(Vec3(0, 0, 0), Vec3(1, 2, 3), 3)}) {
    const MeshTopology topology(mesh);
    EXPECT_TRUE(topology.boundaryEdges().empty());
    EXPECT_EQ(topology.nonManifoldEdges(), 0U);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t other = topology.neighbour(t, k);
        ASSERT_NE(other, kNoIndex);
        const bool back =
            topology.neighbour(other, 0) == t || topology.neighbour(other, 1) == t || topology.neighbour(other, 2) == t;
        EXPECT_TRUE(back);
      }
    }
  }
}

TEST(MeshTopology, OnlyTheRimOfAGridIsBoundary) {
  const MeshTopology topology(makeGrid(4, 3, 1.0));
  EXPECT_EQ(topology.boundaryEdges().size(), 14U);
  for (int r = 0; r <= 3; ++r)
    for (int c = 0; c <= 4; ++c)
      EXPECT_EQ(topology.onBoundary()[static_cast<std::size_t>(5 * r + c)], r == 0 || r == 3 || c == 0 || c == 4);
}

TEST(MeshTopology, ThreeTrianglesAtAnEdgeAreNonManifoldAndNoNeighbours) {
  Mesh mesh = square();
  mesh.vertices.emplace_back(0, 0, 1);
  mesh.triangles.push_back({2, 0, 4});
  const MeshTopology topology(mesh);
  EXPECT_EQ(topology.nonManifoldEdges(), 1U);
  EXPECT_EQ(topology.neighbour(0, 2), kNoIndex);
  EXPECT_EQ(topology.boundaryEdges().size(), 6U);
}

TEST(MeshTopology, TrianglesThatDisagreeInOrientationAreNoNeighbours) {
  Mesh mesh = square();
  mesh.triangles[1] = {0, 3, 2};
  const MeshTopology topology(mesh);
  EXPECT_EQ(topology.nonManifoldEdges(), 1U);
  EXPECT_EQ(topology.neighbour(0, 2), kNoIndex);
}

TEST(MeshTopology, ATriangleThatNamesAVertexTwiceHasNoEdges) {
  Mesh mesh = square();
  mesh.triangles.push_back({1, 1, 2});
  const MeshTopology topology(mesh);
  EXPECT_EQ(topology.boundaryEdges().size(), 4U);
  EXPECT_EQ(topology.nonManifoldEdges(), 0U);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(topology.neighbour(2, k), kNoIndex);
}

TEST(MeshTopology, EmptyMeshHasNothing) {
  const MeshTopology topology(Mesh{});
  EXPECT_TRUE(topology.boundaryEdges().empty());
  EXPECT_TRUE(topology.onBoundary().empty());
}

TEST(MeshTopology, RefusesAnIndexOutOfRange) {
  Mesh mesh = square();
  mesh.triangles.push_back({0, 1, kNoIndex});
  EXPECT_THROW(MeshTopology{mesh}, InvalidInput);
}

}  // namespace
}  // namespace vantage
