#include "geometry/ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>
#include <string_view>
#include <vector>

#include "base/errors.h"
#include "base/random.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::makeGrid;
using testing::makeSphere;

Vec3 randomDirection(Random& random) {
  return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

Vec3 randomPoint(Random& random, double extent) {
  return extent * Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
}

// Nearest crossing of a ray with any triangle, in double precision; infinity for none. `clearance` gets the least
// barycentric weight of the crossing: how clear of the triangle's edges it is.
double bruteForceHit(const Mesh& mesh, const Vec3& origin, const Vec3& direction, double& clearance) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    Eigen::Matrix3d system;
    system << mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]], -direction;
    const Vec3 solution = system.inverse() * (origin - mesh.vertices[t[0]]);
    const double least = std::min({solution[0], solution[1], 1.0 - solution[0] - solution[1]});
    if (!solution.allFinite() || least < 0.0 || solution[2] <= 0.0 || solution[2] >= nearest) continue;
    nearest = solution[2];
    clearance = least;
  }
  return nearest;
}

TEST(RayCaster, HitsAPlaneWhereItShould) {
  const RayCaster caster(makeGrid(10, 10, 1.0));
  const auto hit = caster.intersect(Vec3(3.3, 4.1, 7.0), Vec3(0, 0, -1));
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance, 7.0);
  EXPECT_EQ(hit->normal, Vec3(0, 0, 1));
  EXPECT_FALSE(caster.intersect(Vec3(3.3, 4.1, 7.0), Vec3(0, 0, 1)));
  EXPECT_FALSE(caster.intersect(Vec3(11, 4, 7), Vec3(0, 0, -1)));
}

TEST(RayCaster, NearAndFarBoundTheHit) {
  const RayCaster caster(makeGrid(10, 10, 1.0));
  const Vec3 origin(3.3, 4.1, 7.0);
  EXPECT_FALSE(caster.intersect(origin, -Vec3::UnitZ(), 0.0, 6.9));
  EXPECT_FALSE(caster.intersect(origin, -Vec3::UnitZ(), 7.1));
  EXPECT_TRUE(caster.intersect(origin, -Vec3::UnitZ(), 6.9, 7.1));
}

TEST(RayCaster, AgreesWithBruteForceOnRandomRays) {
  const Mesh mesh = joined(makeSphere(5.0, 10), makeBox(Vec3(4, -6, -2), Vec3(9, 3, 4), 2));
  const RayCaster caster(mesh, RayCaster::Precision::Robust);
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 origin = randomPoint(random, 40.0);
    const Vec3 direction = (randomPoint(random, 14.0) - origin).normalized();
    double clearance = 1.0;
    const double expected = bruteForceHit(mesh, origin, direction, clearance);
    const auto hit = caster.intersect(origin, direction);
    if (clearance < 1e-4) continue;  // single precision may decide for either side of an edge
    ASSERT_EQ(hit.has_value(), std::isfinite(expected)) << "ray " << i;
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->distance, expected, 1e-4) << "ray " << i;
  }
  EXPECT_GT(hits, 500);
}

TEST(RayCaster, ARobustSphereHasNoCracks) {
  const RayCaster caster(makeSphere(50.0, 40), RayCaster::Precision::Robust);
  Random random(2);
  for (int i = 0; i < 20000; ++i) EXPECT_TRUE(caster.intersect(Vec3(0, 0, 0), randomDirection(random)));
}

TEST(RayCaster, OccludedLeavesTheMarginOutAtBothEnds) {
  const RayCaster caster(makeGrid(10, 10, 1.0));
  const Vec3 above(3.3, 4.1, 1.0);
  const Vec3 below(3.3, 4.1, -1.0);
  EXPECT_TRUE(caster.occluded(above, below));
  EXPECT_TRUE(caster.occluded(above, below, 0.9));
  EXPECT_FALSE(caster.occluded(above, Vec3(3.3, 4.1, 0.001)));
  EXPECT_FALSE(caster.occluded(above, Vec3(3.3, 4.1, 0.0), 0.01));
  EXPECT_FALSE(caster.occluded(Vec3(3.3, 4.1, 0.0), below, 0.01));
  EXPECT_FALSE(caster.occluded(above, below, 1.0));
}

TEST(RayCaster, AStreamAnswersAsSingleQueriesDo) {
  const RayCaster caster(makeSphere(5.0, 12));
  Random random(3);
  std::vector<OcclusionRay> rays;
  std::vector<bool> expected;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 from = 12.0 * randomDirection(random);
    const Vec3 to = 12.0 * randomDirection(random);
    const Vec3 d = (to - from).normalized();
    rays.push_back({static_cast<float>(from.x()), static_cast<float>(from.y()), static_cast<float>(from.z()), 0.0F,
                    static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z()), 0.0F,
                    static_cast<float>((to - from).norm())});
    expected.push_back(caster.occluded(from, to));
  }
  caster.occluded(rays);
  int blocked = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(rays[i].blocked(), expected[i]) << "ray " << i;
    blocked += rays[i].blocked() ? 1 : 0;
  }
  EXPECT_GT(blocked, 100);
  EXPECT_LT(blocked, 900);
}

// A triangle is the union of many points: the nearest of a fine lattice on it bounds the distance from above.
double sampledDistance(const Mesh& mesh, const Triangle& t, const Vec3& p) {
  constexpr int kSteps = 60;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps;
      const double v = static_cast<double>(j) / kSteps;
      const Vec3 q = (1 - u - v) * mesh.vertices[t[0]] + u * mesh.vertices[t[1]] + v * mesh.vertices[t[2]];
      least = std::min(least, (q - p).norm());
    }
  }
  return least;
}

