#include "planning/position_sight.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "core/planning/scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

VoidPatch patchAt(const Vec3& centre, const Vec3& normal, double weight) {
  VoidPatch patch;
  patch.centre = centre;
  patch.normal = normal.normalized();
  patch.weight = weight;
  return patch;
}

// A wall of 40 mm that stands in front of the middle of the square.
Mesh wall() {
  return testing::makeBox({100, -20, 80}, {110, 20, 120});
}

PositionSight sightFromFirst(const std::vector<VoidPatch>& patches, const Progress& progress = {}) {
  return computePositionSight(*testing::sceneOf(testing::flatScanner(), wall(), patches), 0, progress);
}

TEST(PositionSight, SortsEveryPatchByTheFirstThingThatKeepsItFromSight) {
  const std::vector<VoidPatch> patches{patchAt({0, 60, 100}, {1, 0, 0}, 1.0),   // free
                                       patchAt({0, 60, 100}, {0, 1, 0}, 2.0),   // seen along its surface
                                       patchAt({0, 0, 100}, {1, 0, 0}, 4.0),    // behind the wall
                                       patchAt({0, -25, 100}, {1, 0, 0}, 8.0),  // beside it, but not for the receiver
                                       patchAt({0, 0, 500}, {1, 0, 0}, 16.0)};  // above every ray
  const PositionSight sight = sightFromFirst(patches);
  EXPECT_EQ(sight.patches[0].visibility, Visibility::Seen);
  EXPECT_NEAR(sight.patches[0].cosine, 1.0, 1e-9);
  for (const auto& [visibility, area] :
       {std::pair{Visibility::Seen, 1.0}, std::pair{Visibility::TooSteep, 2.0},
        std::pair{Visibility::LightBlocked, 4.0}, std::pair{Visibility::ReceiverBlocked, 8.0},
        std::pair{Visibility::OutOfReach, 16.0}}) {
    EXPECT_EQ(sight.count(visibility), 1U) << name(visibility);
    EXPECT_DOUBLE_EQ(sight.area(visibility), area) << name(visibility);
  }
}

TEST(PositionSight, NamesTheTriangleThatBlocks) {
  const Mesh obstacles = wall();
  const std::vector<VoidPatch> patches{patchAt({0, 0, 100}, {1, 0, 0}, 1.0), patchAt({0, -25, 100}, {1, 0, 0}, 1.0),
                                       patchAt({0, 60, 100}, {1, 0, 0}, 1.0)};
  const PositionSight sight = sightFromFirst(patches);
  for (const std::size_t blocked : {0U, 1U}) {
    ASSERT_LT(sight.patches[blocked].blocker, obstacles.triangles.size());
    const Vec3 centre = triangleCentre(obstacles, obstacles.triangles[sight.patches[blocked].blocker]);
    EXPECT_GE(centre.x(), 99.0);
  }
  EXPECT_EQ(sight.patches[2].blocker, kNoIndex);
}

TEST(PositionSight, AnyNumberOfThreadsGivesTheSame) {
  std::vector<VoidPatch> patches;
  patches.reserve(500);
  for (int i = 0; i < 500; ++i) patches.push_back(patchAt({0, -80.0 + 0.3 * i, 100}, {1, 0.01 * i - 2, 0}, 1.0));
  const auto one = sightFromFirst(patches, Progress().withThreads(1));
  const auto four = sightFromFirst(patches, Progress().withThreads(4));
  EXPECT_EQ(one.counts, four.counts);
  for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_EQ(one.patches[p].blocker, four.patches[p].blocker);
}

TEST(PositionSight, RefusesAPositionThatThereIsNot) {
  const auto scene = testing::sceneOf(testing::flatScanner(), wall(), {});
  EXPECT_THROW(static_cast<void>(computePositionSight(*scene, 4, {})), InvalidInput);
  EXPECT_THROW(static_cast<void>(computePositionSight(*scene, -1, {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
