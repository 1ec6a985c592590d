#include "composites/alignment_verdict.h"

#include <gtest/gtest.h>

#include <set>

#include "composites/aligned_pose.h"

namespace vantage {
namespace {

const AlignmentLimits kLimits{{1.2, 0.1, 160.0}, 160.0};

AlignedPose poseWith(const PoseEvidence& evidence, double leastInformation = 0.01) {
  AlignedPose pose;
  pose.evidence = evidence;
  pose.score = scoreOf(evidence, kLimits, kFineTolerance);
  pose.leastInformation = leastInformation;
  return pose;
}

AlignmentJudgement judged(const std::vector<AlignedPose>& poses) {
  return judgeAlignment(poses, kLimits, {});
}

const PoseEvidence kRight{0.5, 0.1, 0.0, 0.0, 0.0};

TEST(AlignmentVerdict, OnePossiblePoseIsGood) {
  const auto judgement = judged({poseWith(kRight), poseWith({0.6, 0.1, 0.02, 0.0, 0.0})});
  EXPECT_EQ(judgement.verdict, AlignmentVerdict::Good);
  EXPECT_EQ(judgement.reason, AlignmentReason::OnePose);
  EXPECT_EQ(judgement.choice, std::vector<std::size_t>{0});
}

TEST(AlignmentVerdict, CompositesThatDoNotFitThemselvesBetterNeedNotFitEachOther) {
  const std::vector<AlignedPose> poses{poseWith({0.5, 0.25, 0.0, 0.0, 0.0})};
  EXPECT_EQ(judged(poses).reason, AlignmentReason::OtherObject);
  AlignmentLimits limits = kLimits;
  limits.residual = 0.2;
  EXPECT_EQ(judgeAlignment(poses, limits, {}).verdict, AlignmentVerdict::Good);
  // But for what is no fit at all.
  limits.residual = 2.0;
  EXPECT_EQ(judgeAlignment({{poseWith({0.5, 0.35, 0.0, 0.0, 0.0})}}, limits, {}).reason, AlignmentReason::OtherObject);
}

TEST(AlignmentVerdict, TwoThatArePossibleAreAmbiguous) {
  const auto judgement = judged({poseWith(kRight), poseWith({0.4, 0.12, 0.001, 0.0, 0.0})});
  EXPECT_EQ(judgement.verdict, AlignmentVerdict::Ambiguous);
  EXPECT_EQ(judgement.reason, AlignmentReason::SeveralPoses);
  EXPECT_EQ(judgement.value, 2.0);
  EXPECT_EQ(judgement.choice, (std::vector<std::size_t>{0, 1}));
}

TEST(AlignmentVerdict, ARivalThatFitsFarWorseIsNone) {
  EXPECT_EQ(judged({poseWith(kRight), poseWith({0.5, 0.28, 0.0, 0.0, 0.0})}).verdict, AlignmentVerdict::Good);
  EXPECT_EQ(judged({poseWith(kRight), poseWith({0.1, 0.1, 0.0, 0.0, 0.0})}).verdict, AlignmentVerdict::Good);
}

TEST(AlignmentVerdict, ARivalThatHasToBendTheCompositesIsNone) {
  std::vector<AlignedPose> poses{poseWith(kRight), poseWith({0.5, 0.2, 0.0, 0.0, 0.0})};
  for (AlignedPose& pose : poses) pose.refinement = JointRefinement{};
  poses[0].refinement->tension = 2.5;
  poses[1].refinement->tension = 4.0;
  EXPECT_EQ(judged(poses).verdict, AlignmentVerdict::Ambiguous);
  poses[1].refinement->tension = 6.0;
  EXPECT_EQ(judged(poses).verdict, AlignmentVerdict::Good);
}

TEST(AlignmentVerdict, WhatSlidesIsAmbiguous) {
  const auto judgement = judged({poseWith(kRight, 1e-5)});
  EXPECT_EQ(judgement.verdict, AlignmentVerdict::Ambiguous);
  EXPECT_EQ(judgement.reason, AlignmentReason::Slides);
}

TEST(AlignmentVerdict, FailuresSayWhy) {
  EXPECT_EQ(judged({}).reason, AlignmentReason::TooLittleOverlap);
  EXPECT_EQ(judged({poseWith({0.01, 0.1, 0.0, 0.0, 0.0})}).reason, AlignmentReason::TooLittleOverlap);
  EXPECT_EQ(judged({poseWith({0.6, 0.1, 0.02, 0.0, 0.0})}).reason, AlignmentReason::Contradiction);
  EXPECT_EQ(judged({poseWith({0.6, 0.1, 0.0, 0.01, 0.0})}).reason, AlignmentReason::Contradiction);
  EXPECT_EQ(judged({poseWith({0.6, 0.1, 0.0, 0.0, 0.2})}).reason, AlignmentReason::Contradiction);
  EXPECT_EQ(judged({poseWith({0.2, 0.6, 0.1, 0.0, 0.0})}).reason, AlignmentReason::OtherObject);
  AlignedPose pose = poseWith({0.5, 0.5, 0.0, 0.0, 0.0});
  pose.refinement = JointRefinement{};
  EXPECT_EQ(judged({pose}).reason, AlignmentReason::OtherObject);
  pose.refinement->tension = 12.0;
  const auto bent = judged({pose});
  EXPECT_EQ(bent.reason, AlignmentReason::BentComposite);
  EXPECT_EQ(bent.value, 12.0);
  EXPECT_EQ(bent.verdict, AlignmentVerdict::Failed);
  pose.evidence.conflict = 0.2;
  EXPECT_EQ(judged({pose}).reason, AlignmentReason::OtherObject);
}

TEST(AlignmentVerdict, SaysWhenACompositeGaveInTooFar) {
  AlignedPose pose = poseWith(kRight);
  pose.refinement = JointRefinement{};
  EXPECT_FALSE(judged({pose}).bent);
  pose.refinement->tension = 12.0;
  EXPECT_TRUE(judged({pose}).bent);
}

TEST(AlignmentVerdict, EveryReasonHasAName) {
  std::set<std::string_view> names;
  for (int k = 0; k <= static_cast<int>(kLastAlignmentReason); ++k) names.insert(name(static_cast<AlignmentReason>(k)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kLastAlignmentReason) + 1);
  EXPECT_EQ(name(AlignmentVerdict::Ambiguous), "ambiguous");
  EXPECT_EQ(name(AlignmentReason::OtherObject), "other_object");
}

}  // namespace
}  // namespace vantage
