#include "planning/certificate.h"

#include <gtest/gtest.h>

#include "core/planning/scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

// A patch of 2 mm^2 at a point, two edges wide apart along z so that nothing looks ahead along the horizontal rays.
VoidPatch patchAt(const Vec3& centre, const Vec3& normal) {
  VoidPatch patch;
  patch.centre = centre;
  patch.normal = normal.normalized();
  const Vec3 up = Vec3::UnitZ();
  const Vec3 across = patch.normal.cross(up).normalized();
  patch.corners = {centre - across - up, centre + across - up, centre + across + up, centre - across + up};
  patch.weight = 2.0;
  return patch;
}

class Certificate : public ::testing::Test {
 protected:
  // What is known of the patch when one scan was taken from each of the poses.
  PatchOutlook outlookOf(const VoidPatch& patch, const std::vector<Pose>& taken, const Mesh& obstacles) const {
    PlannerOptions options;
    options.lookAhead = false;
    const auto scene = testing::sceneOf(profile_, obstacles, {patch}, taken, options);
    return certify(*scene, profile_.workspace.poses, {}).front();
  }

  ScannerProfile profile_ = testing::flatScanner();
  Mesh nothing_;
};

TEST_F(Certificate, PromisesWhatTheBestPositionShows) {
  const double tilt = radians(20.0);
  const PatchOutlook outlook = outlookOf(patchAt({0, 0, 100}, {std::cos(tilt), std::sin(tilt), 0}), {}, nothing_);
  EXPECT_EQ(outlook.reason, EdgeReason::BelowThreshold);
  EXPECT_NEAR(outlook.promise, 2.0 * std::cos(tilt), 1e-9);
}

TEST_F(Certificate, PromisesNothingWhereAViewSawItAsSquarely) {
  const VoidPatch patch = patchAt({0, 0, 100}, Vec3::UnitX());
  const PatchOutlook outlook = outlookOf(patch, {profile_.workspace.poses[0]}, nothing_);
  EXPECT_EQ(outlook.looks, 1);
  EXPECT_EQ(outlook.reason, EdgeReason::Answered);
  EXPECT_EQ(outlook.promise, 0.0);
}

TEST_F(Certificate, PromisesMoreWhereAViewOnlySawOneSideOfItsLineOfSight) {
  VoidPatch patch = patchAt({0, 0, 100}, Vec3::UnitX());
  patch.edgeClass = EdgeClass::LineOfSightJump;
  patch.view = 0;
  EXPECT_EQ(outlookOf(patch, {profile_.workspace.poses[0]}, nothing_).looks, 0);
  EXPECT_NEAR(outlookOf(patch, {profile_.workspace.poses[0]}, nothing_).promise, 2.0, 1e-9);
  patch.view = 1;
  EXPECT_EQ(outlookOf(patch, {profile_.workspace.poses[0]}, nothing_).looks, 1);
}

TEST_F(Certificate, NamesWhatBlocksEveryPosition) {
  const VoidPatch patch = patchAt({0, 0, 100}, Vec3::UnitX());
  const Mesh inTheLight = testing::makeBox({100, -5, 95}, {110, 5, 105});
  const Mesh inTheSight = testing::makeBox({140, 20, 95}, {160, 40, 105});
  EXPECT_EQ(outlookOf(patch, {}, inTheLight).reason, EdgeReason::LightBlocked);
  EXPECT_EQ(outlookOf(patch, {}, inTheSight).reason, EdgeReason::ReceiverBlocked);
  EXPECT_EQ(outlookOf(patchAt({0, 0, 100}, Vec3::UnitZ()), {}, nothing_).reason, EdgeReason::TooSteep);
  EXPECT_EQ(outlookOf(patchAt({0, 0, 250}, Vec3::UnitX()), {}, nothing_).reason, EdgeReason::OutOfReach);
}

TEST_F(Certificate, IsAnsweredAfterTwoLooks) {
  const VoidPatch patch = patchAt({0, 0, 100}, Vec3(1.0, 1.0, 0.0));
  const PatchOutlook outlook = outlookOf(patch, {profile_.workspace.poses[0], profile_.workspace.poses[1]}, nothing_);
  EXPECT_TRUE(outlook.answered);
  EXPECT_EQ(outlook.reason, EdgeReason::Answered);
}

TEST(PromiseLeft, AddsUpThePatches) {
  std::vector<PatchOutlook> outlook(3);
  outlook[0].promise = 1.5;
  outlook[2].promise = 2.0;
  EXPECT_DOUBLE_EQ(promiseLeft(outlook), 3.5);
}

}  // namespace
}  // namespace vantage
