#include "forecast/level_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/measures.h"

namespace vantage {
namespace {

constexpr double kRadius = 8.3;

Vec3 middle(const VoxelGrid& grid) {
  return grid.low + 0.5 * grid.side * Vec3(grid.counts[0], grid.counts[1], grid.counts[2]);
}

// The distance from a sphere in a box of voxels.
FreeSpace sphere(VoxelState state) {
  FreeSpace space;
  space.grid.counts = {25, 25, 25};
  space.state.assign(space.grid.size(), state);
  for (int z = 0; z < 25; ++z)
    for (int y = 0; y < 25; ++y)
      for (int x = 0; x < 25; ++x)
        space.level.push_back(static_cast<float>((space.grid.centre(x, y, z) - middle(space.grid)).norm() - kRadius));
  return space;
}

TEST(LevelSurface, OfADistanceIsTheSphere) {
  const FreeSpace space = sphere(VoxelState::Unseen);
  const LevelSurface surface = levelSurface(space);
  double area = 0.0;
  for (const LevelFace& face : surface.faces) {
    const Vec3 out = face.centre - middle(space.grid);
    EXPECT_NEAR(out.norm(), kRadius, 0.2);
    EXPECT_GT(face.normal.dot(out.normalized()), 0.9);
    EXPECT_LT(space.level[face.inside], 0.0F);
    area += face.area;
  }
  EXPECT_NEAR(area, 4.0 * kPi * kRadius * kRadius, 0.02 * 4.0 * kPi * kRadius * kRadius);
  EXPECT_EQ(surface.mesh.triangles.size(), 2 * surface.faces.size());
  const MeshMeasures measures = measure(surface.mesh);
  EXPECT_EQ(measures.boundaryEdges, 0U);
  EXPECT_EQ(measures.nonManifoldEdges, 0U);
}

TEST(LevelSurface, LeavesTheModelsOwnOut) {
  EXPECT_TRUE(levelSurface(sphere(VoxelState::Surface)).faces.empty());
}

}  // namespace
}  // namespace vantage
