#include "registration/verdict.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

// What a registration has to show when nothing is wrong.
Evidence sound() {
  Evidence e;
  e.pairs = 5000;
  e.inlierShare = 0.98;
  e.residual = 0.9;
  e.motion = 1.0;
  e.settled = true;
  e.stability.poseSigma = 0.02;
  e.stability.weakName = "turns about z";
  return e;
}

TEST(Verdict, OfSoundEvidenceIsGood) {
  EXPECT_EQ(judge(sound(), {}).verdict, Verdict::Good);
}

TEST(Verdict, FailsWithoutOverlap) {
  Evidence e = sound();
  e.pairs = 12;
  const Judgement judgement = judge(e, {});
  EXPECT_EQ(judgement.verdict, Verdict::Failed);
  EXPECT_EQ(judgement.reason, "only 12 points overlap with the model");
}

TEST(Verdict, EveryFindingAloneTakesTheGoodAway) {
  const auto worse = [](auto change, Verdict expected) {
    Evidence e = sound();
    change(e);
    EXPECT_EQ(judge(e, {}).verdict, expected) << judge(e, {}).reason;
  };
  worse([](Evidence& e) { e.inlierShare = 0.6; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.inlierShare = 0.3; }, Verdict::Failed);
  worse([](Evidence& e) { e.conflictShare = 0.08; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.conflictShare = 0.3; }, Verdict::Failed);
  worse([](Evidence& e) { e.residual = 3.0; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.residual = 6.0; }, Verdict::Failed);
  worse([](Evidence& e) { e.motion = 5.0; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.motion = 20.0; }, Verdict::Failed);
  worse([](Evidence& e) { e.heldByPrior = 1; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.stability.poseSigma = 0.5; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.rivalDistance = 12.0; }, Verdict::Doubtful);
  worse([](Evidence& e) { e.settled = false; }, Verdict::Doubtful);
}

TEST(Verdict, SaysWhatThePriorAloneHolds) {
  Evidence e = sound();
  e.heldByPrior = 1;
  EXPECT_NE(judge(e, {}).reason.find("turns about z"), std::string::npos);
}

TEST(Verdict, HasAName) {
  EXPECT_EQ(name(Verdict::Good), "good");
  EXPECT_EQ(name(Verdict::Doubtful), "doubtful");
  EXPECT_EQ(name(Verdict::Failed), "failed");
}

}  // namespace
}  // namespace vantage
