#include "geometry/decimation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/errors.h"
#include "geometry/measures.h"
#include "geometry/mesh_topology.h"
#include "geometry/ray_caster.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeBox;
using testing::makeGrid;
using testing::makeSphere;

// A wavy sheet with a boundary.
Mesh makeWaves() {
  Mesh mesh = makeGrid(60, 60, 1.0);
  for (Vec3& v : mesh.vertices) v.z() = 2.0 * std::sin(0.2 * v.x()) * std::cos(0.15 * v.y());
  return mesh;
}

using Segment = std::pair<std::vector<double>, std::vector<double>>;

std::multiset<Segment> boundarySegments(const Mesh& mesh) {
  auto coordinates = [&](std::uint32_t v) {
    const Vec3& p = mesh.vertices[v];
    return std::vector<double>{p.x(), p.y(), p.z()};
  };
  std::multiset<Segment> segments;
  const MeshTopology topology(mesh);
  for (const BoundaryEdge& e : topology.boundaryEdges()) segments.emplace(coordinates(e.from), coordinates(e.to));
  return segments;
}

TEST(Decimation, ReachesTheTargetAndStaysAClosedManifold) {
  const Mesh coarse = decimate(makeSphere(50.0, 60), {.targetTriangles = 2000});
  const MeshMeasures m = measure(coarse);
  EXPECT_LE(m.triangles, 2000U);
  EXPECT_GE(m.triangles, 1900U);
  EXPECT_EQ(m.boundaryEdges, 0U);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_EQ(m.components, 1U);
}

TEST(Decimation, KeepsTheBoundaryAsItIs) {
  const Mesh fine = makeWaves();
  const Mesh coarse = decimate(fine, {.targetTriangles = 1500});
  EXPECT_LT(coarse.triangles.size(), fine.triangles.size() / 3);
  EXPECT_EQ(boundarySegments(coarse), boundarySegments(fine));
}

TEST(Decimation, KeepsTheOrientation) {
  const Vec3 centre(1, 2, 3);
  const Mesh sphere = decimate(makeSphere(50.0, 60, centre), {.targetTriangles = 1000});
  for (const Triangle& t : sphere.triangles)
    EXPECT_GT(triangleNormal(sphere, t).dot((triangleCentre(sphere, t) - centre).normalized()), 0.8);
  const Mesh waves = decimate(makeWaves(), {.targetTriangles = 1000});
  for (const Triangle& t : waves.triangles) EXPECT_GT(triangleNormal(waves, t).z(), 0.5);
}

// Root mean square over planes bounds no single vertex, but none strays by more than three times it.
TEST(Decimation, StopsShortOfTheTargetAtTheErrorBound) {
  for (const double maxError : {0.02, 0.1, 0.5}) {
    const Mesh fine = makeSphere(50.0, 60);
    const Mesh coarse = decimate(fine, {.targetTriangles = 4, .maxError = maxError});
    EXPECT_GT(coarse.triangles.size(), 4U);
    EXPECT_LT(coarse.triangles.size(), fine.triangles.size());
    const RayCaster surface(coarse);
    for (const Vec3& v : fine.vertices) EXPECT_TRUE(surface.closestPoint(v, 3.0 * maxError));
  }
}

TEST(Decimation, AFlatSheetCostsNothing) {
  const Mesh coarse = decimate(makeGrid(30, 30, 1.0), {.targetTriangles = 200, .maxError = 1e-6});
  EXPECT_LE(coarse.triangles.size(), 200U);
  EXPECT_NEAR(area(coarse), 900.0, 1e-9);
}

TEST(Decimation, CornersOfABoxSurvive) {
  const Vec3 size(30, 40, 50);
  const Mesh coarse = decimate(makeBox(Vec3(0, 0, 0), size, 20), {.targetTriangles = 12, .maxError = 0.01});
  EXPECT_LT(coarse.triangles.size(), 100U);
  const MeshMeasures m = measure(coarse);
  EXPECT_NEAR(m.area, 2.0 * (30 * 40 + 40 * 50 + 30 * 50), 1e-6);
  EXPECT_EQ(m.box.max, size);
}

TEST(Decimation, VerticesAreSomeOfTheInputs) {
  const Mesh fine = makeWaves();
  const Mesh coarse = decimate(fine, {.targetTriangles = 1500});
  for (const Vec3& v : coarse.vertices)
    EXPECT_NE(std::find(fine.vertices.begin(), fine.vertices.end(), v), fine.vertices.end());
}

TEST(Decimation, RepeatsToTheByte) {
  const Mesh first = decimate(makeWaves(), {.targetTriangles = 1000});
  const Mesh second = decimate(makeWaves(), {.targetTriangles = 1000});
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.triangles, second.triangles);
}

TEST(Decimation, TellsAllTheTimeHowFarItIs) {
  std::vector<double> told;
  const Progress progress([&](double fraction, std::string_view /*step*/) { told.push_back(fraction); }, {}, 1);
  static_cast<void>(decimate(makeSphere(50.0, 100), {.targetTriangles = 1000, .maxError = 10.0}, progress));
  const auto meanwhile =
      std::count_if(told.begin(), told.end(), [](double fraction) { return fraction > 0.3 && fraction < 0.9; });
  EXPECT_GT(meanwhile, 4);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

TEST(Decimation, AMeshSmallEnoughIsReturnedAsItIs) {
  const Mesh mesh = makeGrid(4, 4, 1.0);
  const Mesh same = decimate(mesh, {.targetTriangles = 32});
  EXPECT_EQ(same.vertices, mesh.vertices);
  EXPECT_EQ(same.triangles, mesh.triangles);
}

TEST(Decimation, DropsNonManifoldAndDegenerateTriangles) {
  Mesh mesh = makeGrid(20, 20, 1.0);
  mesh.vertices.emplace_back(5, 5, 5);
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const Triangle t = mesh.triangles[200];
  mesh.triangles.push_back({t[0], t[1], top});
  mesh.triangles.push_back({t[0], t[0], t[1]});
  const MeshMeasures m = measure(decimate(mesh, {.targetTriangles = 300}));
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_NEAR(m.area, 400.0, 1e-9);
}

TEST(Decimation, RefusesAnIndexOutOfRange) {
  Mesh mesh = makeGrid(20, 20, 1.0);
  mesh.triangles[7][1] = 100000;
  EXPECT_THROW(static_cast<void>(decimate(mesh, {.targetTriangles = 10})), InvalidInput);
}

TEST(Decimation, CanBeCancelledInTheMiddle) {
  std::stop_source source;
  const Progress progress(
      [&](double fraction, std::string_view /*step*/) {
        if (fraction >= 0.3) source.request_stop();
      },
      source.get_token(), 1);
  EXPECT_THROW(static_cast<void>(decimate(makeSphere(50.0, 60), {.targetTriangles = 100}, progress)), Cancelled);
}

}  // namespace
}  // namespace vantage
