#include "acquisition/hand_placing.h"

#include <gtest/gtest.h>

#include <vector>

#include "acquisition/memory_journal.h"
#include "acquisition/steps.h"
#include "planning/planner.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

constexpr Mechanics kHand{radians(7.5), 3.0};

// Scans of positions whose table a person turned so many degrees too far.
struct HandTurns {
  Mesh object;
  std::vector<std::pair<int, double>> turns;
};

AcquisitionState withScans(AcquisitionState state, const HandTurns& scene) {
  for (const auto& [position, off] : scene.turns) {
    ScannerProfile there = *state.profile;
    const Pose nominal = state.profile->workspace.poses[static_cast<std::size_t>(position)];
    there.workspace.poses = {Eigen::AngleAxisd(radians(off), Vec3::UnitZ()) * nominal};
    const Rig rig = testing::simulation(scene.object, std::make_shared<const ScannerProfile>(there), {1, true});
    RangeImage image = scanFrom(rig, 0, {});
    image.rays = state.profile->rays;
    image.T_table_scanner = nominal;
    image.station.position = position;
    image.poseKnownBy = PoseSource::ByHand;
    image.poseUncertainty = kHand;
    state = addScan(state, {static_cast<std::int64_t>(state.scans.size()), std::make_shared<RangeImage>(image)},
                    std::nullopt, stepOptionsFor(state), {});
  }
  return state;
}

AcquisitionState scannedByHand(const HandTurns& scene) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  state.settings.registration.limits.fewPairs = 100;  // the scans are small
  return withScans(std::move(state), scene);
}

// How far a scan was found from where it was taken [deg].
double errorOf(const AcquisitionState& state, std::size_t scan, double off) {
  const KeptScan& kept = state.scans[scan];
  const Pose truth = Eigen::AngleAxisd(radians(off), Vec3::UnitZ()) * kept.view.image->T_table_scanner;
  return degrees(
      Eigen::AngleAxisd(Eigen::Matrix3d(kept.view.T_object_scanner.linear() * truth.linear().transpose())).angle());
}

// It looks the same however far the table turns.
Mesh makeBall() {
  return testing::makeSphere(35.0, 64, Vec3(0.0, 0.0, 50.0));
}

TEST(HandPlacing, FindsScansWhoseErrorsDoNotAddUp) {
  const std::vector<std::pair<int, double>> turns{{0, 0.0}, {1, 11.0}, {2, -11.0}, {3, 9.0}};
  const AcquisitionState state = scannedByHand({testing::smallObject(), turns});
  for (std::size_t k = 1; k < turns.size(); ++k) {
    EXPECT_EQ(state.scans[k].status, ScanStatus::In) << k;
    EXPECT_LT(errorOf(state, k, turns[k].second), 0.3) << k;
    EXPECT_FALSE(isLoose(state.scans[k])) << k;
  }
}

// Two views of a body with shape, and a person who turned far beyond what is counted on.
TEST(HandPlacing, WhatIsSaidToBeKnownIsRight) {
  for (const int position : {1, 3, 4}) {
    for (const double off : {40.0, -40.0, 70.0, -70.0, 120.0}) {
      const AcquisitionState state = scannedByHand({testing::smallObject(), {{0, 0.0}, {position, off}}});
      const KeptScan& scan = state.scans[1];
      if (scan.status == ScanStatus::In && !isLoose(scan)) {
        EXPECT_LT(errorOf(state, 1, off), 0.3) << position << " " << off;
      }
    }
  }
}

TEST(HandPlacing, NobodyKnowsHowFarABodyOfRevolutionWasTurned) {
  const AcquisitionState state = scannedByHand({makeBall(), {{0, 0.0}, {2, 8.0}, {4, -8.0}}});
  EXPECT_FALSE(isLoose(state.scans[0]));
  for (const std::size_t k : {1U, 2U}) {
    ASSERT_EQ(state.scans[k].status, ScanStatus::In) << k;
    EXPECT_EQ(state.scans[k].record.registration.verdict, Verdict::Doubtful) << k;
    EXPECT_TRUE(isLoose(state.scans[k])) << k;
  }
  EXPECT_EQ(firmViews(state).size(), 1U);
}

TEST(HandPlacing, LooseViewsStayWhereTheyWereRegistered) {
  const AcquisitionState state = scannedByHand({makeBall(), {{0, 0.0}, {2, 8.0}, {4, -8.0}, {6, 6.0}}});
  for (const KeptScan& scan : state.scans) {
    if (!isLoose(scan)) continue;
    const Pose moved = scan.view.T_object_scanner * scan.record.registration.T_object_scanner.inverse();
    EXPECT_LT(degrees(Eigen::AngleAxisd(Eigen::Matrix3d(moved.linear())).angle()), 0.5) << scan.number;
  }
}

