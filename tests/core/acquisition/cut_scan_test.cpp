#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <utility>
#include <vector>

#include "acquisition/steps.h"
#include "acquisition/test_turn.h"
#include "report/evaluation.h"
#include "report/html_report.h"
#include "report/report.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// The small object before a wall that belongs to the room, and so turns about the table.
Mesh objectBeforeWall() {
  return testing::joined(testing::smallObject(), testing::makeBox({-120, -70, 0}, {-110, 70, 110}, 8));
}

AcquisitionSettings realSettings() {
  AcquisitionSettings settings;
  settings.cut = cutForRealScanners();
  return settings;
}

// The small scanner with twice the rows and columns: what is left of every 2nd are the small scanner's.
std::shared_ptr<const ScannerProfile> finerProfile() {
  ProfileSource source = testing::smallProfileSource();
  source.text =
      std::regex_replace(source.text, std::regex("\"samples_per_stripe\": 61"), "\"samples_per_stripe\": 121");
  source.text = std::regex_replace(source.text, std::regex("\"stripes\": 81"), "\"stripes\": 161");
  return std::make_shared<const ScannerProfile>(parseProfile(source));
}

AcquisitionState scanned(const Mesh& object, const AcquisitionSettings& settings, const std::vector<int>& positions,
                         std::shared_ptr<const ScannerProfile> profile = testing::smallProfile()) {
  AcquisitionState state;
  state.profile = std::move(profile);
  state.settings = settings;
  const Rig rig = testing::simulation(object, state.profile, {1, true});
  for (const int position : positions) {
    const auto image = std::make_shared<const RangeImage>(scanFrom(rig, position, Progress()));
    state =
        addScan(state, {static_cast<std::int64_t>(state.scans.size()), image}, std::nullopt, stepOptionsFor(state), {});
  }
  return state;
}

double leastX(const Mesh& mesh) {
  double least = 1e9;
  for (const Vec3& v : mesh.vertices) least = std::min(least, v.x());
  return least;
}

TEST(CutScan, AViewIsWhatIsLeftAndItsRecordSaysWhatIsNot) {
  const AcquisitionState whole = scanned(objectBeforeWall(), {}, {0});
  const AcquisitionState cut = scanned(objectBeforeWall(), realSettings(), {0});
  EXPECT_LT(leastX(whole.model->mesh), -100.0);
  EXPECT_GT(leastX(cut.model->mesh), -60.0);
  const ScanRecord& record = cut.scans[0].record;
  EXPECT_GT(record.cut[static_cast<std::size_t>(CutReason::Outside)], 100U);
  EXPECT_EQ(record.samples + cutSamples(record.cut), whole.scans[0].record.samples);
  EXPECT_EQ(record.samples, cut.scans[0].view.image->sampleCount());
  EXPECT_EQ(cutSamples(whole.scans[0].record.cut), 0U);
  EXPECT_TRUE(makeReport(cut, "test")["views"][0]["cut"].contains("outside"));
  EXPECT_FALSE(makeReport(whole, "test")["views"][0].contains("cut"));
}

TEST(CutScan, SameModelAsWithoutTheWall) {
  const AcquisitionState cut = scanned(objectBeforeWall(), realSettings(), {0, 2});
  const AcquisitionState alone = scanned(testing::smallObject(), {}, {0, 2});
  ASSERT_EQ(countScans(cut, ScanStatus::In), 2U);
  EXPECT_NEAR(static_cast<double>(cut.model->mesh.vertices.size()),
              static_cast<double>(alone.model->mesh.vertices.size()),
              0.01 * static_cast<double>(alone.model->mesh.vertices.size()));
}

TEST(CutScan, ATestTurnLooksAtTheObjectAlone) {
  const auto profile = testing::smallProfile();
  const Mesh scene = objectBeforeWall();
  const TestTurn whole = testTurn(testing::simulation(scene, profile), *profile, 0, 1, {}, {});
  const TestTurn cut = testTurn(testing::simulation(scene, profile), *profile, 0, 1, cutForRealScanners(), {});
  const TestTurn alone = testTurn(testing::simulation(testing::smallObject(), profile), *profile, 0, 1, {}, {});
  EXPECT_LT(cut.samples + 100, whole.samples);
  EXPECT_NEAR(static_cast<double>(cut.samples), static_cast<double>(alone.samples),
              0.01 * static_cast<double>(alone.samples));
  EXPECT_EQ(cut.registration.verdict, alone.registration.verdict);
  EXPECT_NEAR(cut.measured, alone.measured, radians(0.3));
}

TEST(CutScan, TheReportSaysWhatOfAThinnedScanIsWorkedOn) {
  const AcquisitionState whole = scanned(testing::smallObject(), {}, {0});
  AcquisitionSettings settings;
  settings.thinning.spacing = 2.9 * whole.scans[0].view.mesh->spacing;
  const AcquisitionState thinned = scanned(testing::smallObject(), settings, {0});
  EXPECT_EQ(thinned.scans[0].record.everyNth, 2);
  EXPECT_EQ(thinned.scans[0].record.samples, whole.scans[0].record.samples) << "of the scan as it came";
  const auto report = makeReport(thinned, "test");
  EXPECT_EQ(report["views"][0]["worked_on"]["every_nth_row_and_column"], 2);
  EXPECT_FALSE(makeReport(whole, "test")["views"][0].contains("worked_on"));
  EXPECT_NE(makeHtmlReport(thinned, {"test", {}, {}}).find("every 2nd row and column"), std::string::npos);
}

TEST(CutScan, AThinnedModelIsAsTrueAsItsSpacing) {
  const std::vector<int> positions{0, 2, 4, 6};
  AcquisitionSettings settings;
  const AcquisitionState whole = scanned(testing::smallObject(), settings, positions, finerProfile());
  const double spacing = whole.scans[0].view.mesh->spacing;
  settings.thinning.spacing = 2.9 * spacing;
  const AcquisitionState thinned = scanned(testing::smallObject(), settings, positions, finerProfile());
  ASSERT_EQ(countScans(whole, ScanStatus::In), positions.size());
  ASSERT_EQ(countScans(thinned, ScanStatus::In), positions.size());
  for (const KeptScan& scan : thinned.scans) EXPECT_EQ(scan.record.everyNth, 2);
  const auto judged = [&](const AcquisitionState& state) {
    return evaluate(state.model->mesh, testing::smallObject(), *state.profile, {}, {});
  };
  const Evaluation all = judged(whole);
  const Evaluation some = judged(thinned);
  EXPECT_LT(some.rms, all.rms + 0.1 * spacing);
  EXPECT_GT(some.coverage, all.coverage - 0.05) << "a rim of one spacing about every border";
}

}  // namespace
}  // namespace vantage
