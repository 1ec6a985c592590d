#include "support/sample_objects/sample_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "geometry/measures.h"
#include "io/mesh_reader.h"
#include "io/placement.h"
#include "support/sample_objects/polygonize.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::polygonize;

struct Shipped {
  const char* name;
  double (*field)(const Vec3&);
  Vec3 size;  // of the bounding box [mm]
};

class SampleObject : public ::testing::TestWithParam<Shipped> {
 protected:
  SampleObject() : loaded_(loadMesh((testing::sourceFolder() / "resources" / "objects" / GetParam().name).string())) {}
  LoadedMesh loaded_;
};

TEST_P(SampleObject, IsOneClosedManifoldThatNeedsNoRepair) {
  const MeshMeasures m = measure(loaded_.mesh);
  EXPECT_TRUE(loaded_.repair.nothing()) << describe(loaded_.repair);
  EXPECT_EQ(m.boundaryEdges, 0U);
  EXPECT_EQ(m.nonManifoldEdges, 0U);
  EXPECT_EQ(m.components, 1U);
}

TEST_P(SampleObject, StandsOnTheTableAboutTheAxis) {
  const BoundingBox box = boundingBox(loaded_.mesh);
  EXPECT_EQ(box.min.z(), 0.0);
  EXPECT_LT(box.centre().head<2>().norm(), 1.0);
  EXPECT_LT((box.size() - GetParam().size).cwiseAbs().maxCoeff(), 1.0) << box.size().transpose();
  EXPECT_TRUE(isInside(loaded_.mesh, ViewingVolume{100.0, 160.0}, 0.0));
}

TEST_P(SampleObject, HasTheSurfaceThatTheProgramDescribes) {
  double worst = 0.0;
  for (const Vec3& v : loaded_.mesh.vertices) worst = std::max(worst, std::abs(GetParam().field(v)));
  // Sharp edges are cut off by about a grid cell's fraction.
  EXPECT_LT(worst, 0.35);
  for (std::size_t t = 0; t < loaded_.mesh.triangles.size(); t += 50) {
    const Triangle& triangle = loaded_.mesh.triangles[t];
    if (triangleArea(loaded_.mesh, triangle) < 0.05) continue;
    const Vec3 centre = triangleCentre(loaded_.mesh, triangle);
    const Vec3 step = 0.2 * triangleNormal(loaded_.mesh, triangle);
    EXPECT_GT(GetParam().field(centre + step), GetParam().field(centre - step))
        << "inside out at " << centre.transpose();
  }
}

TEST_P(SampleObject, IsSmallEnoughToShip) {
  EXPECT_LT(std::filesystem::file_size(testing::sourceFolder() / "resources" / "objects" / GetParam().name),
            1'500'000U);
}

INSTANTIATE_TEST_SUITE_P(Objects, SampleObject,
                         ::testing::Values(Shipped{"mug.ply", testing::mug, {109, 80, 95}},
                                           Shipped{"handset.ply", testing::handset, {190, 52, 46}},
                                           Shipped{"candle_holder.ply", testing::candleHolder, {113, 95, 150}}),
                         [](const auto& object) {
                           return std::string(object.param.name).substr(0, std::string(object.param.name).find('.'));
                         });

double sphereField(const Vec3& p) {
  return p.norm() - 5.0;
}

TEST(Polygonize, MakesAClosedSphereTurnedOutward) {
  const Mesh mesh = polygonize(sphereField, {{-6, -6, -6}, {6, 6, 6}}, 0.5);
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.boundaryEdges + m.nonManifoldEdges, 0U);
  EXPECT_EQ(m.components, 1U);
  EXPECT_NEAR(m.area, 100.0 * kPi, 2.0);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(areaVector(mesh, t).dot(triangleCentre(mesh, t)), 0.0);
}

TEST(Polygonize, FlatTrianglesAreFlippedAwayWithoutOpeningTheMesh) {
  // A tetrahedron with one side split at its middle: both halves of the neighbour meet in a triangle without an area.
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}};
  ASSERT_EQ(measure(mesh).boundaryEdges, 0U);
  testing::flipFlatTriangles(mesh, 1e-6);
  const MeshMeasures m = measure(mesh);
  EXPECT_EQ(m.boundaryEdges + m.nonManifoldEdges, 0U);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(triangleArea(mesh, t), 0.1);
}

}  // namespace
}  // namespace vantage
