#include "planning/plan_images.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/planning/scenes.h"
#include "planning/planner.h"
#include "positional_space/objective_sums.h"

namespace vantage {
namespace {

// A plan, and the images that are rebuilt of it.
struct PlanAndImages {
  testing::ScannedObject object{{0, 5}};
  ScannerImages images = computeScannerImages(*object.profile);
  Plan plan = planNextView(object.input(), images, {}, {});
  PlanImages made = computePlanImages(PlanningScene(object.input(), plan.voids, {}, {}), images, {});
};

TEST(PlanImages, IntersectedWithTheScannerTheyAreTheObjective) {
  const PlanAndImages scene;
  const auto voids = intersect(scene.made.voids, scene.images);
  const auto seen = intersect(scene.made.seen, scene.images);
  ASSERT_EQ(voids.size(), scene.plan.scores.size());
  for (std::size_t i = 0; i < voids.size(); ++i) {
    const PositionScore& score = scene.plan.scores[i];
    EXPECT_EQ(seen[i], score.overlapArea) << "position " << i;
    EXPECT_EQ(i == 0 || i == 5 ? 0.0 : voids[i], score.voidArea) << "position " << i;
  }
}

TEST(PlanImages, KeepWhichPatchIsSeenThroughWhichCell) {
  const PlanAndImages scene;
  ASSERT_EQ(scene.made.voids.sourceCount(), scene.plan.voids->patches.size());
  EXPECT_FALSE(scene.made.voids.sightings.empty());
}

TEST(PlanImages, SeeOpeningsBeyondTheBreakdownAngleAndSurfaceOnlyWithinIt) {
  const PlanAndImages scene;
  const double breakdown = std::cos(scene.object.profile->breakdownAngle);
  std::size_t beyond = 0;
  for (std::size_t p = 0; p < scene.made.voids.sourceCount(); ++p) {
    const VoidPatch& patch = scene.plan.voids->patches[p];
    for (const Sighting& sighting : scene.made.voids.sightingsOf(p)) {
      const bool steep = static_cast<double>(sighting.confidence) < breakdown;
      EXPECT_FALSE(steep && patch.edgeClass == EdgeClass::Regular) << "patch " << p;
      beyond += steep;
    }
  }
  EXPECT_GT(beyond, 0U);
}

}  // namespace
}  // namespace vantage
