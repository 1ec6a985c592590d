#include "planning/plan_images.h"

#include <gtest/gtest.h>

#include <cmath>

#include "acquisition/steps.h"
#include "base/errors.h"
#include "positional_space/objective_sums.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// The small object after two views, and the plan made of them.
struct TwoViews {
  AcquisitionState state;
  ScannerImages images;
  Plan plan;

  TwoViews() : images(computeScannerImages(*testing::smallProfile())) {
    state.profile = testing::smallProfile();
    const Rig rig = testing::simulation(testing::smallObject(), state.profile, {1, true});
    for (const int position : {0, 5}) {
      auto image = std::make_shared<const RangeImage>(scanFrom(rig, position, {}));
      state = addScan(state, {position, image}, std::nullopt, stepOptionsFor(state), {});
    }
    plan = planAfter(state, images, stepOptionsFor(state), {});
  }

  [[nodiscard]] PlanImages planImages(double tolerance = 0.0) const {
    PlannerOptions options = stepOptionsFor(state).planner;
    options.tolerance = tolerance;
    const std::vector<View> views = viewsOf(state);
    return computePlanImages({*state.profile, images, *state.model, views, 5}, *plan.voids, options, {});
  }
};

TEST(PlanImages, IntersectedWithTheScannerTheyAreTheObjective) {
  const TwoViews scene;
  const PlanImages made = scene.planImages();
  const auto voids = intersect(made.voids, scene.images);
  const auto seen = intersect(made.seen, scene.images);
  ASSERT_EQ(voids.size(), scene.plan.scores.size());
  double most = 0.0;
  for (std::size_t i = 0; i < voids.size(); ++i) {
    const PositionScore& score = scene.plan.scores[i];
    EXPECT_DOUBLE_EQ(seen[i], score.overlapArea) << "position " << i;
    const bool taken = i == 0 || i == 5;
    // Every sighting is rounded to a unit of 2^-20 mm^2; there are fewer than a million of them.
    if (!taken) {
      EXPECT_NEAR(voids[i], score.voidArea, 0.5) << "position " << i;
    }
    most = std::max(most, score.voidArea);
  }
  EXPECT_GT(most, 100.0);
}

TEST(PlanImages, KeepWhichPatchIsSeenThroughWhichCell) {
  const TwoViews scene;
  const PlanImages made = scene.planImages();
  ASSERT_EQ(made.voids.sourceCount(), scene.plan.voids->patches.size());
  EXPECT_FALSE(made.voids.sightings.empty());
}

TEST(PlanImages, SeeOpeningsBeyondTheBreakdownAngleAndSurfaceOnlyWithinIt) {
  const TwoViews scene;
  const PlanImages made = scene.planImages();
  const double breakdown = std::cos(scene.state.profile->breakdownAngle);
  std::size_t beyond = 0;
  for (std::size_t p = 0; p < made.voids.sourceCount(); ++p) {
    const VoidPatch& patch = scene.plan.voids->patches[p];
    for (const Sighting& sighting : made.voids.sightingsOf(p)) {
      const bool steep = static_cast<double>(sighting.confidence) < breakdown;
      EXPECT_FALSE(steep && patch.edgeClass == EdgeClass::Regular) << "patch " << p;
      beyond += steep;
    }
  }
  EXPECT_GT(beyond, 0U);
}

TEST(PlanImages, ATolerancePutsPoorlySampledSurfaceIntoTheVoid) {
  const TwoViews scene;
  const auto without = intersect(scene.planImages().voids, scene.images);
  const auto with = intersect(scene.planImages(0.8).voids, scene.images);
  double added = 0.0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_GE(with[i], without[i]);
    added += with[i] - without[i];
  }
  EXPECT_GT(added, 0.0);
}

TEST(PlanImages, NeedAView) {
  const TwoViews scene;
  const PlanInput input{*scene.state.profile, scene.images, *scene.state.model, {}, -1};
  EXPECT_THROW((void)computePlanImages(input, *scene.plan.voids, {}, {}), InvalidInput);
}

}  // namespace
}  // namespace vantage
