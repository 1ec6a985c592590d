#include "completeness_text.h"

#include <gtest/gtest.h>

#include "outlook_text.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// An acquisition with one edge of 10 mm that is left for that reason, and nothing to propose.
AcquisitionState endedWith(EdgeReason reason) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  state.termination = Termination::Finished;
  auto voids = std::make_shared<VoidSurface>();
  voids->patches.emplace_back();
  voids->patches.back().width = 10.0;
  auto plan = std::make_shared<Plan>();
  plan->outcome = PlanOutcome::Finished;
  plan->voids = voids;
  plan->outlook.emplace_back();
  plan->outlook.back().reason = reason;
  state.plan = plan;
  return state;
}

QString valueOf(const CompletenessCard& card, const QString& name) {
  for (const WhyFigure& figure : card.figures)
    if (figure.name.contains(name)) return figure.value;
  return {};
}

TEST(CompletenessCard, AClosedSurfaceIsDone) {
  const CompletenessCard card = makeCompletenessCard(endedWith(EdgeReason::OutOfReach), {1.0, 1.0, 0, 1, true});
  EXPECT_TRUE(card.good);
  EXPECT_EQ(card.headline, "The surface is closed.");
  EXPECT_TRUE(card.advice.contains("can be printed"));
  EXPECT_EQ(valueOf(card, "Closed"), "yes");
}

TEST(CompletenessCard, WhatNoPositionSeesAsksToTurnTheObjectOver) {
  const CompletenessCard card = makeCompletenessCard(endedWith(EdgeReason::OutOfReach), {0.924, 0.47, 9, 7, false});
  EXPECT_FALSE(card.good);
  ASSERT_TRUE(card.reached);
  EXPECT_NEAR(*card.reached, 0.924, 1e-12);
  EXPECT_TRUE(card.headline.startsWith(QString("92") + QChar(QChar::Nbsp) + "% of what the scanner reaches"))
      << card.headline.toStdString();
  EXPECT_TRUE(card.advice.contains("turn it over"));
  EXPECT_EQ(valueOf(card, "Openings"), "9");
  EXPECT_EQ(valueOf(card, "Loose pieces"), "7");
  EXPECT_EQ(valueOf(card, "Closed"), "no");
}

TEST(CompletenessCard, OpeningsThatTheOperatorMadeAreSaidToBe) {
  const CompletenessCard card = makeCompletenessCard(endedWith(EdgeReason::Erased), {1.0, 1.0, 2, 1, false, 2});
  EXPECT_TRUE(card.good);
  EXPECT_TRUE(card.advice.contains("you erased")) << card.advice.toStdString();
  const CompletenessCard some = makeCompletenessCard(endedWith(EdgeReason::OutOfReach), {0.9, 0.9, 2, 1, false, 1});
  EXPECT_TRUE(some.advice.contains("turn it over"));
}

TEST(CompletenessCard, WhatIsNotWholeIsNeverAHundredPerCent) {
  const CompletenessCard card =
      makeCompletenessCard(endedWith(EdgeReason::OutOfReach), {0.99999, 0.99999, 1, 1, false});
  EXPECT_TRUE(card.headline.startsWith("99.9")) << card.headline.toStdString();
  EXPECT_FALSE(valueOf(card, "whole").startsWith("100"));
}

TEST(CompletenessCard, OfRecordedScansNothingIsSaidThatOnlyAPlanKnows) {
  AcquisitionState recorded;
  recorded.termination = Termination::Imported;
  const CompletenessCard card = makeCompletenessCard(recorded, {0.6, 0.6, 3, 1, false});
  EXPECT_FALSE(card.reached);
  EXPECT_EQ(card.headline, "The surface has 3 openings.");
  EXPECT_FALSE(card.advice.contains("position"));
}

TEST(OutlookText, IsAsExactAsAnEstimate) {
  EXPECT_EQ(durationText(0.2), "about 1 s");
  EXPECT_EQ(durationText(7.4), "about 7 s");
  EXPECT_EQ(durationText(43.0), "about 45 s");
  EXPECT_EQ(durationText(171.0), "about 3 min");
  EXPECT_EQ(durationText(8000.0), "about 2 h");
  EXPECT_EQ(outlookText(AcquisitionState{}), "");
}

}  // namespace
}  // namespace vantage
