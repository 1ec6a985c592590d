#include "geometry/vertex_clustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <string_view>
#include <utility>

#include "base/errors.h"
#include "geometry/measures.h"
#include "geometry/ray_caster.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::joined;
using testing::makeGrid;
using testing::makeSphere;

TEST(VertexClustering, LeavesAboutAsManyTrianglesAsWereAskedFor) {
  const Mesh sphere = makeSphere(50.0, 200);
  const Mesh coarse = clustered(sphere, cubeFor(area(sphere), 10'000));
  EXPECT_GT(coarse.triangles.size(), 7'000U);
  EXPECT_LT(coarse.triangles.size(), 13'000U);
}

TEST(VertexClustering, TheSurfaceStaysWhereItIs) {
  const Mesh sphere = makeSphere(50.0, 200);
  const Mesh coarse = clustered(sphere, 3.0);
  EXPECT_LT(coarse.triangles.size(), sphere.triangles.size() / 4);
  EXPECT_NEAR(area(coarse), area(sphere), 0.02 * area(sphere));
  const RayCaster caster(coarse);
  for (const Vec3& v : sphere.vertices) ASSERT_TRUE(caster.closestPoint(v, 0.2));
  double turned = 0.0;  // folded over
  for (const Triangle& t : coarse.triangles)
    if (areaVector(coarse, t).dot(triangleCentre(coarse, t)) < 0.0) turned += triangleArea(coarse, t);
  EXPECT_LT(turned, 0.005 * area(sphere));
}

TEST(VertexClustering, TheBorderStaysAsItIs) {
  const Mesh sheet = makeGrid(40, 30, 1.0);
  const Mesh coarse = clustered(sheet, 7.0);
  EXPECT_LT(coarse.triangles.size(), sheet.triangles.size() / 2);
  EXPECT_NEAR(area(coarse), 40.0 * 30.0, 1e-9);
  for (int i = 0; i <= 40; ++i)
    EXPECT_EQ(std::count(coarse.vertices.begin(), coarse.vertices.end(), Vec3(i, 0, 0)), 1) << i;
}

TEST(VertexClustering, SidesOfAThinWallStayApart) {
  Mesh back = makeGrid(40, 40, 1.0);
  for (Vec3& v : back.vertices) v.z() -= 0.1;
  for (Triangle& t : back.triangles) std::swap(t[1], t[2]);
  const Mesh coarse = clustered(joined(makeGrid(40, 40, 1.0), back), 10.0);
  for (const Triangle& t : coarse.triangles)
    EXPECT_TRUE(coarse.vertices[t[0]].z() == coarse.vertices[t[1]].z() &&
                coarse.vertices[t[1]].z() == coarse.vertices[t[2]].z());
  EXPECT_NEAR(area(coarse), 2.0 * 1600.0, 1e-9);
}

TEST(VertexClustering, RepeatsToTheByte) {
  const Mesh sphere = makeSphere(50.0, 60);
  const Mesh one = clustered(sphere, 4.0);
  const Mesh two = clustered(sphere, 4.0);
  EXPECT_EQ(one.vertices, two.vertices);
  EXPECT_EQ(one.triangles, two.triangles);
}

TEST(VertexClustering, RefusesCubesWithoutSizeAndIndicesOutOfRange) {
  EXPECT_THROW(static_cast<void>(clustered(makeGrid(2, 2, 1.0), 0.0)), InvalidInput);
  Mesh broken = makeGrid(2, 2, 1.0);
  broken.triangles[0][0] = 99;
  EXPECT_THROW(static_cast<void>(clustered(broken, 1.0)), InvalidInput);
}

TEST(VertexClustering, CanBeCancelledInTheMiddle) {
  std::stop_source source;
  const Progress progress(
      [&](double fraction, std::string_view /*step*/) {
        if (fraction >= 0.5) source.request_stop();
      },
      source.get_token(), 1);
  EXPECT_THROW(static_cast<void>(clustered(makeSphere(50.0, 60), 4.0, progress)), Cancelled);
}

}  // namespace
}  // namespace vantage
