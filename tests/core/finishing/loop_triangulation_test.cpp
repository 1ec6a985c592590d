#include "finishing/loop_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/measures.h"

namespace vantage {
namespace {

std::vector<Vec3> circle(std::size_t count, double radius) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return points;
}

double areaOf(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  return area({points, triangles});
}

// Every edge of the polygon once, in its direction, and all others in both.
void expectDisc(const std::vector<Triangle>& triangles, std::size_t count) {
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  for (const auto& [a, b] : edges) {
    EXPECT_EQ(edges.count({a, b}), 1U);
    const std::size_t other = (a + 1) % count == b ? 0U : 1U;
    EXPECT_EQ(edges.count({b, a}), other) << a << " " << b;
  }
  for (std::uint32_t i = 0; i < count; ++i)
    EXPECT_EQ(edges.count({i, static_cast<std::uint32_t>((i + 1) % count)}), 1U);
}

TEST(LoopTriangulation, FillsAFlatPolygonExactly) {
  // A fan from the first vertex would leave the L.
  const std::vector<Vec3> l{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const std::vector<Triangle> triangles = triangulateLoop(l, {});
  ASSERT_EQ(triangles.size(), 4U);
  expectDisc(triangles, l.size());
  EXPECT_NEAR(areaOf(l, triangles), 6.0, 1e-12);
  for (const Triangle& t : triangles) EXPECT_GT(areaVector({l, {}}, t).z(), 0.0);
}

TEST(LoopTriangulation, AgreesWithTheSurfaceBesideIt) {
  // A square bent along a diagonal: the surface around says along which.
  const std::vector<Vec3> bent{{0, 0, 0}, {1, 0, 0.4}, {1, 1, 0}, {0, 1, 0.4}};
  const Vec3 low = Vec3(-2, -2, 1).normalized();
  const Vec3 high = Vec3(2, 2, 1).normalized();
  const std::vector<Triangle> one = triangulateLoop(bent, {{low, high, high, low}, {}});
  ASSERT_EQ(one.size(), 2U);
  for (const Triangle& t : one) EXPECT_TRUE(std::set<std::uint32_t>(t.begin(), t.end()).contains(1U));
  const Vec3 left = Vec3(-2, 2, 1).normalized();
  const Vec3 right = Vec3(2, -2, 1).normalized();
  const std::vector<Triangle> other = triangulateLoop(bent, {{left, left, right, right}, {}});
  ASSERT_EQ(other.size(), 2U);
  for (const Triangle& t : other) EXPECT_TRUE(std::set<std::uint32_t>(t.begin(), t.end()).contains(2U));
}

TEST(LoopTriangulation, DoesNotUseAnEdgeThatTheSurfaceHas) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const LoopSurroundings taken{{}, [](std::size_t a, std::size_t b) { return a + b == 2 && a != b; }};
  const std::vector<Triangle> triangles = triangulateLoop(square, taken);
  ASSERT_EQ(triangles.size(), 2U);
  for (const Triangle& t : triangles) EXPECT_TRUE(std::set<std::uint32_t>(t.begin(), t.end()).contains(1U));
  const LoopSurroundings all{{}, [](std::size_t, std::size_t) { return true; }};
  EXPECT_TRUE(triangulateLoop(square, all).empty());
}

TEST(LoopTriangulation, FillsPolygonsOfVeryManyVertices) {
  for (const std::size_t count : {201U, 1000U, 4321U}) {
    const std::vector<Vec3> points = circle(count, 50.0);
    const std::vector<Triangle> triangles = triangulateLoop(points, {});
    ASSERT_EQ(triangles.size(), count - 2) << count;
    expectDisc(triangles, count);
    const double whole = 0.5 * static_cast<double>(count) * 2500.0 * std::sin(2.0 * kPi / static_cast<double>(count));
    EXPECT_NEAR(areaOf(points, triangles), whole, 1e-6) << count;
  }
}

TEST(LoopTriangulation, OfLessThanATriangleThereIsNone) {
  EXPECT_TRUE(triangulateLoop(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, {}).empty());
}

}  // namespace
}  // namespace vantage
