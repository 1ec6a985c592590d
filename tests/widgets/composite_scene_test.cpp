#include "scenes/composite_scene.h"

#include <gtest/gtest.h>

#include "layers/composite_layer.h"
#include "layers/marker_layer.h"
#include "scenes/ray_picture.h"
#include "support/meshes.h"

namespace vantage {
namespace {

std::shared_ptr<const ModelGeometry> ballAt(const Vec3& centre) {
  auto model = std::make_shared<Model>();
  model->mesh = testing::makeSphere(10.0, 24, centre);
  return prepareModelGeometry(model);
}

SightLine downAt(double x, double y) {
  return {Vec3(x, y, 500.0), -Vec3::UnitZ()};
}

TEST(CompositeScene, IsPickedWhereALineMeetsASurfaceFirst) {
  CompositeScene scene;
  EXPECT_TRUE(scene.isEmpty());
  EXPECT_FALSE(scene.pick(downAt(0, 0)));
  scene.set(ballAt(Vec3::Zero()), ballAt(Vec3::Zero()));
  Pose up = Pose::Identity();
  up.translate(Vec3(40, 0, 30));
  scene.setPose(up, nullptr);
  EXPECT_NEAR(scene.pick(downAt(0, 0)).value().z(), 10.0, 0.1);
  EXPECT_NEAR(scene.pick(downAt(40, 0)).value().z(), 40.0, 0.1);
  EXPECT_FALSE(scene.pick(downAt(0, 30)));
}

// Places on a stand alone are those of its own coordinates, wherever it was last over the object.
TEST(CompositeScene, ShowsOneAloneInItsOwnCoordinates) {
  CompositeScene scene;
  scene.set(nullptr, ballAt(Vec3(5, 0, 0)));
  EXPECT_NEAR(scene.pick(downAt(5, 0)).value().z(), 10.0, 0.1);
  EXPECT_TRUE(scene.overlay().legends.empty());
  EXPECT_NEAR(scene.box().centre().x(), 5.0, 1e-6);
}

TEST(CompositeScene, HasBothInSight) {
  CompositeScene scene;
  scene.set(ballAt(Vec3::Zero()), ballAt(Vec3::Zero()));
  Pose aside = Pose::Identity();
  aside.translate(Vec3(100, 0, 0));
  scene.setPose(aside, nullptr);
  EXPECT_NEAR(scene.box().max.x(), 110.0, 0.5);
  EXPECT_NEAR(scene.box().min.x(), -10.0, 0.5);
  scene.setTitle(QStringLiteral("Pose 1"));
  EXPECT_EQ(scene.overlay().notes, QStringList{"Pose 1"});
  EXPECT_EQ(std::get<KeyLegend>(scene.overlay().legends.at(0)).entries.size(), 5U);
}

TEST(CompositeLayer, HasAColourForWhatSpeaksForAndAgainst) {
  EXPECT_FALSE(placeColour(PlaceWord::Nothing));
  EXPECT_EQ(placeColour(PlaceWord::Conflict), placeColour(PlaceWord::Table));
  EXPECT_NE(placeColour(PlaceWord::OnIt), placeColour(PlaceWord::Conflict));
  EXPECT_NE(placeColour(PlaceWord::Missing), placeColour(PlaceWord::Conflict));
}

TEST(RayPicture, ShowsTheNearestSurfaceAndTheBackgroundBeside) {
  const RayCaster ball(testing::makeSphere(10.0, 24));
  Pose nearer = Pose::Identity();
  nearer.translate(Vec3(30, 0, 0));
  const auto plain = [](const Rgb& colour) { return [colour](std::uint32_t) { return colour; }; };
  const std::vector<PicturedSurface> surfaces{{&ball, Pose::Identity(), plain({255, 0, 0})},
                                              {&ball, nearer, plain({0, 255, 0})}};
  const Camera camera = cameraToward(-Vec3::UnitX(), {Vec3(-10, -20, -20), Vec3(10, 20, 20)}, 1.0);
  const QImage image = rayPicture(surfaces, camera, {40, 40}, lightTheme());
  ASSERT_EQ(image.size(), QSize(40, 40));
  EXPECT_GT(qGreen(image.pixel(20, 20)), 60);
  EXPECT_EQ(qRed(image.pixel(20, 20)), 0);
  EXPECT_EQ(image.pixelColor(1, 1), lightTheme().backgroundTop);
  EXPECT_EQ(image, rayPicture(surfaces, camera, {40, 40}, lightTheme()));
  EXPECT_LE(MarkerLayer::kMost, 20U);
}

}  // namespace
}  // namespace vantage
