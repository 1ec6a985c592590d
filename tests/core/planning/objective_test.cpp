#include "planning/objective.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/planning/scenes.h"
#include "planning/candidate_tracing.h"
#include "planning/patch_promise.h"
#include "positional_space/objective_sums.h"
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

PlannerOptions withoutLookAhead() {
  PlannerOptions options;
  options.lookAhead = false;
  return options;
}

const ScannerImages& flatImages() {
  static const ScannerImages images = computeScannerImages(testing::flatScanner());
  return images;
}

TEST(VoidObjective, IsWeightTimesCosineOfThePatchesThatAPositionSees) {
  const double tilt = radians(25.0);
  const std::vector<VoidPatch> patches{patchAt({0, 10, 100}, {1, 0, 0}, 2.0),
                                       patchAt({0, 10, 100}, {std::sin(tilt), std::cos(tilt), 0}, 8.0)};
  const auto scene = testing::sceneOf(testing::flatScanner(), {}, patches, {}, withoutLookAhead());
  const auto areas = voidObjective(*scene, flatImages(), {});
  ASSERT_EQ(areas.size(), 4U);  // the first patch faces position 0; the second position 1, and 0 at 65 degrees
  EXPECT_NEAR(areas[0], 2.0, 0.02);
  EXPECT_NEAR(areas[1], 8.0 * std::cos(tilt), 0.08);
  EXPECT_EQ(areas[2], 0.0);
  EXPECT_EQ(areas[3], 0.0);
}

TEST(VoidObjective, LeavesOutWhatObstaclesHide) {
  const Mesh inTheLight = testing::makeBox({100, -20, 80}, {110, 20, 120});
  const auto scene = testing::sceneOf(testing::flatScanner(), inTheLight, {patchAt({0, 0, 100}, {1, 0, 0}, 2.0)}, {},
                                      withoutLookAhead());
  EXPECT_EQ(voidObjective(*scene, flatImages(), {})[0], 0.0);
}

TEST(VoidObjective, LeavesOutWhatAViewSawAsSquarely) {
  const ScannerProfile profile = testing::flatScanner();
  const auto scene = testing::sceneOf(profile, {}, {patchAt({0, 0, 100}, {1, 0, 0}, 2.0)}, {profile.workspace.poses[0]},
                                      withoutLookAhead());
  EXPECT_EQ(voidObjective(*scene, flatImages(), {})[0], 0.0);
}

// The image is what a view shows of the objective: summed up sighting by sighting, without rounding, it is the same.
TEST(VoidObjective, IsWhatEverySightingOfItsImageAddsToThePositionsOfItsCell) {
  const testing::ScannedObject object({0, 5});
  const ScannerImages images = computeScannerImages(*object.profile);
  PlannerOptions byPatches;
  byPatches.forecast = false;
  const PlanningScene scene(object.input(), byPatches, {});
  const PositionalImage image = voidImage(scene, images, {});
  std::vector<double> sums(object.profile->workspace.size(), 0.0);
  std::vector<double> sightings(sums.size(), 0.0);
  for (std::size_t p = 0; p < image.sourceCount(); ++p) {
    const VoidPatch& patch = scene.patches()[p];
    for (const Sighting& sighting : image.sightingsOf(p)) {
      const auto cosine = static_cast<double>(sighting.confidence);
      if (!scene.history().attracts(p, cosine)) continue;
      const Vec3 direction = (images.ray(sighting.cell).point - patch.centre).normalized();
      const double area = patch.weight * cosine * lookAhead(patch, direction, scene.breakdownAngle());
      for (const int position : images.positionsOf(sighting.cell)) {
        sums[static_cast<std::size_t>(position)] += area;
        sightings[static_cast<std::size_t>(position)] += 1.0;
      }
    }
  }
  const auto areas = voidObjective(scene, images, {});
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_NEAR(areas[i], sums[i], sightings[i] * PositionalImage::kUnit) << "position " << i;
  EXPECT_GT(*std::max_element(areas.begin(), areas.end()), 100.0);
}

TEST(VoidObjective, AgreesWithTheScannersOwnRays) {
  const testing::ScannedObject object({0, 5});
  const ScannerImages images = computeScannerImages(*object.profile);
  const PlanningScene scene(object.input(), {}, {});
  const auto areas = voidObjective(scene, images, {});
  const double most = *std::max_element(areas.begin(), areas.end());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    PositionScore score;
    score.position = static_cast<int>(i);
    traceVoid(score, scene);
    EXPECT_NEAR(areas[i], score.tracedVoidArea.value(), 0.1 * most) << "position " << i;
  }
}

TEST(VoidObjective, CountsPoorlySampledTrianglesForPositionsThatSampleThemBetter) {
  const testing::ScannedObject object({0, 5});
  const ScannerImages images = computeScannerImages(*object.profile);
  PlannerOptions tolerant;
  tolerant.tolerance = 0.8;
  const auto without = voidObjective(PlanningScene(object.input(), {}, {}), images, {});
  const auto with = voidObjective(PlanningScene(object.input(), tolerant, {}), images, {});
  double added = 0.0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_GE(with[i], without[i]);
    added += with[i] - without[i];
  }
  EXPECT_GT(added, 0.0);
}

TEST(OverlapObjective, IsAreaTimesCosineOfTheElementsThatAPositionSees) {
  const auto scene = testing::sceneOf(testing::flatScanner(), {}, {});
  const std::vector<SurfaceElement> elements{{{0, 0, 100}, Vec3::UnitX(), 3.0},
                                             {{0, 0, 100}, Vec3(1, 1, 0).normalized(), 4.0},
                                             {{0, 0, 100}, Vec3::Zero(), 0.0}};
  const auto areas = overlapObjective(*scene, elements, flatImages(), {});
  EXPECT_NEAR(areas[0], 3.0 + 4.0 * std::sqrt(0.5), 0.06);
  EXPECT_NEAR(areas[1], 4.0 * std::sqrt(0.5), 0.03);
  EXPECT_EQ(areas[2], 0.0);
}

}  // namespace
}  // namespace vantage
