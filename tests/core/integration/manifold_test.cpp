#include "integration/manifold.h"

#include <gtest/gtest.h>

#include "geometry/measures.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::countBowTies;
using testing::joined;
using testing::makeGrid;
using testing::modelOf;

// Two grids that share one corner vertex: 3 x 3 cells, and `cells` x `cells` beyond its upper right corner.
Mesh bowTie(int cells) {
  Mesh mesh = makeGrid(3, 3, 1.0);
  const auto shared = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  Mesh other = makeGrid(cells, cells, 1.0);
  for (Vec3& v : other.vertices) v += Vec3(3, 3, 0);
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh = joined(mesh, other);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      if (v == offset) v = shared;
  return mesh;
}

TEST(ResolveBowTies, KeepsTheFirstOfTwoEqualFans) {
  const Mesh mesh = bowTie(3);
  ASSERT_EQ(countBowTies(mesh), 1U);
  ModelEditor editor(modelOf(mesh));
  // Either corner has one cell's two triangles at the shared vertex.
  EXPECT_EQ(resolveBowTies(editor, {}), 2U);
  const Mesh result = std::move(editor).take().mesh;
  EXPECT_EQ(countBowTies(result), 0U);
  EXPECT_EQ(result.triangles.size(), mesh.triangles.size() - 2);
  EXPECT_EQ(measure(result).components, 2U);
}

TEST(ResolveBowTies, FollowsUpWhereARemovalPinchesOff) {
  // The second fan is a chain of triangles that hang together only at corners.
  Mesh mesh = makeGrid(3, 3, 1.0);
  const auto shared = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  std::uint32_t at = shared;
  for (int i = 0; i < 3; ++i) {
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(4.0 + i, 3.0, 0.0);
    mesh.vertices.emplace_back(4.0 + i, 4.0, 0.0);
    mesh.triangles.push_back({at, n, n + 1});
    at = n + 1;
  }
  ModelEditor editor(modelOf(mesh));
  resolveBowTies(editor, {});
  EXPECT_EQ(countBowTies(std::move(editor).take().mesh), 0U);
}

TEST(RemoveIslands, DropsPiecesBelowTheLimitOnly) {
  Mesh small = makeGrid(2, 1, 1.0);  // 4 triangles
  for (Vec3& v : small.vertices) v += Vec3(10, 0, 0);
  const Mesh mesh = joined(makeGrid(3, 3, 1.0), small);
  ModelEditor kept(modelOf(mesh));
  EXPECT_EQ(removeIslands(kept, 4), 0U);
  ModelEditor dropped(modelOf(mesh));
  EXPECT_EQ(removeIslands(dropped, 5), 4U);
  EXPECT_EQ(std::move(dropped).take().mesh.triangles.size(), 18U);
}

}  // namespace
}  // namespace vantage
