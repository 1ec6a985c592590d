#include "integration/crumb.h"

#include <gtest/gtest.h>

#include <utility>

#include "geometry/measures.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::lookDown;
using testing::modelOf;
using testing::Window;

// A plate of 100 x 100 mm and beside it, at another height, a piece of some samples.
Mesh plateAnd(int rows, int columns) {
  Mesh mesh = lookDown(Window{101, 101, 0.0, 0.0}, [](double, double) { return 0.0; }).mesh->mesh;
  const auto piece = lookDown(Window{rows, columns, 120.0, 0.0}, [](double, double) { return -20.0; }).mesh;
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), piece->mesh.vertices.begin(), piece->mesh.vertices.end());
  for (const Triangle& t : piece->mesh.triangles)
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return mesh;
}

std::size_t piecesAfterwards(const Mesh& mesh, std::size_t& removed) {
  ModelEditor editor(modelOf(mesh));
  removed = removeCrumbs(editor);
  return measure(std::move(editor).take().mesh).components;
}

TEST(RemoveCrumbs, AFewSamplesBesideTheModelGo) {
  std::size_t removed = 0;
  EXPECT_EQ(piecesAfterwards(plateAnd(4, 4), removed), 1U);  // 9 of 10009 mm^2
  EXPECT_EQ(removed, 18U);
}

TEST(RemoveCrumbs, NarrowStripsStayWhenTheyAreNotSmall) {
  std::size_t removed = 0;
  EXPECT_EQ(piecesAfterwards(plateAnd(3, 60), removed), 2U);  // 118 mm^2, a wire
  EXPECT_EQ(removed, 0U);
}

TEST(RemoveCrumbs, SmallPiecesStayWhenTheirMiddleIsWellSampled) {
  std::size_t removed = 0;
  EXPECT_EQ(piecesAfterwards(plateAnd(9, 9), removed), 2U);  // the middle is four samples inside
  EXPECT_EQ(removed, 0U);
}

TEST(RemoveCrumbs, ASmallModelIsNoCrumb) {
  ModelEditor editor(modelOf(lookDown(Window{3, 3, 0.0, 0.0}, [](double, double) { return 0.0; }).mesh->mesh));
  EXPECT_EQ(removeCrumbs(editor), 0U);
}

TEST(RemoveCrumbs, AnEmptyModelHasNone) {
  ModelEditor editor((Model()));
  EXPECT_EQ(removeCrumbs(editor), 0U);
}

}  // namespace
}  // namespace vantage
