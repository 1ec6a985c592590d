#include "registration/pose_prior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

Vec6 someMotion(double size) {
  Vec6 x;
  x << 0.3, -0.2, 0.1, 1.0, 2.0, -3.0;
  return size * x;
}

TEST(PosePrior, MotionVectorUndoesMotionAbout) {
  const Vec3 centre(10, 20, 30);
  EXPECT_TRUE(motionVector(motionAbout(centre, someMotion(1.0)), centre).isApprox(someMotion(1.0), 1e-12));
}

TEST(PosePrior, ChangeOfCentreDescribesTheSameSmallMotion) {
  const Vec3 from(10, 20, 30);
  const Vec3 to(-5, 0, 8);
  const Vec6 x = someMotion(1e-6);
  const Vec6 there = motionVector(motionAbout(from, x), to);
  EXPECT_TRUE((changeOfCentre(from, to) * x).isApprox(there, 1e-5));
}

TEST(PosePrior, InformationIsThatOfTheMotionAroundThePriorsCentre) {
  const PosePrior prior = isotropicPrior(0.1, 2.0, Vec3(1, 2, 3));
  const Vec3 centre(50, 0, 0);
  const Vec6 x = someMotion(1e-6);
  const Vec6 own = motionVector(motionAbout(centre, x), prior.centre);
  EXPECT_NEAR(x.dot(informationAbout(prior, centre) * x), own.dot(prior.information * own), 1e-15);
}

TEST(PosePrior, OfATurntableIsLooseAboutItsAxisOnly) {
  Mechanics mechanics;
  mechanics.angleSigma = radians(0.3);
  mechanics.positionSigma = 0.2;
  const PosePrior prior = turntablePrior(mechanics);
  EXPECT_NEAR(1.0 / std::sqrt(prior.information(2, 2)), radians(0.3), 1e-12);
  EXPECT_NEAR(1.0 / std::sqrt(prior.information(0, 0)), radians(0.05), 1e-12);
  EXPECT_NEAR(1.0 / std::sqrt(prior.information(3, 3)), 0.2, 1e-12);
  EXPECT_NEAR(1.0 / std::sqrt(prior.information(5, 5)), 0.05, 1e-12);
}

TEST(PosePrior, OfATurntableWidensWithTheRootOfTheMoves) {
  Mechanics mechanics;
  mechanics.angleSigma = radians(0.3);
  mechanics.positionSigma = 0.2;
  const double once = turntablePrior(mechanics, 1).information(2, 2);
  EXPECT_NEAR(turntablePrior(mechanics, 4).information(2, 2), once / 4.0, 1e-9 * once);
}

TEST(PosePrior, RefusesSigmasThatAreNotPositive) {
  EXPECT_THROW((void)isotropicPrior(0.0, 1.0, Vec3::Zero()), InvalidInput);
  EXPECT_THROW((void)isotropicPrior(1.0, -1.0, Vec3::Zero()), InvalidInput);
}

}  // namespace
}  // namespace vantage
