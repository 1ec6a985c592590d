#include "calibration/table_calibrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "base/errors.h"
#include "base/random.h"
#include "support/meshes.h"
#include "turning_scene.h"

namespace vantage::testing {
namespace {

constexpr double kHeight = 50.0;  // of the objects' middle [mm]
const std::vector<double> kAngles{0, 20, 45, 75, 110, 150};

TurningScene lumpBeforeCamera() {
  TurningScene scene;
  scene.object = makeLump();
  scene.profile = cameraOverTable();
  scene.T_table_scanner = offBy(Vec3(5, -4, 3), Vec3(1, 2, -1.5), Vec3(450, 0, 250));
  return scene;
}

const CalibrationFinding* findingOf(const CalibrationResult& result, CalibrationReason reason) {
  const auto at = std::find_if(result.findings.begin(), result.findings.end(),
                               [&](const CalibrationFinding& finding) { return finding.reason == reason; });
  return at == result.findings.end() ? nullptr : &*at;
}

void expectWithinTarget(const CalibrationResult& result, const TurningScene& scene, const std::string& what) {
  const AxisError error = errorOf(result.calibration, scene.T_table_scanner, kHeight);
  EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Good) << what;
  for (const CalibrationFinding& finding : result.findings)
    EXPECT_EQ(worthOf(finding), CalibrationVerdict::Good) << what << ": " << describe(finding);
  EXPECT_LT(error.direction, 0.1) << what;
  EXPECT_LT(error.place, 0.2) << what;
  EXPECT_EQ(result.calibration.sense, scene.turnsPerCount < 0.0 ? -1 : 1) << what;
  EXPECT_NEAR(result.calibration.degreesPerCommandedDegree, std::abs(scene.turnsPerCount), 0.01) << what;
}

TEST(TableCalibrator, FindsAxisAndPlaneAmongStillThings) {
  TurningScene scene = lumpBeforeCamera();
  scene.wall = true;
  const auto result = calibrateTable(scene.scans(kAngles), *scene.profile);
  expectWithinTarget(result, scene, "lump");
  EXPECT_LT(errorOf(result.calibration, scene.T_table_scanner, kHeight).plane, 0.1);
  EXPECT_EQ(result.calibration.degreesPerCommandedDegree, 1.0);
  EXPECT_EQ(findingOf(result, CalibrationReason::TableNotSeen), nullptr);
}

TEST(TableCalibrator, FindsTheAxisOfARoundCupByItsHandle) {
  TurningScene scene = lumpBeforeCamera();
  scene.object = makeCup();
  expectWithinTarget(calibrateTable(scene.scans(kAngles), *scene.profile), scene, "cup");
}

TEST(TableCalibrator, FindsTheAxisWhereTheTableIsNotSeen) {
  TurningScene scene = lumpBeforeCamera();
  scene.profile = stripeScanner();
  scene.T_table_scanner = offBy(Vec3(5, -4, 3), Vec3(1, 2, -1.5), Vec3(300, 0, 75));
  const auto result = calibrateTable(scene.scans(kAngles), *scene.profile);
  const AxisError error = errorOf(result.calibration, scene.T_table_scanner, kHeight);
  EXPECT_LT(error.direction, 0.1);
  EXPECT_LT(error.place, 0.2);
  EXPECT_FALSE(result.planeSeen);
  // Its height is a guess, and said to be one.
  EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Doubtful);
  const CalibrationFinding* guess = findingOf(result, CalibrationReason::TableNotSeen);
  ASSERT_NE(guess, nullptr);
  EXPECT_EQ(guess->value, result.planeSigma);
  EXPECT_GT(result.planeSigma, 0.0);
  EXPECT_LT(error.plane, 3.0 * result.planeSigma);
}

TEST(TableCalibrator, TellsSenseAndRatio) {
  for (const double turns : {-1.0, 0.97, 1.1, -0.97, -1.1, 2.0}) {
    TurningScene scene = lumpBeforeCamera();
    scene.turnsPerCount = turns;
    const auto result = calibrateTable(scene.scans({{0, 15, 32, 52, 75}}), *scene.profile);
    const std::string what = "turns per count " + std::to_string(turns);
    expectWithinTarget(result, scene, what);
    EXPECT_EQ(findingOf(result, CalibrationReason::TurnsOtherWay) != nullptr, turns < 0.0) << what;
    EXPECT_EQ(findingOf(result, CalibrationReason::OtherRatio) != nullptr, std::abs(turns) != 1.0) << what;
  }
}

TEST(TableCalibrator, WorksOnEveryNthRowAndColumnOfManyRays) {
  const TurningScene scene = lumpBeforeCamera();
  const auto scans = scene.scans(kAngles);
  const auto whole = calibrateTable(scans, *scene.profile);
  CalibrationOptions options;
  options.thinning.spacing = 4.0;
  ASSERT_GT(thinningStep(*scans.front().image, options.thinning), 1);
  const auto thinned = calibrateTable(scans, *scene.profile, options);
  expectWithinTarget(thinned, scene, "thinned");
  EXPECT_LT(2 * thinned.scans[0].moving, whole.scans[0].moving);
}

