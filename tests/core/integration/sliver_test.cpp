#include "integration/sliver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "geometry/measures.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::countBowTies;
using testing::eulerCharacteristic;
using testing::makeGrid;
using testing::modelOf;

std::vector<std::uint32_t> allVertices(const ModelEditor& editor) {
  std::vector<std::uint32_t> vertices(editor.vertexCount());
  std::iota(vertices.begin(), vertices.end(), 0U);
  return vertices;
}

TEST(RemoveSlivers, CollapsesShortEdgeOntoTheMoreConfidentEnd) {
  Mesh mesh = makeGrid(4, 4, 1.0);
  mesh.vertices[12] = Vec3(1.1, 2.0, 0.0);  // the middle, moved next to its left neighbour 11 at (1, 2)
  Model model = modelOf(mesh);
  model.confidence[12] = 0.5F;
  ModelEditor editor(model);
  EXPECT_EQ(removeSlivers(editor, allVertices(editor), {.shortestEdge = 0.3, .minRoundness = 0.0}), 1U);
  const Model result = std::move(editor).take();
  EXPECT_EQ(result.mesh.vertices.size(), 24U);
  EXPECT_EQ(result.mesh.triangles.size(), 30U);
  EXPECT_EQ(std::count(result.vertexSample.begin(), result.vertexSample.end(), 12U), 0);
  EXPECT_NEAR(area(result.mesh), 16.0, 1e-12);
  EXPECT_EQ(eulerCharacteristic(result.mesh), 1);
  EXPECT_EQ(countBowTies(result.mesh), 0U);
}

TEST(RemoveSlivers, FlipsTheLongEdgeOfNeedles) {
  // Two flat triangles over the long diagonal of a rhombus.
  Mesh mesh;
  mesh.vertices = {Vec3(-5, 0, 0), Vec3(0, -1, 0), Vec3(5, 0, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  ModelEditor editor(modelOf(mesh));
  EXPECT_EQ(removeSlivers(editor, allVertices(editor), {.shortestEdge = 0.1}), 1U);
  EXPECT_NE(editor.triangleAt(1, 3), kNoIndex);
  EXPECT_EQ(editor.triangleAt(0, 2), kNoIndex);
  EXPECT_NEAR(area(std::move(editor).take().mesh), 10.0, 1e-12);
}

TEST(RemoveSlivers, DoesNotFoldASharpRidge) {
  // The same rhombus bent along the long diagonal by a right angle: a flip would cut through the ridge.
  Mesh mesh;
  mesh.vertices = {Vec3(-5, 0, 0), Vec3(0, -1, -1.2), Vec3(5, 0, 0), Vec3(0, 1, -1.2)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  ModelEditor editor(modelOf(mesh));
  EXPECT_EQ(removeSlivers(editor, allVertices(editor), {.shortestEdge = 0.1, .maxTurn = radians(40.0)}), 0U);
}

TEST(RemoveSlivers, LeavesAGoodMeshAlone) {
  ModelEditor editor(modelOf(makeGrid(5, 5, 1.0)));
  EXPECT_EQ(removeSlivers(editor, allVertices(editor), {.shortestEdge = 0.3}), 0U);
}

}  // namespace
}  // namespace vantage
