#include "why_card.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

// Three positions: 0 overlaps too little, 1 is chosen, 2 is allowed.
std::shared_ptr<const Plan> makePlan() {
  auto plan = std::make_shared<Plan>();
  auto voids = std::make_shared<VoidSurface>();
  voids->patches.resize(2);
  voids->patches[1].edgeClass = EdgeClass::Rim;
  for (VoidPatch& patch : voids->patches) patch.weight = 12.5;
  voids->patches[0].edgeClass = EdgeClass::OuterJump;
  plan->voids = voids;
  plan->outcome = PlanOutcome::Found;
  plan->position = 1;
  plan->leastOverlap = 200.0;
  plan->terminationThreshold = 25.0;
  for (const auto& [voidArea, overlap, constraint, shortBy] :
       {std::tuple{900.0, 150.0, Constraint::OverlapShort, 50.0}, std::tuple{600.0, 800.0, Constraint::Chosen, 0.0},
        std::tuple{450.0, 1000.0, Constraint::Outscored, 0.0}}) {
    PositionScore score;
    score.position = static_cast<int>(plan->scores.size());
    score.voidArea = voidArea;
    score.overlapArea = overlap;
    score.constraint = constraint;
    score.shortBy = shortBy;
    plan->scores.push_back(score);
  }
  plan->scores[1].tracedVoidArea = 620.0;
  plan->scores[1].patches = {0, 1};
  plan->scores[1].poseSigma = 0.0123;
  plan->scores[1].weakMotions = {{WeakMotion::Kind::Turn, Vec3::UnitZ()}};
  return plan;
}

WhyCard cardOf(int position, PositionRole role = PositionRole::None, bool planHolds = true) {
  const auto plan = makePlan();
  return makeWhyCard({explain(*plan, position), plan, nullptr, nullptr, role, planHolds});
}

const WhyFigure* find(const std::vector<WhyFigure>& figures, const QString& name) {
  for (const WhyFigure& figure : figures)
    if (figure.name.contains(name)) return &figure;
  return nullptr;
}

TEST(WhyCard, SaysWhatTheProposedPositionWinsAndWhatRegistrationWillBeWorth) {
  const WhyCard card = cardOf(1);
  EXPECT_EQ(card.title, "Position 1");
  EXPECT_TRUE(card.verdict.startsWith("Proposed"));
  EXPECT_EQ(find(card.figures, "o_v")->value, "620\u00a0mm²");
  EXPECT_EQ(find(card.figures, "by positional space")->value, "600\u00a0mm²");
  EXPECT_EQ(find(card.figures, "o_s")->value, "800\u00a0mm²");
  EXPECT_EQ(find(card.figures, "Registration error")->value, "0.012 mm");
  EXPECT_TRUE(find(card.figures, "Registration error")->remark.contains("turns about z"));
  EXPECT_EQ(find(card.figures, "edges it wins")->value, "2");
  EXPECT_EQ(find(card.figures, "edges it wins")->remark, "1 × edge against the background, 1 × rim of the scan");
  EXPECT_EQ(card.comparison, "The runner-up, position 2, shows 170\u00a0mm² less and overlaps 200\u00a0mm² more.");
}

TEST(WhyCard, NamesTheConstraintThatBindsAndByHowMuch) {
  const WhyCard card = cardOf(0);
  EXPECT_TRUE(card.verdict.contains("overlap"));
  EXPECT_TRUE(card.verdict.contains("short by 50.0\u00a0mm²"));
  EXPECT_TRUE(find(card.figures, "o_s")->remark.contains("t = 200\u00a0mm²"));
  EXPECT_EQ(card.comparison, "The proposed position 1 shows 280\u00a0mm² less and overlaps 650\u00a0mm² more.");
}

TEST(WhyCard, ComparesAnAllowedPositionWithTheChoice) {
  EXPECT_EQ(cardOf(2).comparison, "The proposed position 1 shows 170\u00a0mm² more and overlaps 200\u00a0mm² less.");
}

