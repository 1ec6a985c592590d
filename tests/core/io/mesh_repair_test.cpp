#include "io/mesh_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/errors.h"
#include "geometry/measures.h"
#include "geometry/mesh_orientation.h"
#include "support/meshes.h"

namespace vantage {
namespace {

PolygonSoup soupOf(const Mesh& mesh) {
  PolygonSoup soup;
  soup.points = mesh.vertices;
  for (const Triangle& t : mesh.triangles) {
    soup.corners.insert(soup.corners.end(), t.begin(), t.end());
    soup.endPolygon();
  }
  return soup;
}

void addPolygon(PolygonSoup& soup, std::initializer_list<std::uint32_t> corners) {
  soup.corners.insert(soup.corners.end(), corners);
  soup.endPolygon();
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  return sum;
}

void turnRound(Mesh& mesh, std::size_t every) {
  for (std::size_t t = 0; t < mesh.triangles.size(); t += every) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
}

TEST(MeshRepair, LeavesAGoodMeshAsItIs) {
  const Mesh sphere = testing::makeSphere(10.0, 8);
  MeshRepair repair;
  const Mesh mesh = repairedMesh(soupOf(sphere), repair);
  EXPECT_TRUE(repair.nothing()) << describe(repair);
  EXPECT_EQ(mesh.vertices, sphere.vertices);
  EXPECT_EQ(mesh.triangles, sphere.triangles);
  EXPECT_EQ(describe(repair), "");
}

TEST(MeshRepair, CountsEverythingItDrops) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {nan, 0, 0}, {1e30, 0, 0}, {-0.0, 0, 0}, {7, 7, 7}};
  addPolygon(soup, {0, 1, 2});
  addPolygon(soup, {1, 2, 0});         // the same again
  addPolygon(soup, {6, 1, 2});         // the same once its corner is merged
  addPolygon(soup, {0, 1, 1});         // repeats a corner
  addPolygon(soup, {0, 1, 3});         // in one line
  addPolygon(soup, {0, 1});            // two corners
  addPolygon(soup, {0, 1, kNoIndex});  // missing
  addPolygon(soup, {0, 1, 8});         // missing
  addPolygon(soup, {0, 1, 4});         // not a number
  addPolygon(soup, {0, 1, 5});         // too far
  MeshRepair repair;
  const Mesh mesh = repairedMesh(soup, repair);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(repair.droppedDuplicate, 2U);
  EXPECT_EQ(repair.droppedDegenerate, 3U);
  EXPECT_EQ(repair.droppedMissingVertex, 2U);
  EXPECT_EQ(repair.droppedNotFinite, 2U);
  EXPECT_EQ(repair.mergedVertices, 1U);
  EXPECT_EQ(repair.unusedVertices, 4U);
  EXPECT_EQ(repair.dropped(), 9U);
}

TEST(MeshRepair, MergesASoupOfLooseTrianglesIntoAClosedMesh) {
  const Mesh box = testing::makeBox({0, 0, 0}, {1, 2, 3}, 3);
  PolygonSoup soup;
  for (const Triangle& t : box.triangles) {
    for (const std::uint32_t v : t) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(box.vertices[v]);
    }
    soup.endPolygon();
  }
  MeshRepair repair;
  const MeshMeasures measures = measure(repairedMesh(soup, repair));
  EXPECT_EQ(measures.vertices, box.vertices.size());
  EXPECT_EQ(measures.boundaryEdges, 0U);
  EXPECT_EQ(repair.mergedVertices, 3 * box.triangles.size() - box.vertices.size());
}

