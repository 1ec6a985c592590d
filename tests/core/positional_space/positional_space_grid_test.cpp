#include "positional_space/positional_space_grid.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "base/random.h"
#include "support/scenes/small_profiles.h"

namespace vantage {
namespace {

PositionalSpaceShape smallShape(PositionalSpaceSurface surface) {
  PositionalSpaceShape shape;
  shape.surface = surface;
  shape.rows = 6;
  shape.columns = 12;
  shape.radius = 155.0;
  shape.directions = 19;
  return shape;
}

// Whether the line meets the cylinder 150 x 300 mm, by sampling it.
bool meetsVolume(const Vec3& p, const Vec3& d) {
  for (int i = -2000; i <= 2000; ++i) {
    const Vec3 q = p + 0.5 * i * d;
    if (q.head<2>().norm() <= 150.0 && q.z() >= 0.0 && q.z() <= 300.0) return true;
  }
  return false;
}

TEST(PositionalSpaceGrid, ProjectingTheUnprojectedStaysInItsCell) {
  for (const auto surface : {PositionalSpaceSurface::Cylinder, PositionalSpaceSurface::Sphere}) {
    const PositionalSpaceGrid grid(smallShape(surface));
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 12; ++column)
        for (int phi = 0; phi < 19; ++phi)
          for (int psi = 0; psi < 19; ++psi) {
            const PositionalCell cell{row, column, phi, psi};
            const auto back = grid.project(grid.unproject(cell));
            ASSERT_TRUE(back.has_value());
            EXPECT_EQ(*back, cell);
          }
  }
}

TEST(PositionalSpaceGrid, ARayAlongTheAxisOfAColumnFallsWhereTheHandSays) {
  const PositionalSpaceGrid grid(smallShape(PositionalSpaceSurface::Cylinder));
  // Column 3 spans 90..120 degrees, row 1 50..100 mm; the ray leaves at 105 degrees straight, so phi and psi are 0.
  const double angle = radians(105.0);
  const RangingRay inward{Vec3(400.0 * std::cos(angle), 400.0 * std::sin(angle), 60.0),
                          Vec3(-std::cos(angle), -std::sin(angle), 0.0)};
  const auto cell = grid.project(inward);
  ASSERT_TRUE(cell.has_value());
  EXPECT_EQ(*cell, (PositionalCell{1, 3, 9, 9}));
  // Leaving 30 degrees counter-clockwise and 45 degrees upward: 30 / 180 * 19 = 3.2, 45 / 180 * 19 = 4.75 cells on.
  const double leave = radians(135.0);
  const Vec3 p(155.0 * std::cos(angle), 155.0 * std::sin(angle), 60.0);
  const Vec3 d = Vec3(std::cos(leave), std::sin(leave), 1.0).normalized();
  EXPECT_EQ(*grid.project(OutwardRay{p - 20.0 * d, d}), (PositionalCell{1, 3, 12, 14}));
}

TEST(PositionalSpaceGrid, BothEndsOfALineAreDifferentCells) {
  const PositionalSpaceGrid grid(smallShape(PositionalSpaceSurface::Sphere));
  const Vec3 p(10.0, -20.0, 130.0);
  const Vec3 d = Vec3(1.0, 2.0, 0.3).normalized();
  const auto forth = grid.project(OutwardRay{p, d});
  const auto back = grid.project(OutwardRay{p, -d});
  ASSERT_TRUE(forth && back);
  EXPECT_NE(forth->column, back->column);
  // A ranging ray is looked back along, wherever along it the head is.
  EXPECT_EQ(*grid.project(RangingRay{p + 500.0 * d, -d}), *forth);
}

TEST(PositionalSpaceGrid, ALineThatMissesTheSurfaceHasNoCell) {
  const PositionalSpaceGrid grid(smallShape(PositionalSpaceSurface::Cylinder));
  EXPECT_FALSE(grid.project(OutwardRay{Vec3(0, 160, 10), Vec3::UnitX()}));
  EXPECT_FALSE(grid.project(OutwardRay{Vec3(0, 0, 301), Vec3::UnitX()}));
  EXPECT_FALSE(grid.project(OutwardRay{Vec3(0, 0, 10), Vec3::UnitZ()}));
  EXPECT_TRUE(grid.project(OutwardRay{Vec3(0, 0, 300), Vec3::UnitX()}));
}

TEST(PositionalSpaceGrid, EveryRangingRayThatMeetsTheViewingVolumeHasACell) {
  for (const ScannerProfile& profile : testing::everyKind()) {
    const PositionalSpaceGrid grid = makePositionalSpaceGrid(profile);
    std::size_t checked = 0;
    for (std::size_t position = 0; position < profile.workspace.size(); position += 7) {
      const Pose& pose = profile.workspace.poses[position];
      for (std::size_t i = 0; i < profile.rays->size(); i += 37) {
        const RangingRay ray{pose * profile.rays->ray(i).origin, pose.linear() * profile.rays->ray(i).direction};
        if (!meetsVolume(ray.origin, ray.direction)) continue;
        ++checked;
        EXPECT_TRUE(grid.project(ray).has_value()) << "position " << position << " ray " << i;
      }
    }
    EXPECT_GT(checked, 100U);
  }
}

TEST(PositionalSpaceGrid, TheCylinderKeepsTheRowsOfTheProfileForHorizontalRays) {
  const PositionalSpaceShape shape = makePositionalSpaceGrid(testing::rotatingStripe()).shape();
  EXPECT_EQ(shape.surface, PositionalSpaceSurface::Cylinder);
  EXPECT_EQ(shape.rows, 20);
  EXPECT_EQ(shape.columns, 90);
  EXPECT_NEAR(shape.bottom, 0.0, 1.0);
  EXPECT_NEAR(shape.top, 300.0, 1.0);
  EXPECT_GT(shape.radius, 150.0);
  EXPECT_LT(shape.radius, 160.0);
}

TEST(PositionalSpaceGrid, RaysFromAboveMakeTheCylinderTallerAndRaysFromFarAboveASphere) {
  const PositionalSpaceShape raised = makePositionalSpaceGrid(testing::tiltedPinhole("15, 30")).shape();
  EXPECT_EQ(raised.surface, PositionalSpaceSurface::Cylinder);
  EXPECT_GT(raised.top, 300.0);
  EXPECT_NEAR((raised.top - raised.bottom) / raised.rows, 15.0, 0.1);
  EXPECT_EQ(makePositionalSpaceGrid(testing::tiltedPinhole("0, 70")).shape().surface, PositionalSpaceSurface::Sphere);
}

TEST(PositionalSpaceGrid, ManyPositionsShareDirectionCellsThatAreNarrowerThanASurfaceCellLooks) {
  EXPECT_LT(makePositionalSpaceGrid(testing::linearStripe(90)).directionStep(), radians(0.5));
  // Parallel rays differ by nothing; seen from the axis, a surface cell is 4 degrees wide, of which this is a third.
  const PositionalSpaceGrid grid = makePositionalSpaceGrid(testing::linearStripe(900));
  EXPECT_LE(grid.directionStep(), radians(4.0 / 3.0));
  EXPECT_GE(grid.directionStep(), radians(0.8));
  EXPECT_GT(grid.shape().angularError, radians(2.0));
  EXPECT_LT(grid.shape().angularError, radians(5.0));
}

TEST(PositionalSpaceGrid, RefusesAShapeWithoutCells) {
  PositionalSpaceShape shape = smallShape(PositionalSpaceSurface::Cylinder);
  shape.columns = 2;
  EXPECT_THROW(PositionalSpaceGrid{shape}, InvalidInput);
  shape = smallShape(PositionalSpaceSurface::Cylinder);
  shape.top = shape.bottom;
  EXPECT_THROW(PositionalSpaceGrid{shape}, InvalidInput);
}

}  // namespace
}  // namespace vantage
