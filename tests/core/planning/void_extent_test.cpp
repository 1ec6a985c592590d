#include "planning/void_extent.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace vantage {
namespace {

// A patch in the plane z = 0 with its edge at x, 1 mm wide along y, pointing along +x or -x.
VoidPatch patchAt(double x, double sense, double y = 0.0) {
  VoidPatch patch;
  patch.corners = {Vec3(x, y + 0.5, 0), Vec3(x, y - 0.5, 0), Vec3(x + sense, y - 0.5, 0), Vec3(x + sense, y + 0.5, 0)};
  return patch;
}

TEST(VoidExtents, AnOpenPatchCountsInFull) {
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, 1)}, 5.0), std::vector{1.0});
}

TEST(VoidExtents, ASlitCountsByItsWidth) {
  const auto extents = voidExtents(std::vector{patchAt(0, 1), patchAt(2, -1)}, 5.0);
  EXPECT_DOUBLE_EQ(extents[0], 0.2);
  EXPECT_DOUBLE_EQ(extents[1], 0.2);
}

TEST(VoidExtents, OnlyPatchesThatFaceEachOtherBoundASlit) {
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, -1), patchAt(2, 1)}, 5.0), (std::vector{1.0, 1.0}));  // back to back
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, 1), patchAt(2, 1)}, 5.0),
            (std::vector{1.0, 1.0}));  // one behind the other
  EXPECT_EQ(voidExtents(std::vector{patchAt(0, 1), patchAt(1, -1, 5.0)}, 5.0), (std::vector{1.0, 1.0}));  // beside
}

TEST(VoidExtents, FindsTheOtherSideAcrossCellBorders) {
  for (const double x : {-10.01, -9.99, -0.01, 0.01, 9.99}) {
    const auto extents = voidExtents(std::vector{patchAt(x, 1), patchAt(x + 9.0, -1)}, 5.0);
    EXPECT_NEAR(extents[0], 0.9, 1e-12) << x;
  }
}

TEST(VoidExtents, NeedAReach) {
  EXPECT_THROW(static_cast<void>(voidExtents({}, 0.0)), InvalidInput);
}

}  // namespace
}  // namespace vantage
