#include "planning/void_extent.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr VoidExtentOptions kOptions{5.0, 10.0};

// A patch in the plane z = 0 with its edge at x, 1 mm wide along y, pointing along +x or -x.
VoidPatch patchAt(double x, double sense, double y = 0.0) {
  VoidPatch patch;
  patch.corners = {Vec3(x, y + 0.5, 0), Vec3(x, y - 0.5, 0), Vec3(x + sense, y - 0.5, 0), Vec3(x + sense, y + 0.5, 0)};
  return patch;
}

TEST(VoidExtents, AnOpenPatchCountsInFull) {
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, 1)}, kOptions), std::vector{1.0});
}

TEST(VoidExtents, ASlitCountsByItsWidth) {
  const auto extents = voidExtents(std::vector{patchAt(0, 1), patchAt(2, -1)}, kOptions);
  EXPECT_DOUBLE_EQ(extents[0], 0.2);
  EXPECT_DOUBLE_EQ(extents[1], 0.2);
}

TEST(VoidExtents, APatchAtAWideHoleCountsMoreThanAnOpenOne) {
  const std::vector<VoidPatch> patches{patchAt(0, 1), patchAt(16, -1)};
  EXPECT_EQ(voidExtents(patches, {5.0, 20.0}), (std::vector{1.6, 1.6}));
  EXPECT_EQ(voidExtents(patches, {5.0, 15.0}), (std::vector{1.0, 1.0}));
}

// The strips ahead of all edges together are as large as the hole: those who face a patch within 60 degrees begin at
// half the diameter, so a strip is a quarter of it wide.
TEST(VoidExtents, OfARoundHoleMakeUpItsArea) {
  constexpr int kSides = 120;
  constexpr double kPi = 3.14159265358979323846;
  for (const double diameter : {4.0, 8.0}) {
    std::vector<VoidPatch> patches;
    const double side = kPi * diameter / kSides;
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2.0 * kPi * i / kSides;
      const Vec3 inwards(-std::cos(angle), -std::sin(angle), 0.0);
      const Vec3 along = 0.5 * side * Vec3(-inwards.y(), inwards.x(), 0.0);
      const Vec3 place = -0.5 * diameter * inwards;
      patches.emplace_back().corners = {place + along, place - along, place - along + inwards, place + along + inwards};
    }
    double strips = 0.0;
    for (const double extent : voidExtents(patches, kOptions)) strips += extent * kOptions.reach * side;
    const double hole = kPi * diameter * diameter / 4.0;
    EXPECT_NEAR(strips, hole, 0.05 * hole) << diameter;
  }
}

TEST(VoidExtents, OnlyPatchesThatFaceEachOtherBoundASlit) {
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, -1), patchAt(2, 1)}, kOptions),
            (std::vector{1.0, 1.0}));  // back to back
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, 1), patchAt(2, 1)}, kOptions),
            (std::vector{1.0, 1.0}));  // one behind the other
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, 1), patchAt(1, -1, 5.0)}, kOptions), (std::vector{1.0, 1.0}));  // beside
}

TEST(VoidExtents, FindsTheOtherSideAcrossCellBorders) {
  for (const double x : {-10.01, -9.99, -0.01, 0.01, 9.99}) {
    const auto extents = voidExtents(std::vector{patchAt(x, 1), patchAt(x + 9.0, -1)}, kOptions);
    EXPECT_NEAR(extents[0], 0.9, 1e-12) << x;
  }
}

TEST(VoidExtents, NeedAReach) {
  EXPECT_THROW(static_cast<void>(voidExtents({}, {0.0, 10.0})), InvalidInput);
  EXPECT_THROW(static_cast<void>(voidExtents({}, {5.0, 0.0})), InvalidInput);
}

}  // namespace
}  // namespace vantage
