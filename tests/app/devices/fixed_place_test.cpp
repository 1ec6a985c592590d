#include "devices/fixed_place.h"

#include <gtest/gtest.h>

#include <string>

namespace vantage {
namespace {

TEST(FixedPlace, StandsAtTheFirstPositionAndRefusesAllOthers) {
  ScannerProfile profile;
  profile.workspace = turntable(4);
  FixedPlace place(std::make_shared<const ScannerProfile>(profile));
  place.open({});
  EXPECT_FALSE(place.notReady());
  const ReachedPose reached = place.moveTo(0, {});
  EXPECT_EQ(reached.position, 0);
  EXPECT_EQ(reached.T_table_scanner.matrix(), profile.workspace.poses[0].matrix());
  EXPECT_EQ(reached.knownBy, PoseSource::Commanded);
  EXPECT_FALSE(reached.uncertainty);
  try {
    static_cast<void>(place.moveTo(1, {}));
    FAIL() << "something moved";
  } catch (const DeviceError& e) {
    EXPECT_NE(std::string(e.what()).find("position 1"), std::string::npos) << e.what();
  }
  ASSERT_TRUE(place.where());
  EXPECT_EQ(place.where()->position, 0);
}

}  // namespace
}  // namespace vantage
