#include "acquisition/steps.h"
#include "acquisition/scan_placing.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/measures.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// A scan of position 2, taken where the table believed to be when it was 1.8 mm, nine sigmas of one move, beside it.
AcquisitionState addMisplaced(std::int64_t number) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), state.profile, {1, true});
  const auto scanOf = [&](int position) { return std::make_shared<RangeImage>(scanFrom(rig, position, Progress())); };
  state = addScan(state, {0, scanOf(0)}, std::nullopt, stepOptionsFor(state), {});
  const auto misplaced = scanOf(2);
  misplaced->T_table_scanner = Eigen::Translation3d(1.8, 0.0, 0.0) * misplaced->T_table_scanner;
  return addScan(state, {number, misplaced}, std::nullopt, stepOptionsFor(state), {});
}

TEST(AddScan, RejectsAScanThatTheMechanicsCannotHaveBroughtThere) {
  const AcquisitionState state = addMisplaced(1);
  ASSERT_EQ(state.scans.size(), 2U);
  EXPECT_EQ(state.scans[1].status, ScanStatus::Rejected);
  EXPECT_EQ(state.scans[1].record.registration.finding.reason, VerdictReason::Motion);
  EXPECT_EQ(countScans(state, ScanStatus::In), 1U);
}

TEST(AddScan, KnowsThatTheTableMovedForEveryScanInBetween) {
  const AcquisitionState state = addMisplaced(36);
  ASSERT_EQ(countScans(state, ScanStatus::In), 2U);
  const Pose truth = state.profile->workspace.poses[2];
  EXPECT_LT((state.scans[1].view.T_object_scanner.translation() - truth.translation()).norm(), 0.3);
}

// A plan that sends the table to a position where nothing overlaps.
std::shared_ptr<const Plan> planTo(int position) {
  Plan plan;
  plan.outcome = PlanOutcome::Found;
  plan.position = position;
  plan.tableAlone = true;
  return std::make_shared<const Plan>(std::move(plan));
}

// What becomes of exact scans of these positions.
AcquisitionState scanned(const Mesh& object, const std::vector<int>& positions, bool byTable = false) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  const Rig rig = testing::simulation(object, state.profile, {1, true});
  for (const int position : positions) {
    if (byTable) state.plan = planTo(position);
    const auto image = std::make_shared<RangeImage>(scanFrom(rig, position, Progress()));
    state =
        addScan(state, {static_cast<std::int64_t>(state.scans.size()), image}, std::nullopt, stepOptionsFor(state), {});
  }
  return state;
}

const RegistrationResult& registrationOf(const AcquisitionState& state, std::size_t scan) {
  return state.scans[scan].record.registration;
}

// Upright, its broad sides towards positions 0 and 12.
Mesh makePlate() {
  return testing::makeBox({-0.75, -30.0, 20.0}, {0.75, 30.0, 100.0});
}

TEST(AddScan, TheFarSideOfAPlateIsWhereTheTableHasIt) {
  const AcquisitionState state = scanned(makePlate(), {0, 12}, true);
  ASSERT_EQ(countScans(state, ScanStatus::In), 2U);
  EXPECT_EQ(registrationOf(state, 1).verdict, Verdict::Doubtful);
  EXPECT_EQ(registrationOf(state, 1).finding.reason, VerdictReason::TableAlone);
  // Both sheets are whole: neither is taken for the other.
  EXPECT_GT(area(state.model->mesh), 1.9 * state.scans[0].record.newArea);
  const Pose& nominal = state.profile->workspace.poses[12];
  EXPECT_LT((state.scans[1].view.T_object_scanner.translation() - nominal.translation()).norm(), 1e-6);
}

TEST(AddScan, WhatNobodySentTheTableForHasToOverlap) {
  const AcquisitionState state = scanned(makePlate(), {0, 12});
  EXPECT_EQ(state.scans[1].status, ScanStatus::Rejected);
  EXPECT_EQ(registrationOf(state, 1).finding.reason, VerdictReason::FewPairs);
}

TEST(AddScan, LaterScansLiftADoubt) {
  const AcquisitionState before = scanned(testing::smallObject(), {0, 10}, true);
  ASSERT_EQ(registrationOf(before, 1).finding.reason, VerdictReason::TableAlone);
  const AcquisitionState after = scanned(testing::smallObject(), {0, 10, 5, 3, 7}, true);
  EXPECT_EQ(registrationOf(after, 1).verdict, Verdict::Good);
  EXPECT_EQ(registrationOf(after, 1).finding.reason, VerdictReason::HeldByAll);
}

TEST(AddScan, WhatFitsButShowsEmptinessWhereOthersSawSurfaceStaysOut) {
  // A bar that slides along itself: its ends say that it has moved 25 mm.
  AcquisitionState state = scanned(testing::makeBox({-8.0, -45.0, 40.0}, {8.0, 25.0, 60.0}), {0});
  const Mesh moved = testing::makeBox({-8.0, -20.0, 40.0}, {8.0, 50.0, 60.0});
  const Rig rig = testing::simulation(moved, state.profile, {1, true});
  const auto image = std::make_shared<RangeImage>(scanFrom(rig, 1, Progress()));
  state = addScan(state, {1, image}, std::nullopt, stepOptionsFor(state), {});
  EXPECT_EQ(state.scans[1].status, ScanStatus::Rejected);
  EXPECT_EQ(registrationOf(state, 1).finding.reason, VerdictReason::ContradictsOthers);
}

