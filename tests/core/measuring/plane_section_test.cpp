#include "measuring/plane_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeGrid;
using testing::makeSphere;

TEST(PlaneSection, OfABoxIsARectangle) {
  for (const double height : {0.7, 1.0}) {  // 1.0 passes through vertices
    const PlaneSection section = sectionOf(makeBox(Vec3(0, 0, 0), Vec3(3, 4, 2), 4), {Vec3::UnitZ(), height});
    ASSERT_EQ(section.lines.size(), 1U);
    EXPECT_TRUE(section.lines[0].closed);
    EXPECT_NEAR(section.length, 14.0, 1e-9);
    ASSERT_TRUE(section.area.has_value());
    EXPECT_NEAR(*section.area, 12.0, 1e-9);
    for (const Vec3& p : section.lines[0].points) EXPECT_NEAR(p.z(), height, 1e-12);
  }
}

TEST(PlaneSection, SeenFromBehindItIsTheSame) {
  const Mesh box = makeBox(Vec3(0, 0, 0), Vec3(3, 4, 2), 3);
  EXPECT_NEAR(*sectionOf(box, {-Vec3::UnitZ(), -0.7}).area, 12.0, 1e-9);
}

TEST(PlaneSection, OfASphereOffItsMiddleIsASmallerCircle) {
  const PlaneSection section = sectionOf(makeSphere(10.0, 100), {Vec3(1, 2, 2) / 3.0, 6.0});
  ASSERT_TRUE(section.area.has_value());
  EXPECT_NEAR(section.length, 2.0 * kPi * 8.0, 0.02);
  EXPECT_NEAR(*section.area, kPi * 64.0, 0.15);
}

TEST(PlaneSection, AHollowIsTakenOff) {
  Mesh hollow = makeBox(Vec3(1, 1, 1), Vec3(2, 2, 2), 2);
  for (Triangle& t : hollow.triangles) std::swap(t[0], t[1]);
  const PlaneSection section =
      sectionOf(joined(makeBox(Vec3(0, 0, 0), Vec3(4, 4, 4), 2), hollow), {Vec3::UnitX(), 1.3});
  EXPECT_EQ(section.lines.size(), 2U);
  EXPECT_NEAR(*section.area, 15.0, 1e-9);
  EXPECT_NEAR(section.length, 20.0, 1e-9);
}

TEST(PlaneSection, OfASheetHasNoArea) {
  const PlaneSection section = sectionOf(makeGrid(10, 5, 1.0), {Vec3::UnitX(), 3.5});
  ASSERT_EQ(section.lines.size(), 1U);
  EXPECT_FALSE(section.lines[0].closed);
  EXPECT_NEAR(section.length, 5.0, 1e-9);
  EXPECT_FALSE(section.area.has_value());
}

TEST(PlaneSection, BesideTheSurfaceIsNothing) {
  const PlaneSection section = sectionOf(makeSphere(10.0, 10), {Vec3::UnitZ(), 11.0});
  EXPECT_TRUE(section.lines.empty());
  EXPECT_FALSE(section.area.has_value());
  EXPECT_EQ(section.length, 0.0);
}

}  // namespace
}  // namespace vantage
