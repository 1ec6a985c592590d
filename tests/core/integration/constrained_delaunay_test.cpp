#include "integration/constrained_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "base/random.h"

namespace vantage {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<PlanePoint> randomPoints(int count, int extent, unsigned seed) {
  Random random(seed);
  std::vector<PlanePoint> points;
  const auto range = static_cast<std::uint64_t>(extent);
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<std::int32_t>(random.below(range));
    points.push_back({x, static_cast<std::int32_t>(random.below(range))});
  }
  return points;
}

// The first of the points at the place of one: it stands for those that coincide with it.
std::uint32_t firstAt(const std::vector<PlanePoint>& points, std::uint64_t point) {
  return static_cast<std::uint32_t>(std::find(points.begin(), points.end(), points[point]) - points.begin());
}

std::int64_t twiceArea(const std::vector<PlanePoint>& points, const std::vector<Triangle>& triangles) {
  std::int64_t sum = 0;
  for (const Triangle& t : triangles) sum += orientation(points[t[0]], points[t[1]], points[t[2]]);
  return sum;
}

// Andrew's monotone chain.
std::int64_t twiceHullArea(std::vector<PlanePoint> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<PlanePoint> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const PlanePoint& p : points) {
      while (hull.size() >= start + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::int64_t sum = 0;
  for (std::size_t i = 2; i < hull.size(); ++i) sum += orientation(hull[0], hull[i - 1], hull[i]);
  return sum;
}

std::set<Edge> edgesOf(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  return edges;
}

// Every directed edge once, every triangle counter-clockwise, the whole hull covered: a triangulation.
void expectTriangulation(const std::vector<PlanePoint>& points, const std::vector<Triangle>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
  for (const Triangle& t : triangles) {
    EXPECT_GT(orientation(points[t[0]], points[t[1]], points[t[2]]), 0);
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(directed.emplace(t[k], t[(k + 1) % 3]).second);
  }
  EXPECT_EQ(twiceArea(points, triangles), twiceHullArea(points));
}

// Across every edge that is no constraint the far corner is not inside the circle.
void expectDelaunay(const std::vector<PlanePoint>& points, const std::vector<Triangle>& triangles,
                    const std::set<Edge>& constraints) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> apex;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) apex[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  for (const auto& [edge, corner] : apex) {
    const auto other = apex.find({edge.second, edge.first});
    if (other == apex.end() || constraints.count(std::minmax(edge.first, edge.second)) > 0) continue;
    EXPECT_FALSE(insideCircle(points[edge.first], points[edge.second], points[corner], points[other->second]));
  }
}

TEST(ConstrainedDelaunay, RandomPointsObeyTheCircleLaw) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto points = randomPoints(200, 1000, seed);
    const auto triangles = ConstrainedDelaunay(points).triangles();
    expectTriangulation(points, triangles);
    expectDelaunay(points, triangles, {});
  }
}

TEST(ConstrainedDelaunay, CrowdedPointsWithDuplicatesAndManyOnOneLineWork) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto points = randomPoints(60, 7, seed);
    const auto triangles = ConstrainedDelaunay(points).triangles();
    expectTriangulation(points, triangles);
    expectDelaunay(points, triangles, {});
    for (const Triangle& t : triangles)
      for (const std::uint32_t corner : t) EXPECT_EQ(firstAt(points, corner), corner);
  }
}

TEST(ConstrainedDelaunay, RegularGridIsCoveredOnce) {
  std::vector<PlanePoint> points;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) points.push_back({1024 * x, 1024 * y});
  const auto triangles = ConstrainedDelaunay(points).triangles();
  EXPECT_EQ(triangles.size(), 2U * 11 * 11);
  expectTriangulation(points, triangles);
}

TEST(ConstrainedDelaunay, PointsOnOneLineGiveNoTriangles) {
  const std::vector<PlanePoint> points{{0, 0}, {3, 3}, {1, 1}, {3, 3}, {9, 9}};
  ConstrainedDelaunay delaunay(points);
  EXPECT_TRUE(delaunay.triangles().empty());
  EXPECT_FALSE(delaunay.constrain(0, 4));
  EXPECT_TRUE(ConstrainedDelaunay(std::vector<PlanePoint>{}).triangles().empty());
  EXPECT_TRUE(ConstrainedDelaunay(std::vector<PlanePoint>{{1, 2}}).triangles().empty());
}

