#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

#include "base/errors.h"
#include "scanner/hand_table.h"
#include "scanner/patient_devices.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"
#include "support/simulation.h"

// What holds for every positioner and every sensor, with errors and noise.

namespace vantage {
namespace {

std::shared_ptr<const ScannerProfile> smallScanner() {
  ScannerProfile profile;
  profile.rays = std::make_shared<const RayGrid>(makeRays(LinearStripe{Vec3(300, 0, 150), 40, 21, 21, 40}, {}));
  profile.minRange = 10.0;
  profile.maxRange = 1000.0;
  profile.workspace = turntable(4);
  profile.noise = {.rangeSigma = 0.1, .dropout = 0.0};
  profile.mechanics = {.angleSigma = radians(0.3), .positionSigma = 0.2};
  return std::make_shared<const ScannerProfile>(profile);
}

Mesh block() {
  return testing::makeBox(Vec3(-30, -60, 100), Vec3(40, 50, 200));
}

// A table that a person turns, who does what they are asked at once.
Rig turnedByHand() {
  Rig rig = testing::simulation(block(), smallScanner());
  const auto turn = [table = rig.positioner](int position, const Progress& progress) {
    static_cast<void>(table->moveTo(position, progress));
  };
  rig.positioner = std::make_shared<HandTable>(smallScanner(), turn);
  return rig;
}

struct Kind {
  const char* name;
  std::function<Rig()> make;
};

class EveryRig : public ::testing::TestWithParam<Kind> {
 protected:
  const Rig rig_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(
    Kinds, EveryRig,
    ::testing::Values(Kind{"Simulated", [] { return testing::simulation(block(), smallScanner()); }},
                      Kind{"ByHand", turnedByHand},
                      Kind{"Patient", [] { return withPatience(turnedByHand(), std::chrono::minutes(1)); }}),
    [](const auto& kind) { return kind.param.name; });

std::vector<std::uint32_t> bytes(const RangeImage& image) {
  std::vector<std::uint32_t> result;
  for (const float r : image.range) result.push_back(std::bit_cast<std::uint32_t>(r));
  return result;
}

TEST_P(EveryRig, IsKnownToStandWhereItMovedTo) {
  EXPECT_FALSE(rig_.positioner->where());
  for (const int position : {2, 0, 0, 3}) {
    const ReachedPose reached = rig_.positioner->moveTo(position, {});
    EXPECT_EQ(reached.position, position);
    EXPECT_NE(reached.knownBy, PoseSource::Unknown);
    const auto where = rig_.positioner->where();
    ASSERT_TRUE(where);
    EXPECT_EQ(where->position, position);
    EXPECT_EQ(where->T_table_scanner.matrix(), reached.T_table_scanner.matrix());
    EXPECT_EQ(where->knownBy, reached.knownBy);
  }
}

TEST_P(EveryRig, RefusesAPositionThatTheWorkspaceDoesNotHave) {
  static_cast<void>(rig_.positioner->moveTo(1, {}));
  for (const int position : {-1, 4}) {
    try {
      static_cast<void>(rig_.positioner->moveTo(position, {}));
      FAIL() << "moved to position " << position;
    } catch (const DeviceError& e) {
      const std::string message = e.what();
      EXPECT_TRUE(message.starts_with(rig_.positioner->identity())) << message;
      EXPECT_NE(message.find("position " + std::to_string(position)), std::string::npos) << message;
    }
    EXPECT_EQ(rig_.positioner->where()->position, 1);
  }
}

TEST_P(EveryRig, CapturingMovesNothing) {
  static_cast<void>(rig_.positioner->moveTo(1, {}));
  const Pose before = rig_.positioner->where()->T_table_scanner;
  static_cast<void>(rig_.sensor->capture({}));
  EXPECT_EQ(rig_.positioner->where()->position, 1);
  EXPECT_EQ(rig_.positioner->where()->T_table_scanner.matrix(), before.matrix());
}

// The limit is five standard errors of the mean square of the difference of two normal samples.
TEST_P(EveryRig, TwoCapturesAtTheSamePlaceDifferByNoiseOnly) {
  static_cast<void>(scanFrom(rig_, 0, {}));
  static_cast<void>(rig_.positioner->moveTo(0, {}));
  const RangeImage a = rig_.sensor->capture({});
  const RangeImage b = rig_.sensor->capture({});
  ASSERT_EQ(a.sampleCount(), a.range.size());
  ASSERT_EQ(b.sampleCount(), b.range.size());
  EXPECT_NE(bytes(a), bytes(b));
  const auto n = static_cast<double>(a.range.size());
  double square = 0.0;
  for (std::size_t i = 0; i < a.range.size(); ++i) square += std::pow(a.range[i] - b.range[i], 2) / n;
  EXPECT_NEAR(square, 2.0 * 0.1 * 0.1, 5.0 * std::sqrt(2.0 / n) * 2.0 * 0.1 * 0.1);
}

TEST_P(EveryRig, ACaptureIsInScannerCoordinatesAndSaysNothingOfItsPlace) {
  static_cast<void>(rig_.positioner->moveTo(3, {}));
  const RangeImage image = rig_.sensor->capture({});
  EXPECT_FALSE(image.station.position);
  EXPECT_EQ(image.T_table_scanner.matrix(), Pose::Identity().matrix());
}

TEST_P(EveryRig, AScanCarriesThePoseThatWasReached) {
  const RangeImage image = scanFrom(rig_, 3, {});
  EXPECT_EQ(image.station.position, 3);
  EXPECT_EQ(image.poseKnownBy, rig_.positioner->where()->knownBy);
  EXPECT_EQ(image.T_table_scanner.matrix(), rig_.positioner->where()->T_table_scanner.matrix());
  EXPECT_GT(image.sampleCount(), 100U);
}

TEST_P(EveryRig, AnswersAStop) {
  std::stop_source stop;
  stop.request_stop();
  const Progress stopped({}, stop.get_token(), 1);
  EXPECT_THROW(static_cast<void>(rig_.positioner->moveTo(1, stopped)), Cancelled);
  static_cast<void>(rig_.positioner->moveTo(1, {}));
  EXPECT_THROW(static_cast<void>(rig_.sensor->capture(stopped)), Cancelled);
  EXPECT_EQ(bytes(rig_.sensor->capture({})), bytes(scanFrom(GetParam().make(), 1, {})));
}

TEST_P(EveryRig, OpensAndClosesAsOftenAsItIsTold) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) static_cast<void>(opened(rig_));
    EXPECT_FALSE(rig_.sensor->notReady());
    EXPECT_FALSE(rig_.positioner->notReady());
    EXPECT_GT(scanFrom(rig_, i, {}).sampleCount(), 100U);
    for (int j = 0; j < 2; ++j) rig_.sensor->close();
    EXPECT_TRUE(rig_.sensor->notReady());
    EXPECT_THROW(static_cast<void>(scanFrom(rig_, 3, {})), DeviceError);
    EXPECT_EQ(rig_.positioner->where()->position, i) << "it moved although nothing can be scanned";
  }
}

}  // namespace
}  // namespace vantage