// A view of which nobody knows where it is stands where it is not. One that others hold is not refused because of it,
// however doubtful it is, and the loose one finds its place with what holds by then, or leaves the model.
TEST(HandPlacing, WhatOthersHoldIsNotRefusedBecauseOfALooseView) {
  AcquisitionState state = scannedByHand({testing::smallObject(), {{0, 0.0}, {2, -8.0}}});
  KeptScan& loose = state.scans[1];
  ASSERT_EQ(loose.status, ScanStatus::In);
  const StepOptions options = stepOptionsFor(state);
  loose.view.T_object_scanner = turnedBy(radians(25.0), loose.view.T_object_scanner, Pose::Identity());
  loose.record.registration.T_object_scanner = loose.view.T_object_scanner;
  loose.record.registration.verdict = Verdict::Doubtful;
  loose.record.registration.finding = {VerdictReason::HeldByMechanics, std::nullopt, {}};
  loose.record.registration.poseSigma = 9.0;
  ASSERT_TRUE(isLoose(loose));
  state.model = integrateViews(viewsOf(state), state.stands, options, {});
  state.settings.registration.limits.fewPairs = 1'000'000;  // all are doubtful from here on
  state = withScans(std::move(state), {testing::smallObject(), {{1, 6.0}}});
  ASSERT_EQ(state.scans[2].status, ScanStatus::In) << name(state.scans[2].record.registration.finding.reason);
  EXPECT_EQ(state.scans[2].record.registration.verdict, Verdict::Doubtful);
  EXPECT_LT(errorOf(state, 2, 6.0), 0.5);
  if (state.scans[1].status == ScanStatus::In) {
    EXPECT_LT(errorOf(state, 1, -8.0), 0.5);
    EXPECT_FALSE(isLoose(state.scans[1]));
  }
}

TEST(HandPlacing, WhatATableHoldsIsNotLoose) {
  AcquisitionState state = scannedByHand({makeBall(), {{0, 0.0}}});
  const Rig rig = testing::simulation(makeBall(), state.profile, {1, true});
  const auto image = std::make_shared<RangeImage>(scanFrom(rig, 2, {}));
  state = addScan(state, {1, image}, std::nullopt, stepOptionsFor(state), {});
  ASSERT_EQ(state.scans[1].record.registration.finding.reason, VerdictReason::HeldByMechanics);
  EXPECT_FALSE(isLoose(state.scans[1]));
}

TEST(HandPlacing, ThePlannerKnowsWhoTurnedLast) {
  const AcquisitionState state = scannedByHand({testing::smallObject(), {{0, 0.0}}});
  const PlanInput input = planInputOf(state);
  ASSERT_TRUE(input.mechanics);
  EXPECT_EQ(input.mechanics->angleSigma, kHand.angleSigma);
  PlanInput byTable = input;
  byTable.mechanics.reset();
  const auto images = testing::smallTools(state.profile).images;
  const Plan hand = planNextView(input, *images, {}, {});
  const Plan table = planNextView(byTable, *images, {}, {});
  ASSERT_EQ(hand.outcome, PlanOutcome::Found);
  EXPECT_FALSE(hand.tableAlone);
  for (std::size_t i = 0; i < hand.scores.size(); ++i)
    EXPECT_LE(hand.scores[i].overlapArea, table.scores[i].overlapArea) << i;
}

TEST(HandPlacing, WhenAPersonTakesOverAndFailsThePlanIsMadeForThem) {
  const auto profile = testing::smallProfile();
  MemoryJournal journal(profile, {});
  const AcquisitionTools tools = testing::smallTools(profile);
  Acquisition acquisition(journal, tools);
  acquisition.scanNext();
  const auto before = journal.state();
  ASSERT_TRUE(before->plan);
  // Something else stands there now.
  const Rig other = testing::simulation(testing::makeBox({-60, -5, 0}, {60, 5, 8}), profile, {1, true});
  RangeImage image = scanFrom(other, *before->plan->position, {});
  image.poseKnownBy = PoseSource::ByHand;
  image.poseUncertainty = kHand;
  acquisition.addScan(std::move(image));
  const auto after = journal.state();
  ASSERT_EQ(after->scans.back().status, ScanStatus::Rejected);
  ASSERT_TRUE(after->plan);
  double least = 0.0;
  for (std::size_t i = 0; i < after->plan->scores.size(); ++i)
    least += before->plan->scores[i].overlapArea - after->plan->scores[i].overlapArea;
  EXPECT_GT(least, 0.0);
}

}  // namespace
}  // namespace vantage
