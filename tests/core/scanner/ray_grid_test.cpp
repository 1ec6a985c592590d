#include "scanner/ray_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/random.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

// A camera whose rays are off by a share of a pixel each, and whose heads are off by some hundredths of a millimetre.
RayGrid unevenTable(double share) {
  const RayGrid even = makeRays(Pinhole{Vec3(300, 0, 150), Vec3(0, 0, 100), 60, 60, radians(50), radians(50)}, {});
  Random random(9);
  auto off = [&] { return share * (2.0 * random.uniform() - 1.0); };
  std::vector<RangingRay> rays;
  for (int r = 0; r < even.rows(); ++r) {
    for (int c = 0; c < even.columns(); ++c) {
      RangingRay ray = even.rayAt({r + off(), c + off()});
      ray.origin += 0.02 * Vec3(random.normal(), random.normal(), random.normal());
      rays.push_back(ray);
    }
  }
  return {even.rows(), even.columns(), std::move(rays), {}, 0};
}

// Rows shifted by half a column in turn, as some range cameras have them.
RayGrid interlacedTable() {
  const RayGrid even = makeRays(LinearStripe{Vec3(300, 0, 150), 200, 80, 100, 200}, {});
  std::vector<RangingRay> rays;
  for (int r = 0; r < even.rows(); ++r)
    for (int c = 0; c < even.columns(); ++c) rays.push_back(even.rayAt({1.0 * r, c + 0.5 * (r % 2)}));
  return {even.rows(), even.columns(), std::move(rays), {}, 0};
}

std::vector<std::pair<std::string, RayGrid>> allGrids() {
  return {
      {"rotating stripe", makeRays(RotatingStripe{Vec3(300, 0, 150), 300, 250, 240, radians(60)}, {})},
      {"wide rotating stripe", makeRays(RotatingStripe{Vec3(300, 0, 150), 300, 50, 300, radians(165)}, {})},
      {"linear stripe", makeRays(LinearStripe{Vec3(300, 0, 150), 300, 200, 150, 200}, {})},
      {"pinhole", makeRays(Pinhole{Vec3(300, 50, 250), Vec3(0, 0, 100), 120, 160, radians(60), radians(45)}, {})},
      {"wide pinhole", makeRays(Pinhole{Vec3(300, 0, 150), Vec3(0, 0, 100), 150, 150, radians(150), radians(140)}, {})},
      {"smallest", makeRays(Pinhole{Vec3(300, 0, 150), Vec3(0, 0, 100), 2, 2, radians(40), radians(40)}, {})},
      {"uneven table", unevenTable(0.3)},
      {"interlaced table", interlacedTable()}};
}

GridPosition randomPosition(const RayGrid& rays, Random& random) {
  return {random.uniform() * (rays.rows() - 1), random.uniform() * (rays.columns() - 1)};
}

Vec3 pointOn(const RangingRay& ray, double depth) {
  return ray.origin + depth * ray.direction;
}

// How far the ray at a position passes p by, in rays' distances: what a position is good for.
double missInCells(const RayGrid& rays, const GridPosition& position, const Vec3& p) {
  const RangingRay ray = rays.rayAt(position);
  return (p - ray.origin).cross(ray.direction).norm() / rays.spacingAt(p, position);
}

TEST(RayGrid, LocateFindsTheRayThroughAPointBetweenRays) {
  for (const auto& [name, rays] : allGrids()) {
    Random random(1);
    for (int i = 0; i < 3000; ++i) {
      const GridPosition position = randomPosition(rays, random);
      const Vec3 p = pointOn(rays.rayAt(position), 50.0 + 500.0 * random.uniform());
      const auto found = rays.locate(p);
      ASSERT_TRUE(found) << name << " at " << position.row << ", " << position.column;
      ASSERT_LT(missInCells(rays, *found, p), 1e-4) << name;
    }
  }
}

TEST(RayGrid, LocateGivesTheRaysOwnPlace) {
  for (const auto& [name, rays] : allGrids()) {
    for (int r = 0; r < rays.rows(); r += 7) {
      for (int c = 0; c < rays.columns(); c += 11) {
        const auto found = rays.locate(pointOn(rays.ray(rays.index(r, c)), 300.0));
        ASSERT_TRUE(found) << name << " at " << r << ", " << c;
        EXPECT_NEAR(found->row, r, 1e-3) << name;
        EXPECT_NEAR(found->column, c, 1e-3) << name;
      }
    }
  }
}

