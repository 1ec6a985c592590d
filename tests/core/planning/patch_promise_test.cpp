#include "planning/patch_promise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/planning/scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

constexpr double kBreakdown = radians(60.0);

// A patch in the middle of what the flat scanner sees, turned away from its rays by the angle [rad].
VoidPatch patchTurned(double angle, EdgeClass edgeClass) {
  VoidPatch patch;
  patch.centre = {0, 0, 100};
  patch.normal = {std::cos(angle), std::sin(angle), 0};
  patch.edgeClass = edgeClass;
  return patch;
}

PlannerOptions looking(bool ahead) {
  PlannerOptions options;
  options.lookAhead = ahead;
  return options;
}

TEST(WidestAngle, IsTheBreakdownAngleWhereThePatchContinuesTheSurface) {
  const auto scene = testing::sceneOf(testing::flatScanner(), {}, {patchTurned(0.0, EdgeClass::Regular)});
  EXPECT_DOUBLE_EQ(widestAngle(*scene, scene->patches()[0]), kBreakdown);
}

TEST(WidestAngle, ReachesNearlyToThePlaneOfAnOpening) {
  ScannerProfile profile = testing::flatScanner();
  for (const EdgeClass edgeClass :
       {EdgeClass::OuterJump, EdgeClass::InnerJump, EdgeClass::LineOfSightJump, EdgeClass::Rim}) {
    const VoidPatch patch = patchTurned(0.0, edgeClass);
    profile.breakdownAngle = kBreakdown;
    EXPECT_DOUBLE_EQ(widestAngle(*testing::sceneOf(profile, {}, {}), patch), PlannerOptions().openingAngle);
    profile.breakdownAngle = radians(88.0);
    EXPECT_DOUBLE_EQ(widestAngle(*testing::sceneOf(profile, {}, {}), patch), radians(88.0));
  }
}

TEST(WidestAngle, IsTheBreakdownAngleForAllWithoutLookAhead) {
  const auto scene = testing::sceneOf(testing::flatScanner(), {}, {}, {}, looking(false));
  EXPECT_DOUBLE_EQ(widestAngle(*scene, patchTurned(0.0, EdgeClass::OuterJump)), kBreakdown);
}

TEST(SightOfAPatch, SeesThroughAnOpeningWhereASurfaceWouldBeTooSteep) {
  const auto visibility = [&](double angle, EdgeClass edgeClass, bool ahead) {
    const auto scene =
        testing::sceneOf(testing::flatScanner(), {}, {patchTurned(angle, edgeClass)}, {}, looking(ahead));
    return sightOf(*scene, Pose::Identity(), 0).visibility;
  };
  EXPECT_EQ(visibility(radians(75.0), EdgeClass::InnerJump, true), Visibility::Seen);
  EXPECT_EQ(visibility(radians(89.0), EdgeClass::InnerJump, true), Visibility::TooSteep);
  EXPECT_EQ(visibility(radians(75.0), EdgeClass::Regular, true), Visibility::TooSteep);
  EXPECT_EQ(visibility(radians(75.0), EdgeClass::InnerJump, false), Visibility::TooSteep);
  EXPECT_EQ(visibility(radians(55.0), EdgeClass::Regular, true), Visibility::Seen);
}

// A square patch that leaves its edge along +y.
VoidPatch patchBeyondY() {
  VoidPatch patch;
  patch.centre = {0, 0, 100};
  patch.normal = Vec3::UnitX();
  patch.corners = {Vec3(0, -1, 99), Vec3(0, -1, 101), Vec3(0, 1, 101), Vec3(0, 1, 99)};
  patch.weight = 3.0;
  return patch;
}

TEST(LookAhead, GrowsTheFartherAViewLeansBeyondTheEdge) {
  const VoidPatch patch = patchBeyondY();
  const auto factor = [&](double angle) {
    return lookAhead(patch, {std::cos(angle), std::sin(angle), 0.0}, kBreakdown);
  };
  EXPECT_DOUBLE_EQ(factor(0.0), 1.0);
  EXPECT_NEAR(factor(radians(30.0)), 1.5, 1e-12);  // (60 + 30) / 60
  EXPECT_NEAR(factor(radians(-30.0)), 0.5, 1e-12);
  EXPECT_NEAR(factor(radians(80.0)), 2.0, 1e-12);
}

TEST(PatchPromise, IsWeightTimesCosineTimesWhatLiesAhead) {
  const VoidPatch patch = patchBeyondY();
  const Sight leaning{Visibility::Seen, 0.8, Vec3(std::cos(radians(30.0)), std::sin(radians(30.0)), 0.0)};
  EXPECT_NEAR(patchPromise(*testing::sceneOf(testing::flatScanner(), {}, {patch}), 0, leaning), 3.0 * 0.8 * 1.5, 1e-12);
  const auto paper = testing::sceneOf(testing::flatScanner(), {}, {patch}, {}, looking(false));
  EXPECT_NEAR(patchPromise(*paper, 0, leaning), 3.0 * 0.8, 1e-12);
  EXPECT_EQ(patchPromise(*paper, 0, {Visibility::LightBlocked, 0.8, leaning.direction}), 0.0);
}

}  // namespace
}  // namespace vantage
