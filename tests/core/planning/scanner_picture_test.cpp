#include "planning/scanner_picture.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"

namespace vantage {
namespace {

// A scanner at x = 200 that looks along -x: 5 rows from z = 10 to 50, 9 columns from y = -40 to 40, a receiver far to
// one side.
ScannerProfile profileWith(const ReceiverOffsets& receivers) {
  ScannerProfile profile;
  profile.rays =
      std::make_shared<const RayGrid>(makeRays(LinearStripe{{200.0, 0.0, 30.0}, 40.0, 5, 9, 80.0}, receivers));
  profile.workspace = turntable(4);
  profile.breakdownAngle = radians(60.0);
  profile.maxRange = 400.0;
  return profile;
}

// A wall across the rays, from the table to z = 35; its front faces the scanner or, from the other side, its back.
Model wall() {
  Model model;
  model.mesh.vertices = {{0.0, -100.0, 0.0}, {0.0, 100.0, 0.0}, {0.0, 100.0, 35.0}, {0.0, -100.0, 35.0}};
  model.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return model;
}

VoidPatch patchAt(double x) {
  VoidPatch patch;
  patch.corners = {Vec3(x, -100.0, 35.0), Vec3(x, 100.0, 35.0), Vec3(x, 100.0, 45.0), Vec3(x, -100.0, 45.0)};
  return patch;
}

TEST(ScannerPicture, ShowsSurfaceWhereRaysMeetItAndNothingElsewhere) {
  const ScannerPicture picture = computeScannerPicture(profileWith({}), 0, wall(), nullptr);
  ASSERT_EQ(picture.rows, 5);
  ASSERT_EQ(picture.columns, 9);
  EXPECT_EQ(picture.count(RaySight::Surface), 27U);  // rows at z = 10, 20 and 30
  EXPECT_EQ(picture.count(RaySight::Nothing), 18U);
  EXPECT_FLOAT_EQ(picture.range[0], 200.0F);
  EXPECT_FLOAT_EQ(picture.cosine[0], 1.0F);
}

TEST(ScannerPicture, FromBehindASurfaceIsItsInside) {
  const ScannerPicture picture = computeScannerPicture(profileWith({}), 2, wall(), nullptr);
  EXPECT_EQ(picture.count(RaySight::Back), 27U);
  EXPECT_EQ(picture.count(RaySight::Surface), 0U);
}

TEST(ScannerPicture, FromTheSideAWallIsMissed) {
  EXPECT_EQ(computeScannerPicture(profileWith({}), 1, wall(), nullptr).count(RaySight::Surface), 0U);
}

TEST(ScannerPicture, VoidIsSeenUnlessSurfaceIsInFrontOfIt) {
  VoidSurface voids;
  voids.patches = {patchAt(0.0)};
  EXPECT_EQ(computeScannerPicture(profileWith({}), 0, wall(), &voids).count(RaySight::Void), 9U);  // the row at z = 40
  Model screen = wall();
  for (Vec3& v : screen.mesh.vertices) v += Vec3(50.0, 0.0, 20.0);
  EXPECT_EQ(computeScannerPicture(profileWith({}), 0, screen, &voids).count(RaySight::Void), 0U);
}

TEST(ScannerPicture, SurfaceThatNoReceiverSeesIsTold) {
  Model model = wall();
  // A board between the wall and the receiver, which stands 300 mm aside.
  const auto first = static_cast<std::uint32_t>(model.mesh.vertices.size());
  for (const Vec3& v : {Vec3(5.0, 60.0, 0.0), Vec3(190.0, 60.0, 0.0), Vec3(190.0, 60.0, 60.0), Vec3(5.0, 60.0, 60.0)})
    model.mesh.vertices.push_back(v);
  model.mesh.triangles.push_back({first, first + 1, first + 2});
  model.mesh.triangles.push_back({first, first + 2, first + 3});
  const auto blocked = [&](double aside) {
    return computeScannerPicture(profileWith({{aside, 0.0, 0.0}}), 0, model, nullptr).count(RaySight::ReceiverBlocked);
  };
  // To either side of the head: the board stands on one of them.
  EXPECT_EQ(blocked(300.0) + blocked(-300.0), 27U);
}

TEST(ScannerPicture, KnowsWhichWayIsUp) {
  const ScannerPicture picture = computeScannerPicture(profileWith({}), 0, wall(), nullptr);
  EXPECT_TRUE(picture.rowsUp);  // a stripe's rows run upward
}

TEST(ScannerPicture, RefusesAPositionThatThereIsNot) {
  EXPECT_THROW((void)computeScannerPicture(profileWith({}), 4, wall(), nullptr), InvalidInput);
  EXPECT_THROW((void)computeScannerPicture(profileWith({}), -1, wall(), nullptr), InvalidInput);
}

}  // namespace
}  // namespace vantage