TEST(TableCalibrator, IsRightOverManySeedsWithATableThatErrs) {
  for (int seed = 1; seed <= 4; ++seed) {
    TurningScene scene = lumpBeforeCamera();
    scene.seed = static_cast<std::uint64_t>(seed);
    scene.angleSigma = radians(0.2);
    scene.turnsPerCount = seed % 2 == 0 ? -1.0 : 1.0;
    Random random(static_cast<std::uint64_t>(seed), 77);
    auto u = [&] { return 2.0 * random.uniform() - 1.0; };
    scene.T_table_scanner = offBy(8.0 * Vec3(u(), u(), u()), 3.0 * Vec3(u(), u(), u()), Vec3(450, 0, 250));
    expectWithinTarget(calibrateTable(scene.scans(kAngles), *scene.profile), scene, "seed " + std::to_string(seed));
  }
}

TEST(TableCalibrator, NamesTheScanBeforeWhichTheTableSlipped) {
  TurningScene scene = lumpBeforeCamera();
  scene.slipsBefore = 3;
  const auto result = calibrateTable(scene.scans(kAngles), *scene.profile);
  EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Failed);
  const CalibrationFinding* slip = findingOf(result, CalibrationReason::Slip);
  ASSERT_NE(slip, nullptr);
  EXPECT_EQ(slip->scan, 3U);
  EXPECT_NEAR(slip->value.value_or(0.0), -8.0, 1.0);
  EXPECT_NEAR(degrees(result.scans[2].off), 0.0, 0.5);
  EXPECT_NEAR(degrees(result.scans[4].off), -8.0, 1.0);
}

TEST(TableCalibrator, RefusesACylinder) {
  for (const double beside : {0.0, 6.0}) {
    TurningScene scene = lumpBeforeCamera();
    scene.object = makeCylinder(30.0, 80.0, beside);
    const auto result = calibrateTable(scene.scans(kAngles), *scene.profile);
    EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Failed) << beside;
    ASSERT_FALSE(result.findings.empty());
    const CalibrationReason reason = result.findings.front().reason;
    EXPECT_TRUE(reason == CalibrationReason::NothingTurns || reason == CalibrationReason::RotationNotObservable)
        << beside << ": " << describe(result.findings.front());
  }
}

TEST(TableCalibrator, RefusesTooSmallATurn) {
  const TurningScene scene = lumpBeforeCamera();
  const auto result = calibrateTable(scene.scans({{0, 4, 8, 12}}), *scene.profile);
  EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Failed);
  EXPECT_NE(findingOf(result, CalibrationReason::TooSmallTurn), nullptr);
}

TEST(TableCalibrator, RefusesATableThatStands) {
  TurningScene scene = lumpBeforeCamera();
  scene.turnsPerCount = 0.0;
  const auto result = calibrateTable(scene.scans(kAngles), *scene.profile);
  EXPECT_EQ(result.calibration.verdict, CalibrationVerdict::Failed);
  EXPECT_NE(findingOf(result, CalibrationReason::NothingTurns), nullptr);
}

TEST(TableCalibrator, GivesTheSameForAnyNumberOfThreads) {
  const TurningScene scene = lumpBeforeCamera();
  const auto scans = scene.scans({{0, 20, 45, 75}});
  const TableCalibration one = calibrateTable(scans, *scene.profile).calibration;
  const TableCalibration three = calibrateTable(scans, *scene.profile, {}, Progress({}, {}, 3)).calibration;
  EXPECT_EQ(one.axisPoint, three.axisPoint);
  EXPECT_EQ(one.axisDirection, three.axisDirection);
  EXPECT_EQ(one.degreesPerCommandedDegree, three.degreesPerCommandedDegree);
}

TEST(TableCalibrator, RefusesTooFewScansAndOtherScanners) {
  const TurningScene scene = lumpBeforeCamera();
  EXPECT_THROW((void)calibrateTable(scene.scans({{0, 30}}), *scene.profile), InvalidInput);
  auto scans = scene.scans({{0, 30}});
  TurningScene other = scene;
  other.profile = stripeScanner();
  scans.push_back(other.scans({{60}}).front());
  EXPECT_THROW((void)calibrateTable(scans, *scene.profile), InvalidInput);
}

TEST(TableCalibrator, StopsWhenAsked) {
  const TurningScene scene = lumpBeforeCamera();
  const auto scans = scene.scans({{0, 30, 60}});
  std::stop_source stop;
  const Progress progress(
      [&](double fraction, std::string_view) {
        if (fraction > 0.2) stop.request_stop();
      },
      stop.get_token(), 1);
  EXPECT_THROW((void)calibrateTable(scans, *scene.profile, {}, progress), Cancelled);
}

TEST(CalibrationFinding, HasANameAndASentence) {
  for (int k = 0; k <= static_cast<int>(kLastCalibrationReason); ++k) {
    const CalibrationFinding finding{static_cast<CalibrationReason>(k), 1.5, 2};
    EXPECT_FALSE(name(finding.reason).empty());
    EXPECT_GT(describe(finding).size(), 40U) << k;
  }
  EXPECT_NE(describe({CalibrationReason::Slip, -8.0, 3}).find("scan 4"), std::string::npos);
}

}  // namespace
}  // namespace vantage::testing
