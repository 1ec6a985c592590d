#include "planning/position_sight.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/meshes.h"

namespace vantage {
namespace {

// A head at x = 300 looking along -x over a 200 mm square, receiver 60 mm to its right (toward +y).
ScannerProfile makeProfile() {
  return parseProfile({"profile.json",
                       R"({
    "name": "test",
    "scanner": { "type": "linear_stripe", "position": [300, 0, 100], "stripe_height_mm": 200, "samples_per_stripe": 101,
      "stripes": 101, "travel_mm": 200, "receivers": [[60, 0, 0]], "breakdown_angle_deg": 60, "range_mm": [100, 400] },
    "workspace": { "type": "turntable", "steps": 4 } })",
                       {}});
}

VoidPatch patchAt(const Vec3& centre, const Vec3& normal, double weight) {
  VoidPatch patch;
  patch.centre = centre;
  patch.normal = normal.normalized();
  patch.weight = weight;
  return patch;
}

// A wall of 40 mm that stands in front of the middle of the square.
Model wall() {
  Model model;
  model.mesh = testing::makeBox({100, -20, 80}, {110, 20, 120});
  return model;
}

TEST(PositionSight, SortsEveryPatchByTheFirstThingThatKeepsItFromSight) {
  const std::vector<VoidPatch> patches{patchAt({0, 60, 100}, {1, 0, 0}, 1.0),   // free
                                       patchAt({0, 60, 100}, {0, 1, 0}, 2.0),   // seen along its surface
                                       patchAt({0, 0, 100}, {1, 0, 0}, 4.0),    // behind the wall
                                       patchAt({0, -25, 100}, {1, 0, 0}, 8.0),  // beside it, but not for the receiver
                                       patchAt({0, 0, 500}, {1, 0, 0}, 16.0)};  // above every ray
  const PositionSight sight = lookFrom(Pose::Identity(), patches, wall(), makeProfile(), 2.0, {});
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
  const Model model = wall();
  const std::vector<VoidPatch> patches{patchAt({0, 0, 100}, {1, 0, 0}, 1.0), patchAt({0, -25, 100}, {1, 0, 0}, 1.0),
                                       patchAt({0, 60, 100}, {1, 0, 0}, 1.0)};
  const PositionSight sight = lookFrom(Pose::Identity(), patches, model, makeProfile(), 2.0, {});
  for (const std::size_t blocked : {0U, 1U}) {
    ASSERT_LT(sight.patches[blocked].blocker, model.mesh.triangles.size());
    const Vec3 centre = triangleCentre(model.mesh, model.mesh.triangles[sight.patches[blocked].blocker]);
    EXPECT_GE(centre.x(), 99.0);
  }
  EXPECT_EQ(sight.patches[2].blocker, kNoIndex);
}

TEST(PositionSight, AnyNumberOfThreadsGivesTheSame) {
  std::vector<VoidPatch> patches;
  patches.reserve(500);
  for (int i = 0; i < 500; ++i) patches.push_back(patchAt({0, -80.0 + 0.3 * i, 100}, {1, 0.01 * i - 2, 0}, 1.0));
  const auto one = lookFrom(Pose::Identity(), patches, wall(), makeProfile(), 2.0, Progress().withThreads(1));
  const auto four = lookFrom(Pose::Identity(), patches, wall(), makeProfile(), 2.0, Progress().withThreads(4));
  EXPECT_EQ(one.counts, four.counts);
  for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_EQ(one.patches[p].blocker, four.patches[p].blocker);
}

TEST(PositionSight, RefusesASpacingThatIsNone) {
  EXPECT_THROW(static_cast<void>(lookFrom(Pose::Identity(), {}, wall(), makeProfile(), 0.0, {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
