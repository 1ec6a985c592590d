#include "geometry/mesh.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeGrid;
using testing::makeSphere;

Mesh rightTriangle() {
  return {{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 4, 0)}, {{0, 1, 2}}};
}

TEST(Mesh, TriangleMeasuresByHand) {
  const Mesh mesh = rightTriangle();
  const Triangle& t = mesh.triangles[0];
  EXPECT_EQ(areaVector(mesh, t), Vec3(0, 0, 12));
  EXPECT_EQ(triangleNormal(mesh, t), Vec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(triangleArea(mesh, t), 6.0);
  EXPECT_TRUE(triangleCentre(mesh, t).isApprox(Vec3(1, 4.0 / 3.0, 0)));
}

TEST(Mesh, ADegenerateTriangleHasNoNormal) {
  const Mesh mesh{{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)}, {{0, 1, 2}}};
  EXPECT_EQ(triangleNormal(mesh, mesh.triangles[0]), Vec3(0, 0, 0));
}

TEST(Mesh, VertexNormalsOfASpherePointOutward) {
  const Vec3 centre(1, 2, 3);
  const Mesh mesh = makeSphere(10.0, 24, centre);
  const auto normals = computeVertexNormals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v) EXPECT_GT(normals[v].dot((mesh.vertices[v] - centre) / 10.0), 0.99);
}

TEST(Mesh, IsolatedVerticesHaveNoNormal) {
  Mesh mesh = rightTriangle();
  mesh.vertices.emplace_back(9, 9, 9);
  EXPECT_EQ(computeVertexNormals(mesh).back(), Vec3(0, 0, 0));
}

TEST(Mesh, TransformedMovesVerticesAndKeepsTriangles) {
  Pose T_target_mesh = Pose::Identity();
  T_target_mesh.translate(Vec3(10, 0, 0));
  T_target_mesh.rotate(Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()));
  const Mesh moved = transformed(rightTriangle(), T_target_mesh);
  EXPECT_TRUE(moved.vertices[1].isApprox(Vec3(10, 3, 0)));
  EXPECT_TRUE(moved.vertices[2].isApprox(Vec3(6, 0, 0)));
  EXPECT_EQ(moved.triangles, rightTriangle().triangles);
}

TEST(Mesh, RemoveUnusedVerticesKeepsTheOrder) {
  Mesh mesh{{Vec3(0, 0, 0), Vec3(9, 9, 9), Vec3(1, 0, 0), Vec3(8, 8, 8), Vec3(0, 1, 0)}, {{4, 0, 2}}};
  const auto newIndex = removeUnusedVertices(mesh);
  EXPECT_EQ(newIndex, (std::vector<std::uint32_t>{0, kNoIndex, 1, kNoIndex, 2}));
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}));
  EXPECT_EQ(mesh.triangles[0], (Triangle{2, 0, 1}));
}

TEST(Mesh, ValidateNamesTriangleVertexAndLimit) {
  EXPECT_NO_THROW(validate(makeGrid(2, 2, 1.0)));
  Mesh mesh = rightTriangle();
  mesh.triangles.push_back({0, 3, 1});
  try {
    validate(mesh);
    FAIL() << "the index out of range was accepted";
  } catch (const InvalidInput& e) {
    EXPECT_STREQ(e.what(), "triangle 1 names vertex 3 of a mesh with 3 vertices");
  }
}

TEST(SmallMotion, RotatesAboutItsVectorAndThenTranslates) {
  Vec6 x;
  x << 0, 0, kPi / 2, 5, 6, 7;
  EXPECT_TRUE((smallMotion(x) * Vec3(1, 0, 0)).isApprox(Vec3(5, 7, 7)));
  EXPECT_TRUE(smallMotion(Vec6::Zero()).isApprox(Pose::Identity()));
}

}  // namespace
}  // namespace vantage
