#include "acquisition/loop_closing.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

constexpr Mechanics kHand{radians(7.5), 3.0};

// Views of the small object where they were taken, the first good, the others as scans that fit doubtful ones only.
AcquisitionState takenFrom(const std::vector<int>& positions, bool byHand) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  const Rig rig = testing::simulation(testing::smallObject(), state.profile, {1, true});
  for (const int position : positions) {
    auto image = std::make_shared<RangeImage>(scanFrom(rig, position, {}));
    if (byHand) image->poseUncertainty = kHand;
    KeptScan scan = keepAsView({static_cast<std::int64_t>(state.scans.size()), image}, {}, {});
    scan.view.T_object_scanner = state.profile->workspace.poses[static_cast<std::size_t>(position)];
    RegistrationResult& registration = scan.record.registration;
    registration.verdict = state.scans.empty() ? Verdict::Good : Verdict::Doubtful;
    registration.finding.reason = state.scans.empty() ? VerdictReason::FirstView : VerdictReason::OnDoubtful;
    registration.poseSigma = 0.05;
    state.scans.push_back(std::move(scan));
  }
  return state;
}

AcquisitionState lifted(AcquisitionState state) {
  std::vector<View> views;
  for (const KeptScan& scan : state.scans) views.push_back(scan.view);
  const std::vector<PreparedView> prepared = prepareViews(views, {});
  const MultiViewResult refined = refineViews(views, {});
  for (std::size_t i = 0; i < views.size(); ++i) state.scans[i].view.T_object_scanner = refined.poses[i];
  StepOptions options = stepOptionsFor(state);
  options.registration.limits.fewPairs = 50;  // the scans are small
  liftClosedLoops(state, prepared, refined, options, {});
  return state;
}

std::vector<VerdictReason> reasonsOf(const AcquisitionState& state) {
  std::vector<VerdictReason> reasons;
  for (const KeptScan& scan : state.scans) {
    const RegistrationResult& registration = scan.record.registration;
    EXPECT_EQ(registration.verdict == Verdict::Good, registration.finding.reason == VerdictReason::FirstView ||
                                                         registration.finding.reason == VerdictReason::HeldByAll);
    reasons.push_back(registration.finding.reason);
  }
  return reasons;
}

using enum VerdictReason;

TEST(LoopClosing, AChainWaits) {
  const AcquisitionState state = lifted(takenFrom({0, 4, 8}, true));
  EXPECT_EQ(reasonsOf(state), (std::vector{FirstView, OnDoubtful, OnDoubtful}));
}

TEST(LoopClosing, ALoopThroughTheFirstViewMakesAllOfItGood) {
  const AcquisitionState state = lifted(takenFrom({0, 2, 4, 1}, true));
  EXPECT_EQ(reasonsOf(state), (std::vector{FirstView, HeldByAll, HeldByAll, HeldByAll}));
  for (const KeptScan& scan : state.scans) EXPECT_LT(scan.record.registration.poseSigma, 0.2);
}

TEST(LoopClosing, WhereMoreViewsHoldEachOtherTheFirstOneIsInDoubt) {
  const AcquisitionState state = lifted(takenFrom({12, 0, 2, 4, 1}, true));
  EXPECT_EQ(reasonsOf(state), (std::vector{HeldByFew, HeldByAll, HeldByAll, HeldByAll, HeldByAll}));
  EXPECT_GT(state.scans[0].record.registration.poseSigma, 1.0);
}

TEST(LoopClosing, ATableKnowsWhereItsViewsAre) {
  const AcquisitionState state = lifted(takenFrom({12, 0, 2, 4, 1}, false));
  EXPECT_EQ(reasonsOf(state), (std::vector{FirstView, OnDoubtful, OnDoubtful, OnDoubtful, OnDoubtful}));
}

TEST(LoopClosing, NothingIsSettledWhereSomethingSpeaksAgainstThePose) {
  RegistrationResult registration;
  registration.verdict = Verdict::Doubtful;
  for (const VerdictReason reason : {HeldByMechanics, TableAlone, OnDoubtful, HeldByFew}) {
    registration.finding.reason = reason;
    EXPECT_TRUE(waitsForMore(registration)) << name(reason);
  }
  for (const VerdictReason reason : {Conflicts, Rival, Residual, Motion}) {
    registration.finding.reason = reason;
    EXPECT_FALSE(waitsForMore(registration)) << name(reason);
  }
  registration.verdict = Verdict::Good;
  EXPECT_FALSE(waitsForMore(registration));
}

}  // namespace
}  // namespace vantage
