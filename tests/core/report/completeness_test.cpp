#include "report/completeness.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/measures.h"
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
  const double face = area(cube) / 4.0;
  Plan plan;
  plan.voids = std::make_shared<const VoidSurface>();
  plan.voidLeft = 0.25 * face;
  EXPECT_NEAR(completenessOf(cube, &plan).wholeCovered, 4.0 / 6.0, 1e-9);
  EXPECT_NEAR(completenessOf(cube, &plan).scannableCovered, 4.0 / 4.25, 1e-9);
  // Nothing is known of it as long as there is a view to take.
  plan.outcome = PlanOutcome::Found;
  EXPECT_NEAR(completenessOf(cube, &plan).scannableCovered, 4.0 / 6.0, 1e-9);
}

TEST(Completeness, OfNothingIsNone) {
  const Completeness none = completenessOf(Mesh{}, nullptr);
  EXPECT_FALSE(none.closed);
  EXPECT_EQ(none.wholeCovered, 0.0);
}

}  // namespace
}  // namespace vantage
