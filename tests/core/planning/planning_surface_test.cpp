#include "planning/planning_surface.h"

#include <gtest/gtest.h>

#include "geometry/measures.h"
#include "support/meshes.h"

namespace vantage {
namespace {

TEST(TracedMesh, IsTheModelUnlessThatIsLarge) {
  const Mesh sphere = testing::makeSphere(50.0, 40);
  EXPECT_EQ(tracedMesh(sphere, sphere.triangles.size(), 1.0, {}).triangles, sphere.triangles);
  const Mesh coarse = tracedMesh(sphere, 1000, 1.0, {});
  EXPECT_LE(coarse.triangles.size(), 1000U);
  EXPECT_NEAR(area(coarse), area(sphere), 0.05 * area(sphere));
}

TEST(TracedMesh, OfAVeryLargeModelIsClusteredAndAsFine) {
  const Mesh sphere = testing::makeSphere(50.0, 520);
  const Mesh coarse = tracedMesh(sphere, 100'000, 1.0, {});
  EXPECT_LE(coarse.triangles.size(), 100'000U);
  EXPECT_GT(coarse.triangles.size(), 25'000U);
  EXPECT_NEAR(area(coarse), area(sphere), 0.01 * area(sphere));
}

TEST(WithoutBorder, LeavesOutThreeRingsOfTriangles) {
  EXPECT_DOUBLE_EQ(area(withoutBorder(testing::makeGrid(10, 10, 1.0), 2)), 16.0);  // 4 x 4 squares in the middle
  const Mesh sphere = testing::makeSphere(50.0, 20);
  EXPECT_EQ(withoutBorder(sphere, 2).triangles.size(), sphere.triangles.size());
}

TEST(SurfaceElements, StandForTheWholeMesh) {
  const Mesh sphere = testing::makeSphere(50.0, 40);
  for (const std::size_t count : {std::size_t{100}, std::size_t{1000}, sphere.triangles.size()}) {
    const auto elements = surfaceElements(sphere, count);
    EXPECT_GE(elements.size(), count);
    double sum = 0.0;
    for (const SurfaceElement& element : elements) sum += element.area;
    EXPECT_NEAR(sum, area(sphere), 0.05 * area(sphere)) << count;
  }
}

}  // namespace
}  // namespace vantage
