#include "planning/patch_promise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flat_scanner.h"
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

TEST(WidestLook, IsTheBreakdownAngleWhereThePatchContinuesTheSurface) {
  EXPECT_DOUBLE_EQ(widestLook(patchTurned(0.0, EdgeClass::Regular), kBreakdown), kBreakdown);
}

TEST(WidestLook, ReachesNearlyToThePlaneOfAnOpening) {
  for (const EdgeClass edgeClass :
       {EdgeClass::OuterJump, EdgeClass::InnerJump, EdgeClass::LineOfSightJump, EdgeClass::Rim}) {
    EXPECT_GT(widestLook(patchTurned(0.0, edgeClass), kBreakdown), radians(80.0));
    EXPECT_LT(widestLook(patchTurned(0.0, edgeClass), kBreakdown), radians(90.0));
    EXPECT_DOUBLE_EQ(widestLook(patchTurned(0.0, edgeClass), radians(88.0)), radians(88.0));
  }
}

TEST(LookAt, SeesThroughAnOpeningWhereASurfaceWouldBeTooSteep) {
  const ScannerProfile profile = testing::flatScanner();
  const Mesh far = testing::makeBox({0, 400, 100}, {10, 410, 110});
  const RayCaster obstacles(far);
  const SightTest sight(profile, obstacles, {});
  const auto visibility = [&](double angle, EdgeClass edgeClass, std::optional<double> breakdown) {
    return lookAt(sight, Pose::Identity(), patchTurned(angle, edgeClass), breakdown).visibility;
  };
  EXPECT_EQ(visibility(radians(75.0), EdgeClass::InnerJump, kBreakdown), Visibility::Seen);
  EXPECT_EQ(visibility(radians(89.0), EdgeClass::InnerJump, kBreakdown), Visibility::TooSteep);
  EXPECT_EQ(visibility(radians(75.0), EdgeClass::Regular, kBreakdown), Visibility::TooSteep);
  EXPECT_EQ(visibility(radians(75.0), EdgeClass::InnerJump, std::nullopt), Visibility::TooSteep);
  EXPECT_EQ(visibility(radians(55.0), EdgeClass::Regular, kBreakdown), Visibility::Seen);
}

}  // namespace
}  // namespace vantage
