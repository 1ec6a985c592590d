#include "devices/standing_object.h"

#include <gtest/gtest.h>

#include "scanner/simulated_stand.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

TEST(StandingObject, ASimulatedOneIsTurnedOverWithItsStand) {
  const auto mesh = std::make_shared<const Mesh>(testing::smallObject());
  const Simulated devices{mesh, testing::smallProfile(), {3, true}, {}};
  AcquisitionState state;
  EXPECT_EQ(std::get<Simulated>(withObjectAsItStands(devices, state)).object, mesh);
  state.stands.push_back({{}, Vec3::UnitX()});
  const auto turned = std::get<Simulated>(withObjectAsItStands(devices, state)).object;
  const Pose T_table_object = simulatedStand(*mesh, Vec3::UnitX(), 1, 3);
  ASSERT_EQ(turned->vertices.size(), mesh->vertices.size());
  EXPECT_LT((turned->vertices[0] - T_table_object * mesh->vertices[0]).norm(), 1e-9);
}

// A side that was told after the object was known by another stand is one in the coordinates of that stand's table.
TEST(StandingObject, SidesAreOfTheStandThatWasTheReference) {
  const auto mesh = std::make_shared<const Mesh>(testing::smallObject());
  const Simulated devices{mesh, testing::smallProfile(), {3, true}, {}};
  const Pose T_table1_object = simulatedStand(*mesh, Vec3::UnitX(), 1, 3);
  AcquisitionState state;
  state.stands.push_back({{}, Vec3::UnitX()});
  state.stands.push_back({{}, Vec3(T_table1_object.linear() * Vec3::UnitY()), nullptr, 1});
  const auto turned = std::get<Simulated>(withObjectAsItStands(devices, state)).object;
  const Pose T_table2_object = simulatedStand(*mesh, Vec3::UnitY(), 2, 3);
  EXPECT_LT((turned->vertices[0] - T_table2_object * mesh->vertices[0]).norm(), 1e-9);
}

}  // namespace
}  // namespace vantage
