#include "devices/turned_by_hand.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/errors.h"
#include "devices/device_factory.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// The small object on a simulated table that a person says they turn.
Simulated byHand(HandTable::AskPerson ask) {
  return {std::make_shared<const Mesh>(testing::smallObject()), testing::smallProfile(), {1, true}, std::move(ask)};
}

TEST(TurnedByHand, TurnsTheSimulatedTableAndSaysThatAPersonDid) {
  std::vector<int> asked;
  const Simulated setUp = byHand([&](int position, const Progress&) { asked.push_back(position); });
  const Rig rig = opened(makeDevices(setUp, 0));
  EXPECT_EQ(rig.positioner->identity(), "table turned by hand");
  EXPECT_FALSE(rig.positioner->where());
  const RangeImage image = scanFrom(rig, 5, {});
  EXPECT_EQ(asked, std::vector<int>{5});
  EXPECT_EQ(image.poseKnownBy, PoseSource::ByHand);
  ASSERT_TRUE(image.poseUncertainty);
  EXPECT_EQ(image.poseUncertainty->angleSigma, kTurnedByHand.angleSigma);
  EXPECT_EQ(image.T_table_scanner.matrix(), setUp.profile->workspace.poses[5].matrix());
  // The scan is what the table shows there when it turns by itself.
  const Rig itself = opened(makeDevices(byHand({}), 0));
  const RangeImage same = scanFrom(itself, 5, {});
  ASSERT_GT(same.sampleCount(), 0U);
  for (std::size_t i = 0; i < same.range.size(); ++i)
    ASSERT_TRUE(image.range[i] == same.range[i] || (!image.valid(i) && !same.valid(i))) << i;
}

TEST(TurnedByHand, StandsNowhereAfterATurnThatWasNotDone) {
  const Rig rig = opened(makeDevices(byHand([](int position, const Progress&) {
                                       if (position == 2) throw DeviceError("not today");
                                     }),
                                     0));
  static_cast<void>(rig.positioner->moveTo(1, {}));
  EXPECT_EQ(rig.positioner->where()->position, 1);
  EXPECT_THROW(static_cast<void>(rig.positioner->moveTo(2, {})), DeviceError);
  EXPECT_FALSE(rig.positioner->where());
}

}  // namespace
}  // namespace vantage
