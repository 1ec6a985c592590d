#include "rig_keeper.h"

#include <gtest/gtest.h>

#include "app/told_devices.h"

namespace vantage {
namespace {

class RigKeeperTest : public ::testing::Test {
 protected:
  testing::ToldDevices devices_;
  RigKeeper keeper_{devices_.factory()};
  std::shared_ptr<vantage::SetUp> setUp_ = testing::realSetUp();
};

TEST_F(RigKeeperTest, DevicesStayOpenFromOneUserToTheNext) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(keeper_.open(setUp_, 0, {}, {}).rig().table->identity(), "told table");
  auto cutsMore = std::make_shared<vantage::SetUp>(*setUp_);
  cutsMore->choice.settings.cut.isolated = true;
  EXPECT_TRUE(keeper_.open(cutsMore, 0, {}, {}).rig().sensor);
  EXPECT_EQ(devices_.made, 1);
}

TEST_F(RigKeeperTest, OtherDevicesAreOpenedAnew) {
  static_cast<void>(keeper_.open(setUp_, 0, {}, {}));
  auto elsewhere = std::make_shared<vantage::SetUp>(*setUp_);
  elsewhere->choice.rig.table = SerialTableDevice{"/dev/other", {}};
  EXPECT_FALSE(keeper_.lookAt(elsewhere));
  static_cast<void>(keeper_.open(elsewhere, 0, {}, {}));
  EXPECT_EQ(devices_.made, 2);
}

TEST_F(RigKeeperTest, DevicesThatFailedAreOpenedAnew) {
  {
    RigKeeper::Use use = keeper_.open(setUp_, 0, {}, {});
    use.drop();
  }
  EXPECT_FALSE(keeper_.lookAt(setUp_));
  static_cast<void>(keeper_.open(setUp_, 0, {}, {}));
  EXPECT_EQ(devices_.made, 2);
  devices_.table->problem = "has restarted";
  static_cast<void>(keeper_.open(setUp_, 0, {}, {}));
  EXPECT_EQ(devices_.made, 3);
}

TEST_F(RigKeeperTest, OneUserAtATime) {
  const RigKeeper::Use use = keeper_.open(setUp_, 0, {}, {});
  EXPECT_FALSE(keeper_.lookAt(setUp_));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(keeper_.open(setUp_, 0, {}, Progress({}, stop.get_token(), 1))), Cancelled);
}

TEST_F(RigKeeperTest, ATableStandsWhereTheSessionLeftIt) {
  const RigKeeper::Use use = keeper_.open(setUp_, 5, TableStand{6, 0.0, 0.0}, {});
  EXPECT_EQ(use.rig().positioner->moveTo(6, {}).position, 6);
  EXPECT_NEAR(devices_.table->counted, 0.0, 1e-9);
}

}  // namespace
}  // namespace vantage
