#include "integration/hole.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/measures.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::eulerCharacteristic;
using testing::flat;
using testing::Height;
using testing::kNothing;
using testing::lookDown;
using testing::modelOf;
using testing::Window;

const Window kWindow{12, 12, 0.0, 0.0};

Height flatWithGap(const Vec2& from, const Vec2& to) {
  return
      [=](double x, double y) { return x >= from.x() && x <= to.x() && y >= from.y() && y <= to.y() ? kNothing : 0.0; };
}
// Sees the right margin only.
Height elsewhere() {
  return [](double x, double) { return x < 9 ? kNothing : 0.0; };
}

// The mesh of a view as a model, its left half by another view where `twoViews`.
Model modelWith(const Height& height, bool twoViews) {
  Model model = modelOf(lookDown(kWindow, height).mesh->mesh);
  if (twoViews)
    for (std::size_t v = 0; v < model.vertexView.size(); ++v)
      model.vertexView[v] = model.mesh.vertices[v].x() < 5.5 ? 0 : 1;
  return model;
}

std::size_t closeSeenFrom(ModelEditor& editor, const Height& newView) {
  return closeSmallHoles(editor, GridSurface(lookDown(kWindow, newView)), 2, {});
}

TEST(CloseSmallHoles, ClosesWhereTheNewViewHasSurface) {
  ModelEditor editor(modelWith(flatWithGap({5, 5}, {5, 5}), false));  // six triangles are missing
  EXPECT_EQ(closeSeenFrom(editor, flat(0.0)), 1U);
  const Mesh mesh = std::move(editor).take().mesh;
  EXPECT_NEAR(area(mesh), 121.0, 1e-9);
  EXPECT_EQ(eulerCharacteristic(mesh), 1);
}

TEST(CloseSmallHoles, LeavesOpenWhatTheNewViewLooksThrough) {
  ModelEditor editor(modelWith(flatWithGap({5, 5}, {5, 5}), true));
  EXPECT_EQ(closeSeenFrom(editor, flat(-8.0)), 0U);
}

TEST(CloseSmallHoles, LeavesUnseenHoleOfOneViewOpenButClosesTheSlitBetweenTwo) {
  ModelEditor one(modelWith(flatWithGap({5, 5}, {5, 5}), false));
  EXPECT_EQ(closeSeenFrom(one, elsewhere()), 0U);
  ModelEditor two(modelWith(flatWithGap({5, 5}, {5, 5}), true));
  EXPECT_EQ(closeSeenFrom(two, elsewhere()), 1U);
}

TEST(CloseSmallHoles, LeavesALargeHoleOpen) {
  ModelEditor editor(modelWith(flatWithGap({3, 3}, {8, 8}), true));
  EXPECT_EQ(closeSeenFrom(editor, flat(0.0)), 0U);
  EXPECT_EQ(measure(editor.model().mesh).boundaryLoops, 2U);
}

TEST(CloseSmallHoles, DoesNotWrapASmallPiece) {
  // One cell of two triangles: its outer border is a short loop, too.
  ModelEditor editor(modelWith([](double x, double y) { return x < 2 && y < 2 ? 0.0 : kNothing; }, true));
  EXPECT_EQ(closeSeenFrom(editor, flat(0.0)), 0U);
}

TEST(CloseSmallHoles, ReplacesTrianglesWhereTheBorderOverlapsItself) {
  // One triangle is missing, and one of its corners has been pushed across the opposite side: the hole has turned over.
  Model model = modelWith([](double, double) { return 0.0; }, true);
  const std::uint32_t pushed = 5 * 12 + 5;
  ASSERT_EQ(std::erase(model.mesh.triangles, Triangle{pushed, pushed + 1, pushed + 13}), 1U);
  model.triangleView.pop_back();
  model.mesh.vertices[pushed] = Vec3(6.3, 5.4, 0.0);
  ModelEditor editor(std::move(model));
  EXPECT_EQ(closeSeenFrom(editor, flat(0.0)), 1U);
  const Mesh mesh = std::move(editor).take().mesh;
  EXPECT_EQ(eulerCharacteristic(mesh), 1);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(areaVector(mesh, t).z(), 0.0);
}

}  // namespace
}  // namespace vantage
