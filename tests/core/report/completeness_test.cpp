#include "report/completeness.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/mesh_topology.h"
#include "support/meshes.h"

namespace vantage {
namespace {

// A cube of 10 mm with so many of its six sides.
Mesh cubeWith(int sides) {
  Mesh cube = testing::makeBox(Vec3::Zero(), Vec3(10, 10, 10), 4);
  const auto onSide = [&](const Triangle& t, int axis, double at) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return std::abs(cube.vertices[v][axis] - at) < 1e-9; });
  };
  std::erase_if(cube.triangles, [&](const Triangle& t) {
    return (sides < 6 && onSide(t, 2, 10.0)) || (sides < 5 && onSide(t, 2, 0.0));
  });
  return cube;
}

TEST(Completeness, OfAClosedSurfaceIsWhole) {
  const Completeness whole = completenessOf(cubeWith(6), nullptr);
  EXPECT_TRUE(whole.closed);
  EXPECT_EQ(whole.holes, 0U);
  EXPECT_EQ(whole.pieces, 1U);
  EXPECT_EQ(whole.wholeCovered, 1.0);
  EXPECT_EQ(whole.scannableCovered, 1.0);
}

TEST(Completeness, LacksWhatItsOpeningsSpan) {
  const Completeness open = completenessOf(cubeWith(4), nullptr);
  EXPECT_FALSE(open.closed);
  EXPECT_EQ(open.holes, 2U);
  EXPECT_NEAR(open.wholeCovered, 4.0 / 6.0, 1e-9);
  EXPECT_NEAR(open.scannableCovered, 4.0 / 6.0, 1e-9);
}

TEST(Completeness, WhatNoPositionShowsIsNotScannable) {
  const Mesh cube = cubeWith(4);
  Plan plan;
  VoidSurface voids;
  const MeshTopology topology(cube);
  for (const BoundaryEdge& edge : topology.boundaryEdges()) {
    VoidPatch patch;
    patch.from = edge.from;
    patch.to = edge.to;
    voids.patches.push_back(patch);
    const Vec3& at = cube.vertices[edge.from];
    PatchOutlook outlook;
    outlook.reason = at.z() < 5.0 ? EdgeReason::OutOfReach : EdgeReason::BelowThreshold;
    plan.outlook.push_back(outlook);
  }
  plan.voids = std::make_shared<const VoidSurface>(voids);
  const Completeness open = completenessOf(cube, &plan);
  EXPECT_NEAR(open.wholeCovered, 4.0 / 6.0, 1e-9);
  EXPECT_NEAR(open.scannableCovered, 4.0 / 5.0, 1e-9);
}

TEST(Completeness, IsToldByAForecastThatHasEnded) {
  const Mesh cube = cubeWith(4);
  Plan plan;
  plan.forecast = PlanForecast{{1.0, 0.0}, SurfaceLeft{25.0, 0.0, 50.0}, false};
  EXPECT_NEAR(completenessOf(cube, &plan).wholeCovered, 4.0 / 6.0, 1e-9);
  EXPECT_NEAR(completenessOf(cube, &plan).scannableCovered, 400.0 / 425.0, 1e-9);
  // Nothing is known of it as long as there is a view to take.
  plan.forecast->left.reset();
  EXPECT_NEAR(completenessOf(cube, &plan).scannableCovered, 4.0 / 6.0, 1e-9);
}

TEST(Completeness, OfNothingIsNone) {
  const Completeness none = completenessOf(Mesh{}, nullptr);
  EXPECT_FALSE(none.closed);
  EXPECT_EQ(none.wholeCovered, 0.0);
}

}  // namespace
}  // namespace vantage
