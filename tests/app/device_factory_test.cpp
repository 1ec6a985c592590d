#include "devices/device_factory.h"

#include <gtest/gtest.h>

#include <bit>

#include "base/errors.h"
#include "support/scenes/small_scene.h"
#include "support/stuck_devices.h"

namespace vantage {
namespace {

using testing::Stuck;
using testing::StuckSensor;
using testing::StuckTable;

Simulated simulatedSetUp() {
  return {std::make_shared<const Mesh>(testing::smallObject()), testing::smallProfile(), {.seed = 5}};
}

std::vector<std::uint32_t> bytes(const RangeImage& image) {
  std::vector<std::uint32_t> result;
  for (const float r : image.range) result.push_back(std::bit_cast<std::uint32_t>(r));
  return result;
}

TEST(DeviceFactory, MakesTheSimulationThatGoesOnWithTheSession) {
  const Simulated setUp = simulatedSetUp();
  const Rig rig = DeviceFactory().open(setUp, 0, {});
  const Rig bare = testing::simulation(*setUp.object, setUp.profile, setUp.options);
  for (const int position : {0, 4, 9})
    EXPECT_EQ(bytes(scanFrom(rig, position, {})), bytes(scanFrom(bare, position, {}))) << "position " << position;
  const Rig resumed = DeviceFactory().open(setUp, 3, {});
  EXPECT_EQ(bytes(scanFrom(resumed, 2, {})), bytes(scanFrom(bare, 2, {})));
}

TEST(DeviceFactory, GivesUpWhatItHandsOutWhenThatHangs) {
  const auto stuck = std::make_shared<Stuck>();
  const auto simulated = makeDevices(simulatedSetUp(), 0);
  const Rig hangings[] = {{std::make_shared<StuckSensor>(stuck), simulated.positioner},
                          {simulated.sensor, std::make_shared<StuckTable>(stuck)}};
  for (const Rig& hanging : hangings) {
    const DeviceFactory factory(std::chrono::seconds(1), [&](const DeviceSetUp&, std::int64_t) { return hanging; });
    const Rig rig = factory.open(simulatedSetUp(), 0, {});
    try {
      static_cast<void>(scanFrom(rig, 0, {}));
      FAIL() << "a device that hangs has scanned";
    } catch (const DeviceError& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with("stuck")) << e.what();
    }
  }
  stuck->go = true;
}

}  // namespace
}  // namespace vantage
