#include "acquisition/import_scans.h"

#include <gtest/gtest.h>

#include "acquisition/acquisition_state.h"
#include "acquisition/kept_scan.h"
#include "acquisition/memory_journal.h"
#include "base/errors.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// Scans of the small object from these positions, as their file says where they were taken.
std::vector<NumberedScan> recordedScans(const std::vector<int>& positions) {
  AcquisitionSettings settings;
  settings.simulation.ideal = true;
  MemoryJournal journal(testing::smallProfile(), settings);
  Acquisition acquisition(journal, testing::smallTools(testing::smallProfile(), settings));
  std::vector<NumberedScan> scans;
  for (const int position : positions) {
    acquisition.carryOut(ChoosePosition{position});
    acquisition.scanNext();
    RangeImage image = *journal.scan(journal.scanCount() - 1);
    image.station.position.reset();
    image.poseKnownBy = PoseSource::Reported;
    scans.push_back({static_cast<std::int64_t>(scans.size()), std::make_shared<const RangeImage>(std::move(image))});
  }
  return scans;
}

AcquisitionState imported(const std::vector<NumberedScan>& scans) {
  const AcquisitionState empty;
  return importScans(empty, scans, importOptionsFor(empty), {});
}

TEST(ImportScans, PutsScansWhereTheyWereTakenAndTheFirstStays) {
  const std::vector<NumberedScan> scans = recordedScans({0, 2, 4});
  const AcquisitionState state = imported(scans);
  EXPECT_EQ(state.termination, Termination::Imported);
  ASSERT_EQ(countScans(state, ScanStatus::In), 3U);
  EXPECT_EQ(state.scans[0].view.T_object_scanner.matrix(), scans[0].image->T_table_scanner.matrix());
  for (const KeptScan& scan : state.scans) {
    const Vec3 nominal = scan.view.image->T_table_scanner.translation();
    EXPECT_LT((scan.view.T_object_scanner.translation() - nominal).norm(), 0.5) << scan.number;
  }
  EXPECT_EQ(state.scans[0].record.registration.finding.reason, VerdictReason::FirstImported);
  EXPECT_FALSE(state.plan);
}

TEST(ImportScans, RejectsAScanWithoutSurface) {
  std::vector<NumberedScan> scans = recordedScans({0, 2});
  RangeImage nothing = *scans[0].image;
  nothing.range.assign(nothing.range.size(), 0.0F);
  scans.push_back({2, std::make_shared<const RangeImage>(nothing)});
  const AcquisitionState state = imported(scans);
  EXPECT_EQ(state.scans[2].status, ScanStatus::Rejected);
  EXPECT_FALSE(state.scans[2].view.mesh);
  EXPECT_EQ(countScans(state, ScanStatus::In), 2U);
  EXPECT_THROW(static_cast<void>(imported({scans[2], scans[0]})), InvalidInput);
  EXPECT_THROW(static_cast<void>(imported({})), InvalidInput);
}

TEST(ImportScans, FindsNoFaultInAListThatIsRight) {
  EXPECT_FALSE(poseListFault(imported(recordedScans({0, 2, 4, 6}))));
}

TEST(ImportScans, SaysThatEveryTurnIsHalfOfWhatTheListSays) {
  std::vector<NumberedScan> scans = recordedScans({0, 1, 2, 3, 4, 5});
  const auto profile = testing::smallProfile();
  for (std::size_t i = 0; i < scans.size(); ++i) {
    RangeImage image = *scans[i].image;
    image.T_table_scanner = profile->workspace.poses[2 * i];
    scans[i].image = std::make_shared<const RangeImage>(std::move(image));
  }
  const AcquisitionState state = imported(scans);
  for (const KeptScan& scan : state.scans) EXPECT_NE(scan.record.registration.verdict, Verdict::Good) << scan.number;
  const auto fault = poseListFault(state);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->fault, PoseListFault::Turns);
  EXPECT_NEAR(fault->value, 0.5, 0.03);
}

TEST(KeptScan, IsTriangulatedWhereItWasReached) {
  const NumberedScan scan = recordedScans({3})[0];
  const KeptScan kept = keepAsView(scan, {}, {});
  EXPECT_EQ(kept.view.T_object_scanner.matrix(), scan.image->T_table_scanner.matrix());
  EXPECT_EQ(kept.record.samples, scan.image->sampleCount());
  EXPECT_EQ(kept.record.triangles, kept.view.mesh->mesh.triangles.size());
  EXPECT_GT(kept.record.triangles, 100U);
}

TEST(KeptScan, IsWorkedOnAsThinlyAsTheOptionsSay) {
  const NumberedScan scan = recordedScans({3})[0];
  const KeptScan all = keepAsView(scan, {}, {});
  EXPECT_EQ(all.view.image, scan.image);
  const KeptScan some = keepAsView(scan, {{}, {2.8 * all.view.mesh->spacing}}, {});
  EXPECT_EQ(some.record.samples, scan.image->sampleCount());
  EXPECT_LT(some.view.image->rays->size(), scan.image->rays->size() / 3);
  EXPECT_NEAR(some.view.mesh->spacing, 2.0 * all.view.mesh->spacing, 0.2 * all.view.mesh->spacing);
  const KeptScan next = keepAsView(scan, {{}, {2.8 * all.view.mesh->spacing}}, {}, some.view.image->rays);
  EXPECT_EQ(next.view.image->rays, some.view.image->rays);
}

TEST(MemoryJournal, HandsOutTheLastScanThatNoCommandUsed) {
  const NumberedScan scan = recordedScans({3})[0];
  MemoryJournal journal(testing::smallProfile(), {});
  EXPECT_FALSE(journal.unusedScan());
  EXPECT_FALSE(journal.lastStation());
  RangeImage image = *scan.image;
  image.station.position = 3;
  EXPECT_EQ(journal.keepScan(image).number, 0);
  ASSERT_TRUE(journal.unusedScan());
  EXPECT_EQ(journal.lastStation()->position, 3);
  EXPECT_THROW(static_cast<void>(journal.scan(1)), InvalidInput);
  Acquisition(journal).carryOut(AddScan{0, {}});
  EXPECT_FALSE(journal.unusedScan());
  EXPECT_EQ(lastView(*journal.state())->number, 0);
  EXPECT_EQ(lastView(*journal.state(), 1), nullptr);
  EXPECT_EQ(findScan(*journal.state(), 1), nullptr);
}

}  // namespace
}  // namespace vantage
