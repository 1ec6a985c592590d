#include "report/wording.h"

#include <gtest/gtest.h>

#include <set>

namespace vantage {
namespace {

using Kind = WeakMotion::Kind;

TEST(Wording, NamesMotionsByTheirAxes) {
  EXPECT_EQ(describe(WeakMotions{}), "");
  EXPECT_EQ(describe(WeakMotion{}), "moves freely");
  EXPECT_EQ(describe(WeakMotion{Kind::Turn, Vec3(0.7, -0.7, 0.0)}), "turns about (0.7, -0.7, 0.0)");
  EXPECT_EQ(describe(WeakMotions{{Kind::Slide, Vec3::UnitX()}, {Kind::Turn, Vec3::UnitZ()}}),
            "slides along x and turns about z");
}

TEST(Wording, SaysWhatAVerdictRestsOnWithItsFigure) {
  EXPECT_EQ(describe(Finding{VerdictReason::Inliers, 0.974, {}}), "97 % of the expected overlap fits");
  EXPECT_EQ(describe(Finding{VerdictReason::FewInliers, 0.3, {}}), "only 30 % of the expected overlap fits");
  EXPECT_EQ(describe(Finding{VerdictReason::FewPairs, 12.0, {}}), "only 12 points overlap with the model");
  EXPECT_EQ(describe(Finding{VerdictReason::Conflicts, 0.08, {}}),
            "the scanner looked through 8 % of the model's surface");
  EXPECT_EQ(describe(Finding{VerdictReason::Residual, 2.61, {}}),
            "the surfaces differ 2.6 times as much as their noise explains");
  EXPECT_EQ(describe(Finding{VerdictReason::Motion, 11.4, {}}),
            "it moved 11.4 sigma away from where the mechanics put it");
  EXPECT_EQ(describe(Finding{VerdictReason::Rival, 12.34, {}}), "a pose 12.3 mm away fits as well");
  EXPECT_EQ(describe(Finding{VerdictReason::HeldByMechanics, {}, {{Kind::Turn, Vec3::UnitZ()}}}),
            "the surface turns about z: that part of the pose is the mechanics' word alone");
}

TEST(Wording, SaysSomethingOfItsOwnForEveryReason) {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(kLastVerdictReason); ++i)
    texts.insert(describe(Finding{static_cast<VerdictReason>(i), {}, {}}));
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(kLastVerdictReason) + 1);
  EXPECT_FALSE(texts.contains(""));
}

TEST(Wording, TellsWhatACommandDid) {
  EXPECT_EQ(describe(Command(AddScan{3, {}})), "Scan 3 added");
  EXPECT_EQ(describe(Command(ImportScans{{1, 2}})), "2 recorded scans imported");
  EXPECT_EQ(describe(Command(LeaveOutView{4})), "Scan 4 left out");
  EXPECT_EQ(describe(Command(Finish{Termination::Running})), "Opened again");
  EXPECT_EQ(describe(Command(Finish{Termination::NoOverlap})), "Ended: no_overlap");
}

TEST(Wording, SaysThatWhatIsBelowTheThresholdMayStillBeScanned) {
  EXPECT_NE(sentenceOf(EdgeReason::BelowThreshold, PlanOutcome::Found),
            sentenceOf(EdgeReason::BelowThreshold, PlanOutcome::Finished));
  EXPECT_EQ(sentenceOf(EdgeReason::Answered, PlanOutcome::Found),
            sentenceOf(EdgeReason::Answered, PlanOutcome::Finished));
}

TEST(Wording, SaysWhatOfAScanIsWorkedOn) {
  EXPECT_EQ(thinningText(1), "every row and column");
  EXPECT_EQ(thinningText(2), "every 2nd row and column");
  EXPECT_EQ(thinningText(3), "every 3rd row and column");
  EXPECT_EQ(thinningText(4), "every 4th row and column");
  EXPECT_EQ(thinningText(12), "every 12th row and column");
  EXPECT_EQ(thinningText(21), "every 21st row and column");
}

}  // namespace
}  // namespace vantage
