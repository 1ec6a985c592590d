#include "io/placement.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "core/io/expect_error.h"
#include "geometry/measures.h"
#include "io/mesh_writer.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"
#include "support/test_data.h"

namespace vantage {
namespace {

TEST(Placement, AsIsChangesNothing) {
  const Mesh box = testing::makeBox({1, 2, 3}, {4, 5, 6});
  EXPECT_EQ(placed(box, computePlacement(box, Placement::AsIs, {})).vertices, box.vertices);
}

TEST(Placement, FitMakesATallBoxNineTenthsOfTheHeight) {
  // 6 x 8 wide (radius 5), 100 tall, in a volume of radius 150 and height 300: the height decides.
  const Mesh box = testing::makeBox({10, 20, -7}, {16, 28, 93});
  const PlacementTransform transform = computePlacement(box, Placement::Fit, {150.0, 300.0});
  EXPECT_DOUBLE_EQ(transform.scale, 2.7);
  const BoundingBox result = boundingBox(placed(box, transform));
  EXPECT_NEAR((result.min - Vec3(-8.1, -10.8, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((result.max - Vec3(8.1, 10.8, 270.0)).norm(), 0.0, 1e-12);
}

TEST(Placement, FitMakesAWideBoxNineTenthsOfTheRadius) {
  const Mesh box = testing::makeBox({-3, -4, 0}, {3, 4, 1});
  const PlacementTransform transform = computePlacement(box, Placement::Fit, {150.0, 300.0});
  EXPECT_DOUBLE_EQ(transform.scale, 27.0);
}

TEST(Placement, FitPutsAnyMeshInside) {
  const ViewingVolume volume{120.0, 200.0};
  for (const double size : {1e-3, 1.0, 1e4}) {
    const Mesh mesh = testing::joined(testing::makeSphere(size, 8, {size, 3 * size, -5 * size}),
                                      testing::makeBox({0, 0, 0}, {size, 9 * size, size}));
    const Mesh fitted = placed(mesh, computePlacement(mesh, Placement::Fit, volume));
    EXPECT_TRUE(isInside(fitted, volume, 1e-9));
    EXPECT_FALSE(isInside(placed(fitted, {1.0 / kFittedShare + 0.01, Vec3::Zero()}), volume, 0.0))
        << "not as large as possible";
  }
}

TEST(Placement, RefusesToFitAPoint) {
  const Mesh point{{{1, 1, 1}}, {{0, 0, 0}}};
  EXPECT_THROW(static_cast<void>(computePlacement(point, Placement::Fit, {})), InvalidInput);
}

TEST(Placement, IsReadFromItsName) {
  for (const Placement placement : {Placement::AsIs, Placement::Fit})
    EXPECT_EQ(parsePlacement(name(placement)), placement);
  EXPECT_THROW(static_cast<void>(parsePlacement("beside")), InvalidInput);
}

TEST(Placement, AMeshThatIsReadLiesWhereItsTransformTakesIt) {
  const testing::TemporaryFolder folder;
  const Mesh box = testing::makeBox({2, 2, 3}, {4, 4, 13});
  exportMesh(box, folder.file("box.ply"));
  const ViewingVolume volume{100.0, 200.0};
  EXPECT_EQ(loadPlacedMesh(folder.file("box.ply"), {}, volume).mesh.vertices, box.vertices);
  const PlacedMesh fitted = loadPlacedMesh(folder.file("box.ply"), {Placement::Fit, {}}, volume);
  EXPECT_EQ(fitted.mesh.vertices, placed(box, fitted.transform).vertices);
  EXPECT_NEAR(boundingBox(fitted.mesh).size().z(), kFittedShare * volume.height, 1e-9);
}

// A camera with a pixel per millimetre at the axis, before a volume of 100 x 200 mm.
ScannerProfile cameraProfile() {
  ScannerProfile profile;
  profile.rays =
      std::make_shared<const RayGrid>(makeRays(Pinhole{{400, 0, 100}, {0, 0, 100}, 100, 100, 0.25, 0.25}, {}));
  profile.viewingVolume = {100.0, 200.0};
  profile.workspace.poses = {Pose::Identity()};
  return profile;
}

TEST(Placement, AMeshTooSmallForTheScannerIsOfAnotherUnit) {
  const ScannerProfile profile = cameraProfile();
  const Mesh part = testing::makeBox({0, 0, 0}, {1, 2, 3});
  const auto units = unitsInDoubt(part, profile);
  ASSERT_EQ(units.size(), 3U);
  EXPECT_EQ(units[1].unit, LengthUnit::Centimetre);
  EXPECT_EQ(units[2].unit, LengthUnit::Inch);
  EXPECT_NEAR(units[2].size, 76.2, 1e-9);
  testing::expectError<InvalidInput>([&] { requireClearUnit("part.stl", {}, part, profile); },
                                     {"part.stl", "3 mm in size", "cm (30 mm), inch (76.2 mm)", "--unit"});
  requireClearUnit("part.stl", {Placement::AsIs, 1.0}, part, profile);
  requireClearUnit("part.stl", {Placement::Fit, {}}, part, profile);
  requireClearUnit("part.stl", {}, testing::makeBox({0, 0, 0}, {10, 20, 30}), profile);
}

TEST(Placement, TheUnitOfTheFileScalesTheMesh) {
  const testing::TemporaryFolder folder;
  exportMesh(testing::makeBox({0, 0, 0}, {1, 2, 3}), folder.file("box.ply"));
  const ViewingVolume volume{100.0, 200.0};
  const PlacedMesh inches = loadPlacedMesh(folder.file("box.ply"), {Placement::AsIs, 25.4}, volume);
  EXPECT_NEAR(boundingBox(inches.mesh).size().z(), 76.2, 1e-5);
  EXPECT_EQ(inches.transform.scale, 25.4);
}

TEST(Placement, IsInsideKnowsAllSidesOfTheCylinder) {
  const ViewingVolume volume{10.0, 20.0};
  auto inside = [&](const Vec3& p) { return isInside(Mesh{{p}, {}}, volume, 0.5); };
  EXPECT_TRUE(inside({10.4, 0, 0}));
  EXPECT_FALSE(inside({8, 8, 10}));
  EXPECT_FALSE(inside({0, 0, -0.6}));
  EXPECT_FALSE(inside({0, 0, 20.6}));
}

}  // namespace
}  // namespace vantage
