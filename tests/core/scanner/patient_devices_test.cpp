#include "scanner/patient_devices.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/stuck_devices.h"

namespace vantage {
namespace {

using std::chrono::milliseconds;
using testing::soon;
using testing::Stuck;
using testing::StuckSensor;
using testing::StuckTable;

constexpr std::chrono::hours kForEver{1};

Rig stuckRig(const std::shared_ptr<Stuck>& stuck, milliseconds patience) {
  return withPatience({std::make_shared<StuckSensor>(stuck), std::make_shared<StuckTable>(stuck)}, patience);
}

// Either device of a rig, as something that takes time.
struct Use {
  const char* name;
  const char* identity;
  void (*use)(const Rig& rig, const Progress& progress);
  const Device& (*device)(const Rig& rig);
};

class PatientDevices : public ::testing::TestWithParam<Use> {
 protected:
  void use(const Rig& rig, const Progress& progress = {}) const { GetParam().use(rig, progress); }

  // What the use of a rig fails with.
  [[nodiscard]] std::string complaint(const Rig& rig) const {
    try {
      use(rig);
    } catch (const DeviceError& e) {
      return e.what();
    }
    return {};
  }

  [[nodiscard]] static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  const std::shared_ptr<Stuck> stuck_ = std::make_shared<Stuck>();
};

INSTANTIATE_TEST_SUITE_P(
    Kinds, PatientDevices,
    ::testing::Values(Use{"Sensor", "stuck sensor",
                          [](const Rig& rig, const Progress& p) { static_cast<void>(rig.sensor->capture(p)); },
                          [](const Rig& rig) -> const Device& { return *rig.sensor; }},
                      Use{"Positioner", "stuck table",
                          [](const Rig& rig, const Progress& p) { static_cast<void>(rig.positioner->moveTo(7, p)); },
                          [](const Rig& rig) -> const Device& { return *rig.positioner; }}),
    [](const auto& kind) { return kind.param.name; });

TEST_P(PatientDevices, AreGivenUpWhenTheyShowNoSignOfLife) {
  const Rig rig = stuckRig(stuck_, milliseconds(100));
  const std::string complaint = this->complaint(rig);
  EXPECT_TRUE(has(complaint, GetParam().identity)) << complaint;
  EXPECT_TRUE(has(complaint, "not answered for 0.1 s")) << complaint;
  stuck_->go = true;
}

TEST_P(PatientDevices, AreNotUsedAgainBeforeTheyHaveComeBack) {
  const Rig rig = stuckRig(stuck_, milliseconds(50));
  static_cast<void>(complaint(rig));
  EXPECT_TRUE(has(complaint(rig), "not come back"));
  const Device& device = GetParam().device(rig);
  ASSERT_TRUE(device.notReady());
  EXPECT_TRUE(has(*device.notReady(), "not come back"));
  EXPECT_FALSE(rig.positioner->where());
  stuck_->go = true;
  ASSERT_TRUE(soon([&] { return !device.notReady(); }));
  EXPECT_NO_THROW(use(rig));
}

TEST_P(PatientDevices, AreWaitedForAsLongAsTheyShowProgress) {
  stuck_->alive = true;
  const Rig rig = stuckRig(stuck_, milliseconds(500));
  std::jthread later([&] {
    std::this_thread::sleep_for(milliseconds(1200));
    stuck_->go = true;
  });
  EXPECT_NO_THROW(use(rig));
}

// Who listens to the stop that comes with giving up must not look like a stop of the operator.
TEST_P(PatientDevices, AreGivenUpWithAMessageAlsoWhenTheyOnlyListen) {
  stuck_->listens = true;
  const Rig rig = stuckRig(stuck_, milliseconds(50));
  EXPECT_TRUE(has(complaint(rig), "not answered"));
  EXPECT_TRUE(soon([&] { return !GetParam().device(rig).notReady(); }));
}

TEST_P(PatientDevices, AreCancelledSoonEvenWhenTheyDoNotListen) {
  const Rig rig = stuckRig(stuck_, kForEver);
  std::stop_source stop;
  std::jthread later([&] { stop.request_stop(); });
  EXPECT_THROW(use(rig, Progress({}, stop.get_token(), 1)), Cancelled);
  stuck_->go = true;
}

TEST_P(PatientDevices, DoNotHoldWhoLeavesAndGoWhenTheyComeBack) {
  {
    const Rig rig = stuckRig(stuck_, milliseconds(50));
    static_cast<void>(complaint(rig));
  }
  // The other one, which does not hang, is gone at once.
  EXPECT_TRUE(soon([&] { return stuck_->gone == 1; }));
  stuck_->go = true;
  EXPECT_TRUE(soon([&] { return stuck_->gone == 2; }));
}

TEST_P(PatientDevices, HandOnWhatTheDeviceSays) {
  stuck_->go = true;
  const Rig rig = stuckRig(stuck_, kForEver);
  EXPECT_EQ(GetParam().device(rig).identity(), GetParam().identity);
  use(rig);
  if (rig.positioner->where()) {
    EXPECT_EQ(rig.positioner->where()->position, 7);
    EXPECT_EQ(rig.positioner->where()->knownBy, PoseSource::Reported);
  }
}

TEST(PatientRig, IsLeftThoughItsDevicesDoNotClose) {
  const auto stuck = std::make_shared<Stuck>();
  stuck->inClose = true;
  const auto begin = std::chrono::steady_clock::now();
  { const Rig rig = stuckRig(stuck, kForEver); }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_EQ(stuck->gone, 0);
  stuck->go = true;
  EXPECT_TRUE(soon([&] { return stuck->gone == 2; }));
}

TEST(Patience, BringsTheErrorsOfTheDevice) {
  Patience patience("laser", kForEver);
  try {
    patience.run("warming up", [](const Progress&) { throw DeviceError("laser: no light"); }, {});
    FAIL() << "it went well";
  } catch (const DeviceError& e) {
    EXPECT_STREQ(e.what(), "laser: no light");
  }
  EXPECT_FALSE(patience.hanging());
  EXPECT_EQ(patience.call<int>("counting", [](const Progress&) { return 3; }, {}), 3);
}

}  // namespace
}  // namespace vantage
