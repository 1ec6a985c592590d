#include "geometry/mesh_union.h"

#include <gtest/gtest.h>

#include <array>

namespace vantage {
namespace {

TEST(MeshUnion, KeepsEveryTriangleOnItsOwnVertices) {
  const Mesh low{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Mesh high{{{9, 9, 9}, {0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{1, 2, 3}, {3, 2, 1}}};
  const std::array<const Mesh*, 3> parts{&low, &high, &low};
  const Mesh all = together(parts);
  ASSERT_EQ(all.vertices.size(), 10U);
  EXPECT_EQ(all.triangles, (std::vector<Triangle>{{0, 1, 2}, {4, 5, 6}, {6, 5, 4}, {7, 8, 9}}));
  EXPECT_EQ(all.vertices[4], Vec3(0, 0, 5));
}

TEST(MeshUnion, OfNothingIsNothing) {
  EXPECT_TRUE(together({}).empty());
}

}  // namespace
}  // namespace vantage
