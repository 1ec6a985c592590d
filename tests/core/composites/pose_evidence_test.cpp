#include "composites/pose_evidence.h"

#include <gtest/gtest.h>

#include <stop_token>

#include "base/errors.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

const testing::TwoStands& stands() {
  return testing::oddBodyInTwoStands();
}

AlignmentLimits limits() {
  return limitsOf(stands().reference.scale(), stands().moved.scale());
}

PoseEvidence evidenceAt(const Pose& T) {
  return evidenceOf(stands().reference, stands().moved, T, limits());
}

TEST(PoseEvidence, NothingSpeaksAgainstTheTruth) {
  const PoseEvidence right = evidenceAt(stands().T_reference_moved);
  EXPECT_GT(right.overlap, 0.3);
  EXPECT_LE(right.contradiction(), 0.001);
  EXPECT_LT(right.missing, 0.03);
}

TEST(PoseEvidence, RaysGoThroughSurfaceThatIsOutOfPlace) {
  Pose aside = stands().T_reference_moved;
  aside.pretranslate(Vec3(9, 0, 0));
  EXPECT_GT(evidenceAt(aside).conflict, 0.05);
}

TEST(PoseEvidence, NothingIsBelowTheTable) {
  Pose down = stands().T_reference_moved;
  down.pretranslate(Vec3(0, 0, -15));
  EXPECT_GT(evidenceAt(down).table, 0.02);
}

// A post that stands beside what the other composite shows, where its rays found nothing.
TEST(PoseEvidence, SurfaceThatScansShouldHaveSeenIsMissing) {
  const Mesh low = testing::makeBox(Vec3(-25, -25, 0), Vec3(25, 25, 30), 5);
  const Mesh tall = testing::joined(low, testing::makeBox(Vec3(-10, -10, 30), Vec3(10, 10, 80), 4));
  const CompositeModel a(testing::acquireStand(low, Pose::Identity()));
  const CompositeModel b(testing::acquireStand(tall, Pose::Identity()));
  const PoseEvidence evidence = evidenceOf(a, b, Pose::Identity(), limitsOf(a.scale(), b.scale()));
  EXPECT_GT(evidence.missing, 0.1);
  EXPECT_LT(evidence.contradiction(), 0.01);
}

TEST(PoseEvidence, IsTheSameForAnyNumberOfThreadsAndStops) {
  Pose aside = stands().T_reference_moved;
  aside.pretranslate(Vec3(4, 3, 1));
  const PoseEvidence one = evidenceAt(aside);
  const PoseEvidence four = evidenceOf(stands().reference, stands().moved, aside, limits(), Progress().withThreads(4));
  EXPECT_EQ(one.conflict, four.conflict);
  EXPECT_EQ(one.missing, four.missing);
  EXPECT_EQ(one.rms, four.rms);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(evidenceOf(stands().reference, stands().moved, aside, limits(),
                                            Progress({}, source.get_token(), 2))),
               Cancelled);
}

}  // namespace
}  // namespace vantage