TEST(RayCaster, ClosestPointAgreesWithBruteForce) {
  const Mesh mesh = makeSphere(5.0, 4);
  const RayCaster caster(mesh);
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = randomPoint(random, 20.0);
    double expected = std::numeric_limits<double>::infinity();
    for (const Triangle& t : mesh.triangles) expected = std::min(expected, sampledDistance(mesh, t, p));
    const auto found = caster.closestPoint(p, 100.0);
    ASSERT_TRUE(found);
    EXPECT_LE(found->distance, expected + 1e-9);
    // The lattice is at most 5 * sqrt(2) / 60 mm wide, its nearest point half of that away.
    EXPECT_NEAR(found->distance, expected, 0.06);
    EXPECT_NEAR((found->point - p).norm(), found->distance, 1e-12);
    EXPECT_NEAR(found->barycentric.sum(), 1.0, 1e-12);
    EXPECT_GE(found->barycentric.minCoeff(), -1e-12);
    Vec3 weighted = Vec3::Zero();
    for (int k = 0; k < 3; ++k) weighted += found->barycentric[k] * mesh.vertices[mesh.triangles[found->triangle][k]];
    EXPECT_TRUE(weighted.isApprox(found->point, 1e-12));
  }
}

TEST(RayCaster, ClosestPointOfFaceEdgeAndCornerByHand) {
  const RayCaster caster(Mesh{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}, {{0, 1, 2}}});
  EXPECT_TRUE(caster.closestPoint(Vec3(1, 1, 3), 10)->point.isApprox(Vec3(1, 1, 0)));
  EXPECT_TRUE(caster.closestPoint(Vec3(2, -3, 0), 10)->point.isApprox(Vec3(2, 0, 0)));
  EXPECT_TRUE(caster.closestPoint(Vec3(-1, 2, 1), 10)->point.isApprox(Vec3(0, 2, 0)));
  EXPECT_TRUE(caster.closestPoint(Vec3(4, 4, 0), 10)->point.isApprox(Vec3(2, 2, 0)));
  EXPECT_TRUE(caster.closestPoint(Vec3(-1, -1, 2), 10)->point.isZero());
  EXPECT_TRUE(caster.closestPoint(Vec3(7, -1, 0), 10)->point.isApprox(Vec3(4, 0, 0)));
  EXPECT_TRUE(caster.closestPoint(Vec3(-1, 9, 0), 10)->point.isApprox(Vec3(0, 4, 0)));
}

TEST(RayCaster, ClosestPointStopsAtTheRadius) {
  const RayCaster caster(makeGrid(10, 10, 1.0));
  EXPECT_FALSE(caster.closestPoint(Vec3(5, 5, 2.0), 1.9));
  EXPECT_TRUE(caster.closestPoint(Vec3(5, 5, 2.0), 2.1));
}

TEST(RayCaster, TheLowestTriangleWinsATie) {
  const Mesh mesh = makeGrid(20, 20, 1.0);
  const RayCaster caster(mesh);
  for (int r = 0; r <= 20; ++r) {
    for (int c = 0; c <= 20; ++c) {
      const auto found = caster.closestPoint(Vec3(c, r, 0.0), 1.0);
      ASSERT_TRUE(found);
      const auto vertex = static_cast<std::uint32_t>(21 * r + c);
      const auto lowest = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        return std::find(t.begin(), t.end(), vertex) != t.end();
      });
      EXPECT_EQ(found->triangle, static_cast<std::uint32_t>(lowest - mesh.triangles.begin()));
    }
  }
}

TEST(RayCaster, AnEmptyMeshIsNeverHit) {
  const RayCaster caster{Mesh{}};
  EXPECT_FALSE(caster.intersect(Vec3(0, 0, 0), Vec3(0, 0, 1)));
  EXPECT_FALSE(caster.occluded(Vec3(0, 0, 0), Vec3(0, 0, 1)));
  EXPECT_FALSE(caster.closestPoint(Vec3(0, 0, 0), 1e6));
}

TEST(RayCaster, DegenerateAndBrokenTrianglesAreNotHit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Mesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(nan, 0, 0), Vec3(0, 1e300, 0)},
                  {{0, 1, 2}, {0, 0, 0}, {0, 1, 3}, {0, 1, 4}}};
  const RayCaster caster(mesh);
  EXPECT_FALSE(caster.intersect(Vec3(0.5, 0.0, 5), Vec3(0, 0, -1)));
  EXPECT_FALSE(caster.occluded(Vec3(0.5, 0.1, 5), Vec3(0.5, 0.1, -5)));
}

TEST(RayCaster, RefusesAnIndexOutOfRange) {
  EXPECT_THROW(RayCaster(Mesh{{Vec3(0, 0, 0)}, {{0, 0, 1}}}), InvalidInput);
  EXPECT_THROW(RayCaster(Mesh{{}, {{0, 1, 2}}}), InvalidInput);
}

TEST(RayCaster, CanBeStoppedWhileItIsMadeReady) {
  const Mesh mesh = makeSphere(300, 300, Vec3::Zero());
  int reports = 0;
  std::stop_source stop;
  const Progress progress(
      [&](double, std::string_view) {
        if (++reports == 2) stop.request_stop();
      },
      stop.get_token(), 1);
  EXPECT_THROW(RayCaster(mesh, RayCaster::Precision::Fast, progress), Cancelled);
  EXPECT_GE(reports, 2);
}

}  // namespace
}  // namespace vantage
