#include "acquisition/stand.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition_state.h"
#include "acquisition/apply_command.h"
#include "acquisition/scan_placing.h"
#include "acquisition/stand_commands.h"
#include "acquisition/steps.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// On its side: a quarter turn about x, and 50 mm up.
Pose onItsSide() {
  Pose T_object_table = Pose::Identity();
  T_object_table.translate(Vec3(0.0, 0.0, 50.0));
  T_object_table.rotate(Eigen::AngleAxisd(radians(90.0), Vec3::UnitX()));
  return T_object_table;
}

AcquisitionState untouched() {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  return state;
}

TEST(Stand, IsNotKnownUntilSomebodySaysIt) {
  EXPECT_FALSE(Stand{}.T_object_table);
}

TEST(Stand, TheFirstIsTheObjectsOwnFrame) {
  const AcquisitionState state = untouched();
  ASSERT_EQ(state.stands.size(), 1U);
  ASSERT_TRUE(state.stands[0].T_object_table);
  EXPECT_EQ(state.stands[0].T_object_table->matrix(), Pose::Identity().matrix());
  EXPECT_EQ(poseOf(state, 5).matrix(), state.profile->workspace.poses[5].matrix());
}

TEST(Stand, TakesTheScannerAlongFromTableToObject) {
  AcquisitionState scanned = untouched();
  scanned.model = std::make_shared<const Model>();
  const AcquisitionState turned = applyCommand(scanned, TurnObject{onItsSide()}, {}, {});
  EXPECT_EQ(turned.stand(), 1);
  const Pose expected = onItsSide() * turned.profile->workspace.poses[7];
  EXPECT_TRUE(poseOf(turned, 7).isApprox(expected));
  RangeImage image;
  image.T_table_scanner = turned.profile->workspace.poses[7];
  image.station = {1, 7};
  EXPECT_TRUE(expectedPose(turned, image).isApprox(expected));
  image.station.stand = 0;
  EXPECT_TRUE(expectedPose(turned, image).isApprox(image.T_table_scanner));
}

TEST(Stand, IsPlacedLaterAsIfItHadBeenKnown) {
  AcquisitionState unknown = untouched();
  unknown.stands.emplace_back();
  const AcquisitionState placed = applyCommand(unknown, PlaceStand{1, onItsSide()}, {}, {});
  ASSERT_TRUE(placed.stands[1].T_object_table);
  EXPECT_TRUE(placed.stands[1].T_object_table->isApprox(onItsSide()));
  EXPECT_TRUE(placed.stands[0].T_object_table->isApprox(Pose::Identity()));
}

}  // namespace
}  // namespace vantage
