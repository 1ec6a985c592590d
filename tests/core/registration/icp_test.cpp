#include "registration/icp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "base/errors.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::centroid;
using testing::makeBall;
using testing::makeEggTray;
using testing::makeProfile;
using testing::poseError;
using testing::randomMotion;
using testing::scanFrom;
using testing::scanVase;

RegistrationTarget targetOf(const View& view) {
  return RegistrationTarget(std::span(&view, 1));
}

RegistrationResult registerFrom(const View& view, const Pose& start, const RegistrationTarget& target,
                                const IcpOptions& options = {}, const Progress& progress = {}) {
  return registerView(*view.mesh, *view.image->rays, start, target, options, progress);
}

bool sameBytes(const Pose& a, const Pose& b) {
  return a.matrix() == b.matrix();
}

TEST(Icp, BringsAViewBackFromThreeDegreesAndThreeMillimetres) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeBall(), profile, 0, 1));
  for (const int position : {5, 10}) {  // 20 and 40 degrees apart
    const View view = scanFrom(makeBall(), profile, position, 2);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Pose start = randomMotion(seed, radians(3.0), 3.0, centroid(view)) * view.T_object_scanner;
      const RegistrationResult result = registerFrom(view, start, target);
      // Within a few sigmas of what the registration says of itself, which is small.
      EXPECT_LT(poseError(view, result.T_object_scanner, view.T_object_scanner), 4.0 * result.poseSigma) << position;
      EXPECT_LT(result.poseSigma, 0.04);
      EXPECT_EQ(result.verdict, Verdict::Good) << name(result.finding.reason);
      EXPECT_GT(result.pairs, 1000U);
      EXPECT_NEAR(result.rms, 0.1 * std::sqrt(2.0), 0.06);  // noise of both surfaces
    }
  }
}

TEST(Icp, WithoutNoiseIsExactButForTheTriangles) {
  const auto profile = makeProfile(0.0);
  const RegistrationTarget target = targetOf(scanFrom(makeBall(), profile, 0));
  const View view = scanFrom(makeBall(), profile, 8);
  const Pose start = randomMotion(7, radians(3.0), 3.0, centroid(view)) * view.T_object_scanner;
  // Chords of 1.2 mm on a radius of 60 mm lie 0.003 mm below the surface.
  EXPECT_LT(poseError(view, registerFrom(view, start, target).T_object_scanner, view.T_object_scanner), 0.005);
}

TEST(Icp, MovingStartAndModelMovesTheResult) {
  const auto profile = makeProfile(0.1);
  View first = scanFrom(makeBall(), profile, 0, 1);
  const View view = scanFrom(makeBall(), profile, 8, 2);
  const Pose start = randomMotion(3, radians(2.0), 2.0, centroid(view)) * view.T_object_scanner;
  const RegistrationResult here = registerFrom(view, start, targetOf(first));
  const Pose motion = randomMotion(4, 1.0, 200.0, Vec3::Zero());
  first.T_object_scanner = motion * first.T_object_scanner;
  const RegistrationResult there = registerFrom(view, motion * start, targetOf(first));
  EXPECT_LT(poseError(view, motion * here.T_object_scanner, there.T_object_scanner), 1e-6);
  EXPECT_EQ(here.verdict, there.verdict);
}

TEST(Icp, GivesTheSameBytesForAnyThreadCount) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeBall(), profile, 0, 1));
  const View view = scanFrom(makeBall(), profile, 8, 2);
  const Pose start = randomMotion(5, radians(3.0), 3.0, centroid(view)) * view.T_object_scanner;
  const RegistrationResult one = registerFrom(view, start, target);
  const RegistrationResult three = registerFrom(view, start, target, {}, Progress({}, {}, 3));
  EXPECT_TRUE(sameBytes(one.T_object_scanner, three.T_object_scanner));
  EXPECT_EQ(one.rms, three.rms);
  EXPECT_EQ(one.finding, three.finding);
}

TEST(Icp, LeavesATurnThatNothingHoldsWhereTheTurntablePutIt) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanVase(profile, 0, 1));
  const View view = scanVase(profile, 8, 2);
  IcpOptions options;
  Mechanics mechanics;
  mechanics.angleSigma = radians(1.0);
  mechanics.positionSigma = 1.0;
  options.prior = turntablePrior(mechanics);
  // Shifted sideways, which the vase holds, and turned about z, which it does not.
  Pose off = Pose::Identity();
  off.translate(Vec3(0.5, 0.5, 0.0));
  off.rotate(Eigen::AngleAxisd(radians(0.5), Vec3::UnitZ()));
  const RegistrationResult result = registerFrom(view, off * view.T_object_scanner, target, options);
  EXPECT_EQ(result.verdict, Verdict::Doubtful);
  const WeakMotions turn{{WeakMotion::Kind::Turn, Vec3::UnitZ()}};
  EXPECT_EQ(result.stability.weakMotions, turn);
  EXPECT_EQ(result.finding, (Finding{VerdictReason::HeldByMechanics, {}, turn}));
  const Pose left = result.T_object_scanner * view.T_object_scanner.inverse();
  const Vec6 motion = motionVector(left, Vec3::Zero());
  EXPECT_NEAR(motion[2], radians(0.5), radians(0.05));
  EXPECT_LT(motion.tail<3>().norm(), 0.1);
}

