#include "planning/scanner_picture.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "core/planning/scenes.h"
#include "scanner/ray_patterns.h"

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
Mesh wall() {
  Mesh mesh;
  mesh.vertices = {{0.0, -100.0, 0.0}, {0.0, 100.0, 0.0}, {0.0, 100.0, 35.0}, {0.0, -100.0, 35.0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

ScannerPicture pictureFrom(int position, const Mesh& surface, const std::vector<VoidPatch>& patches = {},
                           const ReceiverOffsets& receivers = {}) {
  return computeScannerPicture(*testing::sceneOf(profileWith(receivers), surface, patches), position, {});
}

VoidPatch patchAt(double x) {
  VoidPatch patch;
  patch.corners = {Vec3(x, -100.0, 35.0), Vec3(x, 100.0, 35.0), Vec3(x, 100.0, 45.0), Vec3(x, -100.0, 45.0)};
  return patch;
}

TEST(ScannerPicture, ShowsSurfaceWhereRaysMeetItAndNothingElsewhere) {
  const ScannerPicture picture = pictureFrom(0, wall());
  ASSERT_EQ(picture.rows, 5);
  ASSERT_EQ(picture.columns, 9);
  EXPECT_EQ(picture.count(RaySight::Surface), 27U);  // rows at z = 10, 20 and 30
  EXPECT_EQ(picture.count(RaySight::Nothing), 18U);
  EXPECT_FLOAT_EQ(picture.range[0], 200.0F);
  EXPECT_FLOAT_EQ(picture.cosine[0], 1.0F);
}

TEST(ScannerPicture, FromBehindASurfaceIsItsInside) {
  const ScannerPicture picture = pictureFrom(2, wall());
  EXPECT_EQ(picture.count(RaySight::Back), 27U);
  EXPECT_EQ(picture.count(RaySight::Surface), 0U);
}

TEST(ScannerPicture, FromTheSideAWallIsMissed) {
  EXPECT_EQ(pictureFrom(1, wall()).count(RaySight::Surface), 0U);
}

TEST(ScannerPicture, VoidIsSeenUnlessSurfaceIsInFrontOfIt) {
  const std::vector<VoidPatch> voids{patchAt(0.0)};
  EXPECT_EQ(pictureFrom(0, wall(), voids).count(RaySight::Void), 9U);  // the row at z = 40
  Mesh screen = wall();
  for (Vec3& v : screen.vertices) v += Vec3(50.0, 0.0, 20.0);
  EXPECT_EQ(pictureFrom(0, screen, voids).count(RaySight::Void), 0U);
}

TEST(ScannerPicture, SurfaceThatNoReceiverSeesIsTold) {
  Mesh mesh = wall();
  // A board between the wall and the receiver, which stands 300 mm aside.
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& v : {Vec3(5.0, 60.0, 0.0), Vec3(190.0, 60.0, 0.0), Vec3(190.0, 60.0, 60.0), Vec3(5.0, 60.0, 60.0)})
    mesh.vertices.push_back(v);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  const auto blocked = [&](double aside) {
    return pictureFrom(0, mesh, {}, {{aside, 0.0, 0.0}}).count(RaySight::ReceiverBlocked);
  };
  // To either side of the head: the board stands on one of them.
  EXPECT_EQ(blocked(300.0) + blocked(-300.0), 27U);
}

TEST(ScannerPicture, KnowsWhichWayIsUp) {
  const ScannerPicture picture = pictureFrom(0, wall());
  EXPECT_TRUE(picture.rowsUp);  // a stripe's rows run upward
}

TEST(ScannerPicture, RefusesAPositionThatThereIsNot) {
  EXPECT_THROW((void)pictureFrom(4, wall()), InvalidInput);
  EXPECT_THROW((void)pictureFrom(-1, wall()), InvalidInput);
}

}  // namespace
}  // namespace vantage
