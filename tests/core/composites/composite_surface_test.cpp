#include "composites/composite_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/errors.h"
#include "base/random.h"
#include "support/meshes.h"

namespace vantage {
namespace {

TEST(CompositeSurface, WalksToTheNearestPointOfABall) {
  const CompositeSurface ball(testing::makeSphere(30.0, 40));
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = 33.0 * Vec3(random.normal(), random.normal(), random.normal()).normalized();
    double least = 1e9;
    for (const Vec3& q : ball.points()) least = std::min(least, (p - q).norm());
    const std::uint32_t found = ball.walkTo(p, static_cast<std::uint32_t>(random.below(ball.size())));
    EXPECT_NEAR((p - ball.point(found)).norm(), least, 1e-9);
  }
}

TEST(CompositeSurface, SpreadsItsPointsByAreaNotByVertices) {
  // The same square twice, one with 16 times the vertices.
  Mesh fine = testing::makeGrid(40, 40, 1.0);
  Mesh coarse = testing::makeGrid(10, 10, 4.0);
  for (Vec3& v : coarse.vertices) v.x() += 60.0;
  const CompositeSurface both(testing::joined(fine, coarse));
  const auto some = both.spread(100);
  const auto onFine =
      std::count_if(some.begin(), some.end(), [&](std::uint32_t i) { return both.point(i).x() < 50.0; });
  EXPECT_GT(some.size(), 75U);
  EXPECT_NEAR(static_cast<double>(onFine) / static_cast<double>(some.size()), 0.5, 0.12);
  for (const std::uint32_t i : some) EXPECT_TRUE(both.isInside(i));
}

TEST(CompositeSurface, LeavesTheBorderOut) {
  const CompositeSurface square(testing::makeGrid(4, 4, 1.0));
  for (std::uint32_t i = 0; i < square.size(); ++i) {
    const Vec3& p = square.point(i);
    EXPECT_EQ(square.isInside(i), p.x() > 0.5 && p.x() < 3.5 && p.y() > 0.5 && p.y() < 3.5) << i;
  }
  EXPECT_EQ(square.spread(1000).size(), 9U);
}

TEST(CompositeSurface, MovesEveryPointByItsMotion) {
  const CompositeSurface square(testing::makeGrid(2, 1, 1.0));
  std::vector<Pose> motions(2, Pose::Identity());
  motions[1] = Pose(Eigen::AngleAxisd(kPi / 2.0, Vec3::UnitX()));
  std::vector<std::uint32_t> which(square.size(), 0);
  which.back() = 1;
  const CompositeSurface moved = square.moved(motions, which);
  const auto last = static_cast<std::uint32_t>(square.size() - 1);
  EXPECT_EQ(moved.point(0), square.point(0));
  EXPECT_LT((moved.point(last) - motions[1] * square.point(last)).norm(), 1e-12);
  EXPECT_LT((moved.normal(last) - motions[1].linear() * square.normal(last)).norm(), 1e-12);
}

TEST(CompositeSurface, RefusesTrianglesOfNoVertices) {
  Mesh mesh = testing::makeGrid(1, 1, 1.0);
  mesh.triangles[0][1] = 99;
  EXPECT_THROW(CompositeSurface{mesh}, InvalidInput);
}

}  // namespace
}  // namespace vantage