TEST(AddScan, NamesThePositionThatAScanFits) {
  AcquisitionState state = scanned(testing::smallObject(), {0, 2, 4});
  const Rig rig = testing::simulation(testing::smallObject(), state.profile, {1, true});
  RangeImage image = scanFrom(rig, 6, Progress());
  image.station.position = 14;
  image.takenWith.clear();  // somebody says so
  image.T_table_scanner = state.profile->workspace.poses[14];
  state = addScan(state, {3, std::make_shared<RangeImage>(std::move(image))}, std::nullopt, stepOptionsFor(state), {});
  EXPECT_EQ(state.scans[3].status, ScanStatus::Rejected);
  EXPECT_EQ(registrationOf(state, 3).finding, (Finding{VerdictReason::OtherPosition, 6.0, {}}));
}

// A scan of position 3 that is said to have been taken elsewhere about the table's axis.
AcquisitionState addTurned(double angle, PoseSource knownBy, std::optional<Mechanics> uncertainty,
                           const Mesh& object = testing::smallObject()) {
  AcquisitionState state = scanned(object, {0, 1, 2});
  const Rig rig = testing::simulation(object, state.profile, {1, true});
  state.settings.registration.limits.fewPairs = 100;  // the scans are small
  RangeImage image = scanFrom(rig, 3, Progress());
  image.T_table_scanner = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * image.T_table_scanner;
  image.poseKnownBy = knownBy;
  image.poseUncertainty = uncertainty;
  return addScan(state, {3, std::make_shared<RangeImage>(std::move(image))}, std::nullopt, stepOptionsFor(state), {});
}

double turnFromTruth(const AcquisitionState& state) {
  const Pose& truth = state.profile->workspace.poses[3];
  return Eigen::AngleAxisd(Eigen::Matrix3d(state.scans[3].view.T_object_scanner.linear() * truth.linear().transpose()))
      .angle();
}

TEST(AddScan, FindsWhatAPersonTurnedNearlyAsFarAsTheyWereAsked) {
  for (const double angle : {-14.0, -5.0, 9.0, 14.0}) {
    const AcquisitionState state = addTurned(radians(angle), PoseSource::ByHand, Mechanics{radians(7.5), 3.0});
    EXPECT_EQ(state.scans[3].status, ScanStatus::In) << angle;
    EXPECT_LT(turnFromTruth(state), radians(0.3)) << angle;
  }
}

TEST(AddScan, SaysHowFarATableSlippedAndCallsNothingAboutItGood) {
  for (const double angle : {-12.0, 8.0}) {
    const AcquisitionState state = addTurned(radians(angle), PoseSource::Reported, {});
    ASSERT_EQ(state.scans[3].status, ScanStatus::In) << angle;
    EXPECT_EQ(registrationOf(state, 3).verdict, Verdict::Doubtful);
    EXPECT_EQ(registrationOf(state, 3).finding.reason, VerdictReason::TableSlipped);
    EXPECT_NEAR(*registrationOf(state, 3).finding.value, angle, 0.3);
    EXPECT_LT(turnFromTruth(state), radians(0.3)) << angle;
  }
}

// A ball is where the table says, for it looks the same however far it turned.
TEST(AddScan, TheWordOfATableThatStoodElsewhereDoesNotHoldAScan) {
  const Mesh ball = testing::makeSphere(35.0, 48, {0.0, 0.0, 50.0});
  AcquisitionState state = scanned(ball, {0, 1, 2});
  const Rig rig = testing::simulation(ball, state.profile, {1, true});
  const auto next = std::make_shared<RangeImage>(scanFrom(rig, 3, Progress()));
  AcquisitionState after = addScan(state, {4, next}, std::nullopt, stepOptionsFor(state), {});
  ASSERT_EQ(after.scans[3].status, ScanStatus::In);
  ASSERT_EQ(registrationOf(after, 3).finding.reason, VerdictReason::HeldByMechanics);

  KeptScan misplaced = state.scans.back();
  misplaced.number = 3;
  misplaced.status = ScanStatus::Rejected;
  misplaced.record.registration.verdict = Verdict::Failed;
  misplaced.record.registration.finding = {VerdictReason::OtherTurn, 99.0, {}};
  state.scans.push_back(std::move(misplaced));
  after = addScan(state, {4, next}, std::nullopt, stepOptionsFor(state), {});
  EXPECT_EQ(after.scans[4].status, ScanStatus::Rejected);
  EXPECT_EQ(registrationOf(after, 4).finding.reason, VerdictReason::TableInDoubt);
}

}  // namespace
}  // namespace vantage
