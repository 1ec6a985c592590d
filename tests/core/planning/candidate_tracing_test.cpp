#include "planning/candidate_tracing.h"

#include <gtest/gtest.h>

#include <cmath>

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

PositionScore scoreOf(int position) {
  PositionScore score;
  score.position = position;
  return score;
}

PlannerOptions withoutLookAhead() {
  PlannerOptions options;
  options.lookAhead = false;
  return options;
}

TEST(TraceVoid, AddsUpWeightTimesCosineOfWhatThePositionSees) {
  const double tilt = radians(30.0);
  const std::vector<VoidPatch> patches{patchAt({0, 60, 100}, {1, 0, 0}, 1.0),  // seen head-on
                                       patchAt({0, 0, 100}, {1, 0, 0}, 10.0),  // behind the wall
                                       patchAt({0, 70, 100}, {std::cos(tilt), std::sin(tilt), 0}, 2.0),
                                       patchAt({0, 60, 100}, {-1, 0, 0}, 100.0)};  // faces away
  const auto scene = testing::sceneOf(testing::flatScanner(), testing::makeBox({100, -20, 80}, {110, 20, 120}), patches,
                                      {}, withoutLookAhead());
  PositionScore score = scoreOf(0);
  traceVoid(score, *scene);
  EXPECT_NEAR(score.tracedVoidArea.value(), 1.0 + 2.0 * std::cos(tilt), 1e-9);
  EXPECT_EQ(score.patches, (std::vector<std::uint32_t>{0, 2}));
}

TEST(TraceVoid, CountsNothingThatAViewSawAsSquarely) {
  const ScannerProfile profile = testing::flatScanner();
  const auto scene =
      testing::sceneOf(profile, {}, {patchAt({0, 0, 100}, {1, 0, 0}, 1.0)}, {profile.workspace.poses[0]});
  PositionScore score = scoreOf(0);
  traceVoid(score, *scene);
  EXPECT_EQ(score.tracedVoidArea, 0.0);
  EXPECT_TRUE(score.patches.empty());
}

TEST(TraceOverlap, KeepsTheElementsThatThePositionSeesTimesTheirCosine) {
  const auto scene = testing::sceneOf(testing::flatScanner(), {}, {});
  const std::vector<SurfaceElement> elements{{{0, 0, 100}, Vec3::UnitX(), 4.0},
                                             {{0, 0, 100}, -Vec3::UnitX(), 4.0},
                                             {{0, 0, 100}, Vec3(1, 1, 0).normalized(), 4.0}};
  const Overlap overlap = traceOverlap(*scene, 0, elements);
  ASSERT_EQ(overlap.areas.size(), 2U);
  EXPECT_NEAR(overlap.areas[0], 4.0, 1e-9);
  EXPECT_NEAR(overlap.areas[1], 4.0 * std::sqrt(0.5), 1e-9);
  EXPECT_THROW((void)traceOverlap(*scene, 4, elements), InvalidInput);
}

TEST(PredictRegistration, IsSurerOfTwoWallsThatMeetThanOfOne) {
  const auto scene = testing::sceneOf(testing::flatScanner(), {}, {});
  std::vector<SurfaceElement> flat;
  std::vector<SurfaceElement> corner;
  for (int y = -40; y <= 40; y += 4) {
    for (int z = 60; z <= 140; z += 4) {
      flat.push_back({Vec3(0, y, z), Vec3::UnitX(), 16.0});
      corner.push_back({Vec3(-std::abs(y), y, z), Vec3(1, y > 0 ? 1 : -1, 0).normalized(), 16.0});
    }
  }
  PositionScore one = scoreOf(0);
  PositionScore two = scoreOf(0);
  predictRegistration(one, *scene, flat);
  predictRegistration(two, *scene, corner);
  EXPECT_GT(two.poseSigma.value(), 0.0);
  EXPECT_LT(two.poseSigma.value(), one.poseSigma.value());
}

}  // namespace
}  // namespace vantage
