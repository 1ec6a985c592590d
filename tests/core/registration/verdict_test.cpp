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
  e.stability.weakMotions = {{WeakMotion::Kind::Turn, Vec3::UnitZ()}};
  return e;
}

TEST(Verdict, OfSoundEvidenceIsGood) {
  EXPECT_EQ(judge(sound(), {}).verdict, Verdict::Good);
  EXPECT_EQ(judge(sound(), {}).finding, (Finding{VerdictReason::Inliers, 0.98, {}}));
}

TEST(Verdict, FailsWithoutOverlap) {
  Evidence e = sound();
  e.pairs = 12;
  const Judgement judgement = judge(e, {});
  EXPECT_EQ(judgement.verdict, Verdict::Failed);
  EXPECT_EQ(judgement.finding, (Finding{VerdictReason::FewPairs, 12.0, {}}));
}

TEST(Verdict, EveryFindingAloneTakesTheGoodAway) {
  VerdictLimits limits;
  limits.maxPoseSigma = 0.1;
  const auto worse = [&](auto change, Verdict expected, VerdictReason reason) {
    Evidence e = sound();
    change(e);
    EXPECT_EQ(judge(e, limits).verdict, expected) << name(reason);
    EXPECT_EQ(judge(e, limits).finding.reason, reason);
  };
  worse([](Evidence& e) { e.inlierShare = 0.6; }, Verdict::Doubtful, VerdictReason::FewInliers);
  worse([](Evidence& e) { e.inlierShare = 0.3; }, Verdict::Failed, VerdictReason::FewInliers);
  worse([](Evidence& e) { e.conflictShare = 0.08; }, Verdict::Doubtful, VerdictReason::Conflicts);
  worse([](Evidence& e) { e.conflictShare = 0.3; }, Verdict::Failed, VerdictReason::Conflicts);
  worse([](Evidence& e) { e.residual = 3.0; }, Verdict::Doubtful, VerdictReason::Residual);
  worse([](Evidence& e) { e.residual = 6.0; }, Verdict::Failed, VerdictReason::Residual);
  worse([](Evidence& e) { e.motion = 5.0; }, Verdict::Doubtful, VerdictReason::Motion);
  worse([](Evidence& e) { e.motion = 20.0; }, Verdict::Failed, VerdictReason::Motion);
  worse([](Evidence& e) { e.heldByPrior = 1; }, Verdict::Doubtful, VerdictReason::HeldByMechanics);
  worse([](Evidence& e) { e.stability.poseSigma = 0.5; }, Verdict::Doubtful, VerdictReason::HeldByMechanics);
  worse([](Evidence& e) { e.rivalDistance = 12.0; }, Verdict::Doubtful, VerdictReason::Rival);
  worse([](Evidence& e) { e.settled = false; }, Verdict::Doubtful, VerdictReason::NotSettled);
}

TEST(Verdict, NamesTheMotionsThatThePriorAloneHolds) {
  Evidence e = sound();
  e.heldByPrior = 1;
  EXPECT_EQ(judge(e, {}).finding, (Finding{VerdictReason::HeldByMechanics, {}, e.stability.weakMotions}));
}

// The surface lets go of a motion and disagrees beside: nothing is left that speaks for the pose.
TEST(Verdict, ADoubtIsOneTooManyWhereTheMechanicsHoldThePose) {
  Evidence e = sound();
  e.heldByPrior = 1;
  e.conflictShare = 0.05;
  EXPECT_EQ(judge(e, {}).verdict, Verdict::Failed);
  EXPECT_EQ(judge(e, {}).finding, (Finding{VerdictReason::Conflicts, 0.05, {}}));
  VerdictLimits tolerant;
  tolerant.heldTolerance = 2.0;
  EXPECT_EQ(judge(e, tolerant).verdict, Verdict::Doubtful);
  e.conflictShare = 0.0;
  e.residual = 2.5;
  EXPECT_EQ(judge(e, {}).finding, (Finding{VerdictReason::Residual, 2.5, {}}));
  e.heldByPrior = 0;
  EXPECT_EQ(judge(e, {}).verdict, Verdict::Doubtful);
}

TEST(Verdict, HasAName) {
  EXPECT_EQ(name(Verdict::Good), "good");
  EXPECT_EQ(name(Verdict::Doubtful), "doubtful");
  EXPECT_EQ(name(Verdict::Failed), "failed");
  EXPECT_EQ(name(VerdictReason::NotRegistered), "not_registered");
  EXPECT_EQ(name(VerdictReason::HeldByMechanics), "held_by_mechanics");
  EXPECT_EQ(name(VerdictReason::NotSettled), "not_settled");
  EXPECT_EQ(name(VerdictReason::ContradictsOthers), "contradicts_others");
  EXPECT_EQ(name(VerdictReason::HeldByAll), "held_by_all");
  EXPECT_EQ(name(kLastVerdictReason), "table_in_doubt");
}

}  // namespace
}  // namespace vantage
