#include "scanner/hand_table.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

std::shared_ptr<const ScannerProfile> fourPositions() {
  ScannerProfile profile;
  profile.workspace = turntable(4);
  return std::make_shared<const ScannerProfile>(profile);
}

TEST(HandTable, AsksThePersonAndReportsWhatTheyConfirmed) {
  std::vector<int> asked;
  const auto profile = fourPositions();
  HandTable table(
      profile, [&](int position, const Progress&) { asked.push_back(position); }, Mechanics{0.02, 1.5});
  const ReachedPose reached = table.moveTo(3, {});
  EXPECT_EQ(asked, std::vector<int>{3});
  EXPECT_EQ(reached.position, 3);
  EXPECT_EQ(reached.knownBy, PoseSource::ByHand);
  EXPECT_EQ(reached.T_table_scanner.matrix(), profile->workspace.poses[3].matrix());
  ASSERT_TRUE(reached.uncertainty);
  EXPECT_EQ(reached.uncertainty->positionSigma, 1.5);
}

TEST(HandTable, WaitsUntilThePersonIsDoneOrTheOperatorStops) {
  std::stop_source stop;
  int waited = 0;
  HandTable table(fourPositions(), [&](int, const Progress& progress) {
    for (;; ++waited) {
      if (waited == 3) stop.request_stop();
      progress.checkpoint(0.0);
    }
  });
  EXPECT_THROW(static_cast<void>(table.moveTo(1, Progress({}, stop.get_token(), 1))), Cancelled);
  EXPECT_EQ(waited, 3);
}

TEST(HandTable, DoesNotBelieveToStandAnywhereAfterATurnThatWasNotConfirmed) {
  bool able = true;
  HandTable table(fourPositions(), [&](int, const Progress&) {
    if (!able) throw DeviceError("the table is stuck");
  });
  static_cast<void>(table.moveTo(1, {}));
  ASSERT_TRUE(table.where());
  able = false;
  EXPECT_THROW(static_cast<void>(table.moveTo(2, {})), DeviceError);
  EXPECT_FALSE(table.where());
}

TEST(HandTable, AsksNobodyForAPositionThatDoesNotExist) {
  int asked = 0;
  HandTable table(fourPositions(), [&](int, const Progress&) { ++asked; });
  EXPECT_THROW(static_cast<void>(table.moveTo(4, {})), DeviceError);
  EXPECT_EQ(asked, 0);
}

}  // namespace
}  // namespace vantage