TEST(WhyCard, AddsWhatKeepsPatchesFromSightOnceItIsComputed) {
  const auto plan = makePlan();
  auto sight = std::make_shared<PositionSight>();
  sight->patches = {{Visibility::LightBlocked, 0.5, 77}, {Visibility::Seen, 0.9, kNoIndex}};
  sight->counts[static_cast<std::size_t>(Visibility::LightBlocked)] = 1;
  sight->areas[static_cast<std::size_t>(Visibility::LightBlocked)] = 12.5;
  const WhyCard card = makeWhyCard({explain(*plan, 2), plan, sight, nullptr});
  const WhyFigure* light = find(card.sights, "light blocked");
  ASSERT_NE(light, nullptr);
  EXPECT_EQ(light->value, "12.5\u00a0mm²");
  EXPECT_EQ(light->remark, "1 edge");
  EXPECT_EQ(card.sights.size(), kVisibilities);
}

TEST(WhyCard, SaysAlsoThatWhatShowsTooLittleCouldNotBeRegistered) {
  auto plan = std::make_shared<Plan>(*makePlan());
  plan->scores[2].constraint = Constraint::BelowThreshold;
  const auto verdict = [&] { return makeWhyCard({explain(*plan, 2), plan, nullptr, nullptr}).verdict; };
  EXPECT_FALSE(verdict().contains("too little to be registered"));
  plan->scores[2].overlapArea = 0.0;
  EXPECT_TRUE(verdict().contains("too little to be registered"));
}

TEST(Figures, AreGroupedFromFiveDigitsOn) {
  EXPECT_EQ(figureText(9999.0), "9999");
  EXPECT_EQ(figureText(31179.0), QString::fromUtf8("31\u202f179"));
  EXPECT_EQ(figureText(-1234567.25, 2), QString::fromUtf8("-1\u202f234\u202f567.25"));
  EXPECT_EQ(countText(60000), QString::fromUtf8("60\u202f000"));
}

TEST(WhyCard, SaysWhenNothingElseIsAllowed) {
  auto plan = std::make_shared<Plan>(*makePlan());
  plan->scores[2].constraint = Constraint::BelowThreshold;
  EXPECT_EQ(makeWhyCard({explain(*plan, 1), plan, nullptr, nullptr}).comparison, "No other position is allowed.");
}

TEST(WhyCard, SaysWhenTheModelIsThatOfAStandAlone) {
  const auto plan = makePlan();
  const auto verdict = [&](int composite) {
    return makeWhyCard({explain(*plan, 1), plan, nullptr, nullptr, PositionRole::None, true, composite}).verdict;
  };
  EXPECT_FALSE(verdict(0).contains("stand"));
  EXPECT_TRUE(
      verdict(2).endsWith("The model here is that of stand 2 alone, which is not put together with the object yet."));
}

TEST(WhyCard, SpeaksOfTheOperatorsChoiceAndWhatThePlanSaysOfIt) {
  const WhyCard card = cardOf(0, PositionRole::OperatorsChoice);
  EXPECT_TRUE(card.verdict.startsWith("Your choice: the next scan is taken from here. Rejected:"));
  EXPECT_TRUE(card.comparison.startsWith("The proposed position 1"));
}

TEST(WhyCard, AfterAFailedScanTheNextPositionIsNotTheOneThatThePlanHadProposed) {
  EXPECT_FALSE(cardOf(1, PositionRole::None, false).verdict.startsWith("Proposed"));
  EXPECT_TRUE(cardOf(1, PositionRole::Failed, false).verdict.startsWith("A scan from here did not fit."));
  const WhyCard next = cardOf(2, PositionRole::AfterFailure, false);
  EXPECT_TRUE(next.verdict.startsWith("Next, as the scan before did not fit"));
  EXPECT_TRUE(next.comparison.startsWith("Position 1, which the plan had proposed,"));
}

}  // namespace
}  // namespace vantage