TEST(Icp, FailsWithoutOverlap) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeBall(), profile, 0, 1));
  const View view = scanFrom(makeBall(), profile, 45, 2);  // from behind
  const RegistrationResult result = registerFrom(view, view.T_object_scanner, target);
  EXPECT_EQ(result.verdict, Verdict::Failed);
  EXPECT_EQ(result.finding.reason, VerdictReason::FewPairs);
}

TEST(Icp, FailsAgainstAnEmptyModel) {
  const View view = scanFrom(makeBall(), makeProfile(0.1), 0);
  EXPECT_EQ(registerFrom(view, view.T_object_scanner, RegistrationTarget(Mesh{})).verdict, Verdict::Failed);
}

TEST(Icp, NeverCallsANeighbouringPeriodGood) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeEggTray(), profile, 0, 1));
  const View view = scanFrom(makeEggTray(), profile, 2, 2);
  IcpOptions options;
  options.prior = isotropicPrior(radians(3.0), 6.0, centroid(view));
  for (const double off : {0.5, 4.0, 8.0, 11.0, 12.5}) {
    const Pose start = Eigen::Translation3d(0, off, 0) * view.T_object_scanner;
    const RegistrationResult result = registerFrom(view, start, target, options);
    EXPECT_NE(result.verdict, Verdict::Good) << off;
  }
}

TEST(Icp, TrustsAPeriodThatTheMechanicsSettle) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeEggTray(), profile, 0, 1));
  const View view = scanFrom(makeEggTray(), profile, 2, 2);
  IcpOptions options;
  options.prior = isotropicPrior(radians(0.2), 0.2, centroid(view));
  const Pose start = Eigen::Translation3d(0, 0.3, 0) * view.T_object_scanner;
  const RegistrationResult result = registerFrom(view, start, target, options);
  EXPECT_EQ(result.verdict, Verdict::Good) << name(result.finding.reason);
  EXPECT_LT(poseError(view, result.T_object_scanner, view.T_object_scanner), 0.05);
}

TEST(Icp, NeverCallsAWrongPoseGoodHoweverFarTheStart) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeBall(), profile, 0, 1));
  const View view = scanFrom(makeBall(), profile, 6, 2);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const double angle = radians(5.0 * seed);
    const Pose start = randomMotion(seed, angle, 2.0 * seed, centroid(view)) * view.T_object_scanner;
    IcpOptions options;
    options.prior = isotropicPrior(angle, 2.0 * seed, centroid(view));
    const RegistrationResult result = registerFrom(view, start, target, options);
    if (result.verdict != Verdict::Good) continue;
    EXPECT_LT(poseError(view, result.T_object_scanner, view.T_object_scanner), 0.1) << seed;
  }
}

TEST(Icp, DistrustsAPoseFarFromTheMechanics) {
  const auto profile = makeProfile(0.1);
  const RegistrationTarget target = targetOf(scanFrom(makeBall(), profile, 0, 1));
  const View view = scanFrom(makeBall(), profile, 6, 2);
  IcpOptions options;
  options.prior = isotropicPrior(radians(0.05), 0.05, centroid(view));
  const Pose start = Eigen::Translation3d(1.0, 1.0, 0) * view.T_object_scanner;
  EXPECT_EQ(registerFrom(view, start, target, options).verdict, Verdict::Failed);
}

TEST(Icp, StopsWhenAsked) {
  const auto profile = makeProfile(0.1);
  const View view = scanFrom(makeBall(), profile, 0);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)registerFrom(view, view.T_object_scanner, targetOf(view), {}, Progress({}, stop.get_token(), 1)),
               Cancelled);
}

TEST(Icp, RefusesGatesThatContradictEachOther) {
  const View view = scanFrom(makeBall(), makeProfile(0.1), 0);
  IcpOptions options;
  options.coarseGate = 0.1;
  options.finalGate = 0.8;
  EXPECT_THROW((void)registerFrom(view, view.T_object_scanner, targetOf(view), options), InvalidInput);
}

}  // namespace
}  // namespace vantage
