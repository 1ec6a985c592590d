#include "finishing/hole_closing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "base/errors.h"
#include "finishing/loose_pieces.h"
#include "finishing/print_check.h"
#include "geometry/measures.h"
#include "opened_meshes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeGrid;
using testing::makeSphere;
using testing::openedSphere;
using testing::tube;
using testing::without;

TEST(HoleClosing, PutsTheCapBackOnASphere) {
  const Mesh opened = openedSphere(18.0);  // an opening 17 mm wide
  const ClosedMesh closed = closeHoles(opened, {});
  ASSERT_EQ(closed.closed.size(), 1U);
  EXPECT_TRUE(closed.left.empty());
  const PrintCheck check = checkForPrint(closed.mesh);
  EXPECT_TRUE(check.printable());
  EXPECT_NEAR(*check.volume, 4.0 / 3.0 * kPi * 8000.0, 0.01 * 33510.0);
  // The cap of the sphere, within a tenth of its height.
  for (std::size_t v = closed.firstInventedVertex; v < closed.mesh.vertices.size(); ++v)
    EXPECT_NEAR(closed.mesh.vertices[v].norm(), 20.0, 0.2);
  const double cap = 2.0 * kPi * 20.0 * (20.0 - 18.0);
  EXPECT_NEAR(closed.inventedArea(), cap, 0.1 * cap);
}

TEST(HoleClosing, WhatWasMeasuredStaysAsItIs) {
  const Mesh opened = openedSphere(15.0);
  const ClosedMesh closed = closeHoles(opened, {});
  ASSERT_EQ(closed.firstInventedVertex, opened.vertices.size());
  ASSERT_EQ(closed.firstInventedTriangle, opened.triangles.size());
  EXPECT_TRUE(std::equal(opened.vertices.begin(), opened.vertices.end(), closed.mesh.vertices.begin()));
  EXPECT_TRUE(std::equal(opened.triangles.begin(), opened.triangles.end(), closed.mesh.triangles.begin()));
  EXPECT_EQ(closed.copyOf.size(), closed.mesh.vertices.size() - opened.vertices.size());
}

TEST(HoleClosing, LeavesWhatIsWiderThanTheLimit) {
  Mesh mesh = without(tube(), [](const Vec3& p) { return (p - Vec3(10, 0, 15)).norm() < 3.0; });
  const ClosedMesh closed = closeHoles(mesh, {.maxWidth = 8.0});
  ASSERT_EQ(closed.closed.size(), 1U);
  ASSERT_EQ(closed.left.size(), 2U);
  for (const OpeningLeft& left : closed.left) {
    EXPECT_EQ(left.reason, StaysOpen::TooWide);
    EXPECT_NEAR(left.width, 20.0, 1e-6);
  }
  EXPECT_EQ(measure(closed.mesh).boundaryLoops, 2U);
}

TEST(HoleClosing, ClosesThoseThatAreAskedFor) {
  const ClosedMesh closed = closeHoles(tube(), {.only = std::vector<std::size_t>{1}});
  ASSERT_EQ(closed.closed.size(), 1U);
  EXPECT_EQ(closed.closed[0].opening, 1U);
  ASSERT_EQ(closed.left.size(), 1U);
  EXPECT_EQ(closed.left[0].reason, StaysOpen::NotAsked);
}

TEST(HoleClosing, ALidIsOnlyAsRoundAsItsReach) {
  // 20 mm across, edges of 1 mm: the wall goes on for a while, and farther inside the lid is flat.
  const ClosedMesh short_ = closeHoles(tube(), {.reachInEdges = 1.0});
  const ClosedMesh far = closeHoles(tube(), {.reachInEdges = 30.0});
  const double shortTop = boundingBox(short_.mesh).max.z();
  const double farTop = boundingBox(far.mesh).max.z();
  EXPECT_LT(shortTop, 31.5);
  EXPECT_GT(farTop, shortTop + 1.0);
  EXPECT_TRUE(checkForPrint(short_.mesh).printable());
  EXPECT_TRUE(checkForPrint(far.mesh).printable());
}

TEST(HoleClosing, ALidThatWouldPassThroughSomethingIsDrawnTight) {
  // A plate stands just above the opening of a tube: a round lid would pass through it, a tight one does not.
  Mesh plate = testing::makeBox(Vec3(-8, -8, 31.5), Vec3(8, 8, 32.5), 8);
  const Mesh both = joined(tube(), plate);
  const ClosedMesh closed = closeHoles(both, {.reachInEdges = 30.0});
  ASSERT_EQ(closed.closed.size(), 2U);
  EXPECT_EQ(closed.crossings(), 0U);
}

TEST(HoleClosing, SaysWhereALidPassesThroughSomething) {
  // Nothing flat fits into an opening that a rod comes out of.
  const Mesh rod = testing::makeBox(Vec3(-1, -1, 20), Vec3(1, 1, 40), 2);
  const ClosedMesh closed = closeHoles(joined(tube(), rod), {});
  EXPECT_GT(closed.crossings(), 0U);
  EXPECT_FALSE(checkForPrint(closed.mesh).printable());
}

TEST(HoleClosing, TheSmallestOpeningIsATriangle) {
  Mesh mesh = makeSphere(10.0, 8);
  mesh.triangles.pop_back();
  const ClosedMesh closed = closeHoles(mesh, {});
  ASSERT_EQ(closed.closed.size(), 1U);
  EXPECT_EQ(closed.mesh.vertices.size(), mesh.vertices.size());
  EXPECT_EQ(closed.mesh.triangles.size(), mesh.triangles.size() + 1);
  EXPECT_TRUE(checkForPrint(closed.mesh).printable());
}

TEST(HoleClosing, AFlatSheetIsClosedFromBehind) {
  const ClosedMesh closed = closeHoles(makeGrid(10, 10, 1.0), {});
  const MeshMeasures m = measure(closed.mesh);
  EXPECT_EQ(m.boundaryEdges, 0U);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
}

TEST(HoleClosing, AWideOpeningGetsNoMoreTrianglesThanAllowed) {
  const ClosedMesh closed = closeHoles(tube(), {.spacing = 0.01, .mostTriangles = 2000});
  EXPECT_LT(closed.mesh.triangles.size(), tube().triangles.size() + 2 * 4000);
}

TEST(HoleClosing, TheSameForAnyNumberOfThreads) {
  const Mesh mesh = openedSphere(5.0);
  const ClosedMesh one = closeHoles(mesh, {});
  const ClosedMesh four = closeHoles(mesh, {}, Progress({}, {}, 4));
  EXPECT_EQ(one.mesh.vertices, four.mesh.vertices);
  EXPECT_EQ(one.mesh.triangles, four.mesh.triangles);
}

TEST(HoleClosing, RefusesASurfaceWhoseOpeningsCannotBeTold) {
  Mesh mesh = makeGrid(2, 2, 1.0);
  mesh.vertices.emplace_back(0, 0, 5);
  mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][1], static_cast<std::uint32_t>(9)});
  EXPECT_THROW(static_cast<void>(closeHoles(mesh, {})), InvalidInput);
}

TEST(HoleClosing, IsCancelled) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(closeHoles(tube(), {}, Progress({}, stop.get_token(), 1))), Cancelled);
}

TEST(HoleClosing, ReasonsHaveNames) {
  EXPECT_EQ(name(StaysOpen::TooWide), "too_wide");
  EXPECT_EQ(name(StaysOpen::NotAsked), "not_asked");
  EXPECT_EQ(name(StaysOpen::NoFilling), "no_filling");
}

}  // namespace
}  // namespace vantage
