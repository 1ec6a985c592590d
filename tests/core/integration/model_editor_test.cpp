#include "integration/model_editor.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeGrid;
using testing::makeSphere;
using testing::modelOf;

TEST(ModelEditor, RestoredTriangleIsInItsPlaceAgain) {
  Model model = testing::modelOf(testing::lookDown({4, 4, 0, 0}, [](double, double) { return 0.0; }).mesh->mesh);
  const std::vector<Triangle> before = model.mesh.triangles;
  ModelEditor editor(std::move(model));
  editor.removeTriangle(7);
  editor.removeTriangle(8);
  EXPECT_EQ(editor.triangleAt(before[7][0], before[7][1]), kNoIndex);
  editor.restoreTriangle(8);
  editor.restoreTriangle(7);
  editor.restoreTriangle(7);
  EXPECT_EQ(editor.triangleAt(before[7][0], before[7][1]), 7U);
  EXPECT_EQ(std::move(editor).take().mesh.triangles, before);
}

TEST(ModelEditor, RefusesTriangleWhoseDirectedEdgeIsTaken) {
  ModelEditor editor(modelOf(makeGrid(1, 1, 1.0)));  // triangles 0 1 3 and 0 3 2
  const std::uint32_t v = editor.addVertex(Vec3(2, 2, 0), 0.5F, 1, 7);
  EXPECT_FALSE(editor.addTriangle({0, 1, v}, 1));
  EXPECT_FALSE(editor.addTriangle({1, 1, v}, 1));
  EXPECT_TRUE(editor.addTriangle({3, 1, v}, 1));
  EXPECT_EQ(editor.triangleCount(), 3U);
  EXPECT_EQ(editor.neighbour(0, 1), 2U);
}

TEST(ModelEditor, KnowsTheBoundaryWhileTrianglesComeAndGo) {
  ModelEditor editor(modelOf(makeSphere(10.0, 8)));
  for (std::uint32_t v = 0; v < editor.vertexCount(); ++v) EXPECT_FALSE(editor.onBoundary(v));
  const Triangle t = editor.triangle(5);
  editor.removeTriangle(5);
  for (const std::uint32_t v : t) EXPECT_TRUE(editor.onBoundary(v));
  EXPECT_EQ(editor.triangleAt(t[0], t[1]), kNoIndex);
  EXPECT_TRUE(editor.addTriangle(t, 3));
  for (const std::uint32_t v : t) EXPECT_FALSE(editor.onBoundary(v));
  EXPECT_EQ(editor.triangleAt(t[0], t[1]), editor.triangleCount() - 1);
}

TEST(ModelEditor, TakeSqueezesAndKeepsProvenance) {
  ModelEditor editor(modelOf(makeGrid(2, 1, 1.0)));
  const std::uint32_t v = editor.addVertex(Vec3(3, 0.5, 0), 0.25F, 4, 99);
  ASSERT_TRUE(editor.addTriangle({2, v, 5}, 4));
  editor.removeTriangle(0);
  editor.removeTriangle(1);
  editor.removeTriangle(0);
  const Model model = std::move(editor).take();
  ASSERT_EQ(model.mesh.triangles.size(), 3U);
  ASSERT_EQ(model.mesh.vertices.size(), 5U);
  EXPECT_EQ(model.triangleView, (std::vector<std::uint32_t>{0, 0, 4}));
  EXPECT_EQ(model.vertexView.back(), 4U);
  EXPECT_EQ(model.vertexSample.back(), 99U);
  EXPECT_EQ(model.confidence.back(), 0.25F);
  EXPECT_EQ(model.vertexSample.front(), 1U);
  EXPECT_EQ(model.mesh.vertices.front(), Vec3(1, 0, 0));
}

TEST(ModelEditor, RefusesModelWithIncompleteProvenance) {
  Model model = modelOf(makeGrid(1, 1, 1.0));
  model.vertexSample.pop_back();
  EXPECT_THROW(ModelEditor{model}, InvalidInput);
  model = modelOf(makeGrid(1, 1, 1.0));
  model.mesh.triangles[0][0] = 17;
  EXPECT_THROW(ModelEditor{model}, InvalidInput);
}

}  // namespace
}  // namespace vantage
