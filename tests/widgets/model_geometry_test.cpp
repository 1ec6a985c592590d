#include "layers/model_geometry.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "acquisition/memory_journal.h"
#include "acquisition/model_colours.h"
#include "support/coloured_scan.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

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

// Colours of the points as they are drawn.
std::vector<Rgb> drawnColours(vtkPolyData& data) {
  std::vector<Rgb> colours;
  auto* scalars = vtkUnsignedCharArray::SafeDownCast(data.GetPointData()->GetScalars());
  for (vtkIdType i = 0; scalars != nullptr && i < scalars->GetNumberOfTuples(); ++i)
    colours.push_back({scalars->GetValue(3 * i), scalars->GetValue(3 * i + 1), scalars->GetValue(3 * i + 2)});
  return colours;
}

// Two scans of the small object, taken together as one model.
AcquisitionState paintedState(bool coloured) {
  const Rig rig = testing::simulation(testing::smallObject(), testing::smallProfile(), {1, true});
  std::vector<RangeImage> images;
  for (const int position : {0, 2}) {
    RangeImage image = scanFrom(rig, position, {});
    image.station.position.reset();
    image.poseKnownBy = PoseSource::Reported;
    images.push_back(coloured ? testing::painted(std::move(image)) : std::move(image));
  }
  MemoryJournal journal(nullptr, {});
  Acquisition(journal).importScans(std::move(images));
  return *journal.state();
}

TEST(ModelGeometry, IsShownInItsColoursWhereItHasSomeUnlessSomethingElseIsAskedFor) {
  ModelGeometry geometry;
  EXPECT_EQ(geometry.shown({}), ModelColouring::Plain);
  EXPECT_EQ(geometry.shown(ModelColouring::Colours), ModelColouring::Plain);
  EXPECT_EQ(geometry.shown(ModelColouring::Age), ModelColouring::Age);
  geometry.colours.emplace_back(Colour{1, 2, 3});
  EXPECT_EQ(geometry.shown({}), ModelColouring::Colours);
  EXPECT_EQ(geometry.shown(ModelColouring::Colours), ModelColouring::Colours);
  EXPECT_EQ(geometry.shown(ModelColouring::Plain), ModelColouring::Plain);
}

TEST(ModelGeometry, DrawsTheStandThatShowedTheSurfaceFirst) {
  auto model = std::make_shared<Model>(*sphereModel(50.0, 120));
  for (std::size_t v = 0; v < model->vertexView.size(); ++v) model->vertexView[v] = v % 3;
  for (std::size_t t = 0; t < model->triangleView.size(); ++t) model->triangleView[t] = t % 3;
  const auto geometry = withStandIn(prepareModelGeometry(model), {1000, 3000});
  ASSERT_NE(geometry->coarse, nullptr);
  const std::vector<int> stands{0, 0, 2};
  const auto drawn = geometry->coloured(ModelColouring::Stand, stands);
  const auto* cells = vtkUnsignedCharArray::SafeDownCast(drawn->GetCellData()->GetScalars());
  ASSERT_NE(cells, nullptr);
  for (int t = 0; t < 6; ++t) EXPECT_EQ(cells->GetTypedComponent(t, 0), standColour(stands[t % 3])[0]) << t;
  const std::vector<Rgb> coarse = drawnColours(*geometry->colouredCoarse(ModelColouring::Stand, stands));
  ASSERT_EQ(coarse.size(), geometry->coarseVertex.size());
  for (std::size_t i = 0; i < coarse.size(); ++i)
    EXPECT_EQ(coarse[i], standColour(stands[model->vertexView[geometry->coarseVertex[i]]]));
  EXPECT_NE(standColour(0), standColour(2));
}

TEST(ModelGeometry, DrawsColoursAndGreyWhereThereIsNone) {
  const auto model = sphereModel(50.0, 120);
  StandInOptions options;
  options.mostTriangles = 1000;
  options.targetTriangles = 3000;
  ModelGeometry geometry = *withStandIn(prepareModelGeometry(model), options);
  std::vector<Rgb> expected;
  for (std::size_t v = 0; v < model->mesh.vertices.size(); ++v) {
    const Colour colour{static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(v / 256), 3};
    geometry.colours.push_back(v % 5 == 0 ? std::nullopt : std::optional(colour));
    expected.push_back(v % 5 == 0 ? kGrey : colour);
  }
  EXPECT_EQ(drawnColours(*geometry.coloured(ModelColouring::Colours, {})), expected);
  const std::vector<Rgb> coarse = drawnColours(*geometry.colouredCoarse(ModelColouring::Colours, {}));
  ASSERT_EQ(coarse.size(), geometry.coarseVertex.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_EQ(coarse[i], expected[geometry.coarseVertex[i]]);
}

TEST(ModelGeometry, HasTheColoursOfItsScans) {
  const AcquisitionState painted = paintedState(true);
  const auto geometry = prepareGeometryOf(painted);
  EXPECT_EQ(geometry->colours.size(), painted.model->mesh.vertices.size());
  EXPECT_EQ(geometry->colours, coloursOf(painted));
  EXPECT_NE(geometry->caster, nullptr);
  const AcquisitionState plain = paintedState(false);
  EXPECT_TRUE(prepareGeometryOf(plain)->colours.empty());
  const auto surface = prepareSurface(plain.model);
  EXPECT_EQ(withColours(surface, plain), surface);
  EXPECT_EQ(prepareGeometryOf({}), nullptr);
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
