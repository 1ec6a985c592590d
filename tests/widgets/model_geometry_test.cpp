#include "layers/model_geometry.h"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include "support/meshes.h"

namespace vantage {
namespace {

std::shared_ptr<const Model> sphereModel(double radius, int rings) {
  auto model = std::make_shared<Model>();
  model->mesh = testing::makeSphere(radius, rings);
  model->vertexView.assign(model->mesh.vertices.size(), 0);
  model->confidence.assign(model->mesh.vertices.size(), 1.0F);
  model->triangleView.assign(model->mesh.triangles.size(), 0);
  return model;
}

TEST(StandIn, IsLeftOutForASmallModel) {
  const auto geometry = prepareModelGeometry(sphereModel(50.0, 20));
  EXPECT_EQ(withStandIn(geometry), geometry);
}

TEST(StandIn, HasAboutAsManyTrianglesAsWantedAndOnlyVerticesOfTheModel) {
  const auto model = sphereModel(50.0, 120);
  StandInOptions options;
  options.mostTriangles = 1000;
  options.targetTriangles = 3000;
  ASSERT_GT(model->mesh.triangles.size(), 4 * options.targetTriangles);
  const auto geometry = withStandIn(prepareModelGeometry(model), options);
  ASSERT_NE(geometry->coarse, nullptr);
  const auto triangles = static_cast<std::size_t>(geometry->coarse->GetNumberOfCells());
  EXPECT_GT(triangles, options.targetTriangles / 2);
  EXPECT_LT(triangles, options.targetTriangles * 2);
  ASSERT_EQ(geometry->coarseVertex.size(), static_cast<std::size_t>(geometry->coarse->GetNumberOfPoints()));
  for (std::size_t i = 0; i < geometry->coarseVertex.size(); ++i) {
    const double* p = geometry->coarse->GetPoint(static_cast<vtkIdType>(i));
    const Vec3& origin = model->mesh.vertices[geometry->coarseVertex[i]];
    // The picture keeps single precision: 50 mm to 4e-6 mm.
    EXPECT_LT((Vec3(p[0], p[1], p[2]) - origin).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace vantage
