#include "finishing/finished_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/errors.h"
#include "geometry/measures.h"
#include "opened_meshes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeBox;
using testing::openedSphere;

// A model whose provenance counts up.
Model modelOf(Mesh mesh) {
  Model model;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    model.confidence.push_back(0.5F);
    model.vertexView.push_back(v % 3);
    model.vertexSample.push_back(v);
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) model.triangleView.push_back(t % 3);
  model.mesh = std::move(mesh);
  return model;
}

TEST(FinishedModel, WhatIsInventedIsMarkedAndMeasuredByItself) {
  const Model model = modelOf(openedSphere(15.0));
  const FinishedModel finished = finish(model, {.close = HoleClosingOptions{}, .repair = true});
  EXPECT_TRUE(finished.check.printable());
  ASSERT_EQ(finished.closed.size(), 1U);
  EXPECT_NEAR(finished.measuredArea, area(model.mesh), 1e-9);
  EXPECT_NEAR(finished.inventedArea, finished.closed[0].area, 1e-9);
  EXPECT_NEAR(finished.measuredArea + finished.inventedArea, area(finished.model.mesh), 1e-9);
  const std::vector<std::uint8_t> invented = finished.invented();
  ASSERT_EQ(invented.size(), finished.model.mesh.vertices.size());
  EXPECT_GT(std::count(invented.begin(), invented.end(), 1), 50);
  for (std::size_t v = 0; v < invented.size(); ++v) {
    EXPECT_EQ(finished.model.vertexView[v] == kNoIndex, invented[v] == 1);
    EXPECT_EQ(finished.model.confidence[v] == 0.0F, invented[v] == 1);
    if (invented[v] == 0) {
      EXPECT_EQ(finished.model.mesh.vertices[v], model.mesh.vertices[finished.vertexOf[v]]);
    }
  }
  // A triangle that was measured has no corner that is invented.
  for (std::size_t t = 0; t < finished.model.mesh.triangles.size(); ++t)
    if (finished.model.triangleView[t] != kNoIndex) {
      for (const std::uint32_t v : finished.model.mesh.triangles[t]) EXPECT_EQ(invented[v], 0);
    }
}

TEST(FinishedModel, ColoursGoWithTheirVertices) {
  const Model model = modelOf(openedSphere(15.0));
  VertexColours colours(model.mesh.vertices.size(), Colour{1, 2, 3});
  colours[0] = std::nullopt;
  const FinishedModel finished = finish(model, {.close = HoleClosingOptions{}});
  const VertexColours now = finished.coloursOf(colours);
  ASSERT_EQ(now.size(), finished.model.mesh.vertices.size());
  for (std::size_t v = 0; v < now.size(); ++v)
    EXPECT_EQ(now[v].has_value(), finished.vertexOf[v] != kNoIndex && finished.vertexOf[v] != 0);
  EXPECT_TRUE(finished.coloursOf({}).empty());
}

TEST(FinishedModel, LoosePiecesAreLeftOutBeforeAllElse) {
  const Model model = modelOf(joined(makeBox(Vec3(0, 0, 0), Vec3(9, 9, 9)), makeBox(Vec3(20, 0, 0), Vec3(21, 1, 1))));
  const FinishedModel small = finish(model, {.leaveOut = 10.0});
  EXPECT_EQ(small.piecesLeftOut, 1U);
  EXPECT_NEAR(small.areaLeftOut, 6.0, 1e-9);
  EXPECT_TRUE(small.check.printable());
  EXPECT_EQ(small.model.mesh.vertices.size(), 8U);
  const FinishedModel none = finish(model, {.leaveOut = 5.0});
  EXPECT_EQ(none.piecesLeftOut, 0U);
  EXPECT_EQ(none.check.faults, (std::vector{PrintFault::Pieces}));
}

TEST(FinishedModel, ASimplifiedLidIsStillInvented) {
  const Model model = modelOf(openedSphere(10.0));
  const FinishedModel finished = finish(
      model, {.close = HoleClosingOptions{}, .simplify = SimplificationOptions{.maxTriangles = 1500}, .repair = true});
  ASSERT_TRUE(finished.simplified.has_value());
  EXPECT_TRUE(finished.simplified->reached);
  EXPECT_LE(finished.model.mesh.triangles.size(), 1500U);
  EXPECT_TRUE(finished.check.printable());
  const double cap = 2.0 * kPi * 20.0 * 10.0;
  EXPECT_GT(finished.inventedArea, 0.4 * cap);
  EXPECT_LT(finished.inventedArea, 1.2 * cap);
  EXPECT_FALSE(finished.invented().empty());
}

TEST(FinishedModel, NothingAskedNothingDone) {
  Model model = modelOf(openedSphere(10.0));
  removeUnusedVertices(model.mesh);
  model = modelOf(std::move(model.mesh));
  const FinishedModel finished = finish(model, {});
  EXPECT_EQ(finished.model.mesh.triangles, model.mesh.triangles);
  EXPECT_TRUE(finished.invented().empty());
  EXPECT_EQ(finished.inventedArea, 0.0);
  EXPECT_TRUE(FinishingOptions{}.nothing());
}

TEST(FinishedModel, RefusesLimitsThatAreNone) {
  const Model model = modelOf(openedSphere(10.0));
  EXPECT_THROW(static_cast<void>(finish({}, {})), InvalidInput);
  EXPECT_THROW(static_cast<void>(finish(model, {.leaveOut = 0.0})), InvalidInput);
  EXPECT_THROW(static_cast<void>(finish(model, {.close = HoleClosingOptions{.maxWidth = -1.0}})), InvalidInput);
  EXPECT_THROW(static_cast<void>(finish(model, {.leaveOut = std::numeric_limits<double>::quiet_NaN()})), InvalidInput);
}

}  // namespace
}  // namespace vantage
