#include "rig_keeper.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// A sensor whose readiness the test decides.
class Switched final : public RangeSensor {
 public:
  explicit Switched(std::shared_ptr<bool> ready) : ready_(std::move(ready)) {}
  [[nodiscard]] std::string identity() const override { return "switched"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override {
    return *ready_ ? std::nullopt : std::optional<std::string>("switched off");
  }
  [[nodiscard]] RangeImage capture(const Progress& /*progress*/) override { return {}; }

 private:
  std::shared_ptr<bool> ready_;
};

SharedSetUp setUpOf(DeviceSetUp devices) {
  auto setUp = std::make_shared<SetUp>();
  setUp->devices = std::move(devices);
  return setUp;
}

// Keeps what devices are made of.
class RigKeeperTest : public ::testing::Test {
 protected:
  RigKeeper keeper() {
    return RigKeeper(DeviceFactory(std::chrono::minutes(1), [this](const DeviceSetUp& setUp, std::int64_t) {
      const auto* real = std::get_if<RealDevices>(&setUp);
      stoodAt_.push_back(real != nullptr ? real->standsAt : -1);
      ready_ = std::make_shared<bool>(true);
      Rig rig = makeDevices(simulated_, 0);
      rig.sensor = std::make_shared<Switched>(ready_);
      return rig;
    }));
  }

  Simulated simulated_{std::make_shared<const Mesh>(testing::smallObject()), testing::smallProfile(), {1, true}, {}};
  std::shared_ptr<bool> ready_;
  std::vector<int> stoodAt_;  // of every rig that was made; -1 for a simulated one
};

TEST_F(RigKeeperTest, RealDevicesStayOpenAndAreToldWhereTheTableStands) {
  RigKeeper rigs = keeper();
  const SharedSetUp setUp = setUpOf(RealDevices{});
  const Rig first = rigs.open(setUp, 0, 7, {});
  const Rig second = rigs.open(setUp, 1, 9, {});
  EXPECT_EQ(first.sensor, second.sensor);
  EXPECT_EQ(first.positioner, second.positioner);
  EXPECT_EQ(stoodAt_, std::vector<int>{7});
}

TEST_F(RigKeeperTest, TheyAreOpenedAnewWhenTheyCannotBeUsed) {
  RigKeeper rigs = keeper();
  const SharedSetUp setUp = setUpOf(RealDevices{});
  static_cast<void>(rigs.open(setUp, 0, 1, {}));
  *ready_ = false;
  static_cast<void>(rigs.open(setUp, 0, 2, {}));
  rigs.drop();
  static_cast<void>(rigs.open(setUp, 0, {}, {}));
  static_cast<void>(rigs.open(setUpOf(RealDevices{}), 0, 4, {}));
  EXPECT_EQ(stoodAt_, (std::vector<int>{1, 2, 0, 4}));
}

TEST_F(RigKeeperTest, SimulatedOnesAreMadeForEveryJob) {
  RigKeeper rigs = keeper();
  const SharedSetUp setUp = setUpOf(simulated_);
  static_cast<void>(rigs.open(setUp, 0, {}, {}));
  static_cast<void>(rigs.open(setUp, 3, {}, {}));
  EXPECT_EQ(stoodAt_, (std::vector<int>{-1, -1}));
}

}  // namespace
}  // namespace vantage