TEST(ConstrainedDelaunay, ConstraintReplacesTheShorterDiagonal) {
  // A flat rhombus: without the constraint the short diagonal 1-3 is the edge.
  const std::vector<PlanePoint> points{{-10, 0}, {0, -3}, {10, 0}, {0, 3}};
  ConstrainedDelaunay delaunay(points);
  EXPECT_EQ(edgesOf(delaunay.triangles()).count({1, 3}), 1U);
  EXPECT_TRUE(delaunay.constrain(0, 2));
  EXPECT_EQ(edgesOf(delaunay.triangles()).count({0, 2}), 1U);
  expectTriangulation(points, delaunay.triangles());
}

TEST(ConstrainedDelaunay, PointOnTheWaySplitsAConstraint) {
  const std::vector<PlanePoint> points{{-10, 0}, {10, 0}, {0, 0}, {1, 5}, {-1, -5}, {4, 9}, {-4, -9}};
  ConstrainedDelaunay delaunay(points);
  EXPECT_TRUE(delaunay.constrain(0, 1));
  const auto edges = edgesOf(delaunay.triangles());
  EXPECT_EQ(edges.count({0, 2}), 1U);
  EXPECT_EQ(edges.count({1, 2}), 1U);
  expectTriangulation(points, delaunay.triangles());
}

TEST(ConstrainedDelaunay, ConstraintThatCrossesAnotherIsRefusedAndChangesNothing) {
  const std::vector<PlanePoint> points{{-10, 0}, {0, -10}, {10, 1}, {0, 10}, {3, 2}};
  ConstrainedDelaunay delaunay(points);
  ASSERT_TRUE(delaunay.constrain(0, 2));
  const auto before = delaunay.triangles();
  EXPECT_FALSE(delaunay.constrain(1, 3));
  EXPECT_EQ(delaunay.triangles(), before);
}

TEST(ConstrainedDelaunay, RandomConstraintsAreKeptAndTheRestIsDelaunay) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    // Few enough places that constraints meet points and each other.
    const auto points = randomPoints(120, seed % 2 == 0 ? 40 : 4000, seed);
    ConstrainedDelaunay delaunay(points);
    Random random(seed, 1);
    std::set<Edge> kept;
    int refused = 0;
    for (int i = 0; i < 60; ++i) {
      const std::uint32_t a = firstAt(points, random.below(points.size()));
      const std::uint32_t b = firstAt(points, random.below(points.size()));
      const bool taken = delaunay.constrain(a, b);
      refused += taken ? 0 : 1;
      if (!taken) continue;
      // Points on the way divide it: collect its pieces.
      std::vector<std::uint32_t> chain;
      for (std::uint32_t p = 0; p < points.size(); ++p)
        if (firstAt(points, p) == p &&
            (p == a || p == b ||
             (orientation(points[a], points[b], points[p]) == 0 && strictlyBetween(points[a], points[b], points[p]))))
          chain.push_back(p);
      std::sort(chain.begin(), chain.end(), [&](std::uint32_t p, std::uint32_t q) {
        return points[p].x != points[q].x ? points[p].x < points[q].x : points[p].y < points[q].y;
      });
      for (std::size_t k = 1; k < chain.size(); ++k) kept.insert(std::minmax(chain[k - 1], chain[k]));
    }
    const auto triangles = delaunay.triangles();
    expectTriangulation(points, triangles);
    expectDelaunay(points, triangles, kept);
    const auto edges = edgesOf(triangles);
    for (const Edge& e : kept) EXPECT_EQ(edges.count(e), 1U);
    EXPECT_GT(refused, 0);
  }
}

TEST(ConstrainedDelaunay, RefusesCoordinatesThatItCannotDecideExactly) {
  EXPECT_THROW(ConstrainedDelaunay(std::vector<PlanePoint>{{kPlaneLimit + 1, 0}}), InvalidInput);
}

}  // namespace
}  // namespace vantage