TEST(MeshRepair, CutsPolygonsWithoutChangingTheirArea) {
  // An L of area 3, a square of area 1 and a polygon of 100 corners.
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  addPolygon(soup, {2, 3, 4, 5, 0, 1});
  MeshRepair repair;
  const Mesh corner = repairedMesh(soup, repair);
  EXPECT_EQ(corner.triangles.size(), 4U);
  EXPECT_NEAR(area(corner), 3.0, 1e-12);
  for (const Triangle& t : corner.triangles) EXPECT_GT(areaVector(corner, t).z(), 0.0);
  EXPECT_EQ(repair.polygonsCut, 1U);

  PolygonSoup disc;
  for (int i = 0; i < 100; ++i) {
    disc.points.emplace_back(std::cos(2.0 * kPi * i / 100.0), std::sin(2.0 * kPi * i / 100.0), 0.0);
    disc.corners.push_back(static_cast<std::uint32_t>(i));
  }
  disc.endPolygon();
  EXPECT_NEAR(area(repairedMesh(disc, repair)), 50.0 * std::sin(2.0 * kPi / 100.0), 1e-12);
}

TEST(MeshRepair, SurvivesAPolygonThatCrossesItself) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}};
  addPolygon(soup, {0, 1, 2, 3});
  addPolygon(soup, {4, 4, 4, 4, 4});
  MeshRepair repair;
  EXPECT_LE(repairedMesh(soup, repair).triangles.size(), 2U);
}

TEST(MeshRepair, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  MeshRepair repair;
  EXPECT_THROW(
      static_cast<void>(repairedMesh(soupOf(testing::makeSphere(1.0, 4)), repair, Progress({}, stop.get_token(), 1))),
      Cancelled);
}

TEST(OrientOutward, TurnsEveryClosedPieceOutward) {
  Mesh mesh = testing::joined(testing::makeSphere(10.0, 8, {1000, 0, 0}), testing::makeBox({0, 0, 0}, {1, 1, 1}));
  const double before = volume(mesh);
  turnRound(mesh, 3);
  turnRound(mesh, 1);
  const OrientationResult result = orientOutward(mesh);
  EXPECT_GT(result.flippedTriangles, 0U);
  EXPECT_EQ(result.openSeams, 0U);
  EXPECT_NEAR(volume(mesh), before, 1e-9 * before);
  EXPECT_EQ(measure(mesh).nonManifoldEdges, 0U);
}

TEST(OrientOutward, TurnsAPieceWithASmallHoleOutward) {
  Mesh mesh = testing::makeSphere(10.0, 12);
  mesh.triangles.pop_back();
  turnRound(mesh, 1);
  EXPECT_EQ(orientOutward(mesh).flippedTriangles, mesh.triangles.size());
  EXPECT_GT(volume(mesh), 0.0);
}

TEST(OrientOutward, KeepsTheLargerPartOfAnOpenSheet) {
  Mesh sheet = testing::makeGrid(10, 10, 1.0);
  turnRound(sheet, 5);
  EXPECT_EQ(orientOutward(sheet).flippedTriangles, 40U);
  for (const Triangle& t : sheet.triangles) EXPECT_GT(areaVector(sheet, t).z(), 0.0);
}

TEST(OrientOutward, ReportsASurfaceWithOneSide) {
  // A Moebius strip of ten squares.
  Mesh strip;
  constexpr std::uint32_t kSquares = 10;
  for (std::uint32_t i = 0; i < kSquares; ++i) {
    const double turn = 2.0 * kPi * i / kSquares;
    const Vec3 out(std::cos(turn), std::sin(turn), 0.0);
    const Vec3 across = std::cos(0.5 * turn) * out + std::sin(0.5 * turn) * Vec3::UnitZ();
    strip.vertices.push_back(10.0 * out - across);
    strip.vertices.push_back(10.0 * out + across);
  }
  for (std::uint32_t i = 0; i < kSquares; ++i) {
    const bool last = i + 1 == kSquares;
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * i + 1;
    const std::uint32_t c = last ? 1 : a + 2;
    const std::uint32_t d = last ? 0 : b + 2;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  EXPECT_EQ(orientOutward(strip).openSeams, 1U);
}

}  // namespace
}  // namespace vantage