TEST(RayGrid, AHintChangesNothingButTheTime) {
  for (const auto& [name, rays] : allGrids()) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = pointOn(rays.rayAt(randomPosition(rays, random)), 50.0 + 500.0 * random.uniform());
      const auto found = rays.locate(p);
      const auto hinted = rays.locate(p, randomPosition(rays, random));
      ASSERT_TRUE(found && hinted) << name;
      EXPECT_LT(missInCells(rays, *hinted, p), 1e-4) << name;
      if (name == "uneven table") continue;  // its rays cross in places: either answer is right
      EXPECT_NEAR(found->row, hinted->row, 1e-3) << name;
      EXPECT_NEAR(found->column, hinted->column, 1e-3) << name;
    }
  }
}

TEST(RayGrid, LocateReachesHalfACellBeyondTheRim) {
  for (const auto& [name, rays] : allGrids()) {
    if (name == "uneven table" || name == "interlaced table") continue;  // a jagged rim has no half cell
    const double lastRow = rays.rows() - 1;
    const double lastColumn = rays.columns() - 1;
    for (const double share : {0.1, 0.5, 0.9}) {
      const std::vector<GridPosition> inside{{-0.45, share * lastColumn},
                                             {lastRow + 0.45, share * lastColumn},
                                             {share * lastRow, -0.45},
                                             {share * lastRow, lastColumn + 0.45}};
      for (const GridPosition& position : inside)
        EXPECT_TRUE(rays.locate(pointOn(rays.rayAt(position), 300.0)))
            << name << " at " << position.row << ", " << position.column;
      const std::vector<GridPosition> outside{{-0.6, share * lastColumn},
                                              {lastRow + 0.6, share * lastColumn},
                                              {share * lastRow, -0.6},
                                              {share * lastRow, lastColumn + 0.6}};
      for (const GridPosition& position : outside)
        EXPECT_FALSE(rays.locate(pointOn(rays.rayAt(position), 300.0)))
            << name << " at " << position.row << ", " << position.column;
    }
  }
}

TEST(RayGrid, LocateFindsNothingBehindTheScannerOrFarOutside) {
  for (const auto& [name, rays] : allGrids()) {
    const GridPosition middle{0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)};
    EXPECT_FALSE(rays.locate(pointOn(rays.rayAt(middle), -100.0))) << name;
    EXPECT_FALSE(rays.locate(Vec3(0, 0, 1e6))) << name;
    EXPECT_FALSE(rays.locate(Vec3(1e9, 1e9, -1e9))) << name;
    EXPECT_FALSE(rays.locate(Vec3(300, 1e4, 150), {0, 0})) << name;
  }
}

TEST(RayGrid, LocateSurvivesPointsThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto& [name, rays] : allGrids()) {
    EXPECT_FALSE(rays.locate(Vec3(nan, 0, 0))) << name;
    EXPECT_FALSE(rays.locate(Vec3(0, inf, 0))) << name;
    EXPECT_FALSE(rays.locate(Vec3(-inf, inf, nan))) << name;
    EXPECT_FALSE(rays.locate(Vec3(1e300, -1e300, 1e300))) << name;
  }
}

TEST(RayGrid, WhatLocateRefusesLiesOutside) {
  // The brute force answer: no ray passes within half a cell.
  const RayGrid rays = makeRays(RotatingStripe{Vec3(300, 0, 150), 300, 30, 40, radians(60)}, {});
  Random random(5);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p =
        Vec3(300, 0, 150) + 400.0 * Vec3(random.uniform() - 1.0, 2 * random.uniform() - 1, random.uniform() - 0.5);
    double nearest = std::numeric_limits<double>::infinity();
    GridPosition place;
    for (int r = 0; r < rays.rows(); ++r) {
      for (int c = 0; c < rays.columns(); ++c) {
        const RangingRay& ray = rays.ray(rays.index(r, c));
        const double miss = (p - ray.origin).cross(ray.direction).norm();
        if ((p - ray.origin).dot(ray.direction) <= 0.0 || miss >= nearest) continue;
        nearest = miss;
        place = {static_cast<double>(r), static_cast<double>(c)};
      }
    }
    const auto found = rays.locate(p);
    if (found) {
      ++inside;
      EXPECT_NEAR(found->row, place.row, 0.51);
      EXPECT_NEAR(found->column, place.column, 0.51);
    } else {
      const bool rim = place.row == 0 || place.row == rays.rows() - 1 || place.column == 0 ||
                       place.column == rays.columns() - 1 || std::isinf(nearest);
      EXPECT_TRUE(rim) << "a point next to ray " << place.row << ", " << place.column << " was not found";
    }
  }
  EXPECT_GT(inside, 300);
}

