#include "finishing/simplification.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/errors.h"
#include "geometry/measures.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeGrid;
using testing::makeSphere;

TEST(Simplification, KeepsTheErrorThatItMeasures) {
  const Mesh fine = makeSphere(20.0, 60);
  for (const double most : {0.02, 0.1, 0.5}) {
    const SimplifiedMesh coarse = simplify(fine, {.maxError = most});
    EXPECT_LE(coarse.error.greatest, most);
    EXPECT_GT(coarse.error.greatest, 0.0);
    EXPECT_LT(coarse.mesh.triangles.size(), most > 0.05 ? fine.triangles.size() / 3 : fine.triangles.size()) << most;
    const SurfaceDistance measured = distanceBetween(fine, coarse.mesh);
    EXPECT_DOUBLE_EQ(measured.greatest, coarse.error.greatest);
    EXPECT_EQ(measure(coarse.mesh).boundaryEdges, 0U);
  }
}

TEST(Simplification, ReachesANumberOfTrianglesAndSaysWhatThatCosts) {
  const SimplifiedMesh coarse = simplify(makeSphere(20.0, 60), {.maxTriangles = 1000});
  EXPECT_TRUE(coarse.reached);
  EXPECT_LE(coarse.mesh.triangles.size(), 1000U);
  EXPECT_GT(coarse.error.greatest, 0.01);
  EXPECT_LT(coarse.error.greatest, 1.0);
}

TEST(Simplification, VerticesAreSomeOfThoseBefore) {
  const Mesh fine = makeSphere(20.0, 30);
  const SimplifiedMesh coarse = simplify(fine, {.maxTriangles = 300});
  ASSERT_EQ(coarse.vertexOf.size(), coarse.mesh.vertices.size());
  for (std::size_t v = 0; v < coarse.vertexOf.size(); ++v)
    EXPECT_EQ(coarse.mesh.vertices[v], fine.vertices[coarse.vertexOf[v]]);
}

TEST(Simplification, SaysWhenTheBorderKeepsItFromTheNumber) {
  const SimplifiedMesh coarse = simplify(makeGrid(30, 30, 1.0), {.maxTriangles = 10});
  EXPECT_FALSE(coarse.reached);
  EXPECT_GE(coarse.mesh.triangles.size(), 118U);  // a triangulation of its 120 border vertices
}

TEST(Simplification, OfFewEnoughTrianglesNothingChanges) {
  const Mesh fine = makeSphere(20.0, 10);
  const SimplifiedMesh same = simplify(fine, {.maxTriangles = 100'000});
  EXPECT_EQ(same.mesh.triangles, fine.triangles);
  EXPECT_NEAR(same.error.greatest, 0.0, 1e-6);
  EXPECT_TRUE(same.reached);
}

TEST(Simplification, RefusesLimitsThatAreNone) {
  const Mesh mesh = makeGrid(2, 2, 1.0);
  EXPECT_THROW(static_cast<void>(simplify(mesh, {})), InvalidInput);
  EXPECT_THROW(static_cast<void>(simplify(mesh, {.maxTriangles = 0})), InvalidInput);
  EXPECT_THROW(static_cast<void>(simplify(mesh, {.maxError = 0.0})), InvalidInput);
  EXPECT_THROW(static_cast<void>(simplify(mesh, {.maxError = std::numeric_limits<double>::quiet_NaN()})), InvalidInput);
  EXPECT_THROW(static_cast<void>(simplify({}, {.maxTriangles = 10})), InvalidInput);
}

}  // namespace
}  // namespace vantage