TEST(RayGrid, SpacingIsTheDistanceToTheFarthestNeighbourAtThePoint) {
  const RayGrid stripe = makeRays(LinearStripe{Vec3(300, 0, 150), 100, 101, 51, 100}, {});
  EXPECT_NEAR(stripe.spacingAt(Vec3(0, 0, 150), {50, 25}), 2.0, 1e-9);  // 1 mm along the stripe, 2 mm across
  const RayGrid sweep = makeRays(RotatingStripe{Vec3(300, 0, 150), 100, 101, 61, radians(60)}, {});
  EXPECT_NEAR(sweep.spacingAt(Vec3(0, 0, 150), {50, 30}), 300.0 * std::sin(radians(1.0)), 1e-9);
  EXPECT_NEAR(sweep.spacingAt(Vec3(150, 0, 150), {50, 30}), 150.0 * std::sin(radians(1.0)), 1e-9);
  EXPECT_NEAR(sweep.spacingAt(Vec3(280, 0, 150), {50, 30}), 1.0, 1e-9);  // now the rows are farther apart
}

TEST(RayGrid, RayAtInterpolatesBetweenNeighbours) {
  const RayGrid rays = makeRays(LinearStripe{Vec3(300, 0, 150), 100, 101, 101, 100}, {});
  const RangingRay ray = rays.rayAt({10.25, 20.5});
  EXPECT_TRUE(ray.origin.isApprox(Vec3(300, -29.5, 110.25)));
  EXPECT_TRUE(ray.direction.isApprox(Vec3(-1, 0, 0)));
  EXPECT_TRUE(rays.rayAt({-0.5, 100.5}).origin.isApprox(Vec3(300, 50.5, 99.5)));
}

TEST(RayGrid, NearestIsClampedToTheGrid) {
  const RayGrid rays = makeRays(LinearStripe{Vec3(300, 0, 150), 100, 11, 21, 100}, {});
  EXPECT_EQ(rays.nearest({3.4, 7.6}), rays.index(3, 8));
  EXPECT_EQ(rays.nearest({-0.5, 20.5}), rays.index(0, 20));
  EXPECT_EQ(rays.nearest({99, -99}), rays.index(10, 0));
}

TEST(RayGrid, RefusesWhatIsNoGrid) {
  const RangingRay ray{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  const std::vector<RangingRay> four(4, ray);
  EXPECT_NO_THROW(RayGrid(2, 2, four, {}, 0));
  EXPECT_THROW(RayGrid(1, 4, four, {}, 0), InvalidInput);
  EXPECT_THROW(RayGrid(-2, -2, four, {}, 0), InvalidInput);
  EXPECT_THROW(RayGrid(2, 3, four, {}, 0), InvalidInput);
  EXPECT_THROW(RayGrid(2, 2, four, {}, 1), InvalidInput);
  EXPECT_THROW(RayGrid(2, 2, four, {}, -1), InvalidInput);
  EXPECT_THROW(RayGrid(2, 2, four, std::vector<Vec3>(3, Vec3(0, 0, 0)), 1), InvalidInput);
  std::vector<RangingRay> broken = four;
  broken[2].direction = Vec3(2, 0, 0);
  EXPECT_THROW(RayGrid(2, 2, broken, {}, 0), InvalidInput);
  broken[2] = {Vec3(0, std::numeric_limits<double>::infinity(), 0), Vec3(1, 0, 0)};
  EXPECT_THROW(RayGrid(2, 2, broken, {}, 0), InvalidInput);
}

TEST(RayGrid, RaysThatAreAllTheSameAreNeverLocated) {
  const RayGrid rays(2, 2, std::vector<RangingRay>(4, {Vec3(0, 0, 0), Vec3(1, 0, 0)}), {}, 0);
  EXPECT_FALSE(rays.locate(Vec3(5, 0, 0)));
  EXPECT_FALSE(rays.locate(Vec3(5, 1, 0)));
}

}  // namespace
}  // namespace vantage
