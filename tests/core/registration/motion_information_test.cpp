#include "registration/motion_information.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/errors.h"
#include "base/random.h"
#include "registration/weak_direction.h"

namespace vantage {
namespace {

using Kind = WeakMotion::Kind;

struct Cloud {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;

  [[nodiscard]] Stability analyse(const StabilityOptions& options = {}) const {
    return analyseStability(points, normals, {}, options);
  }
};

// The square of side 20 in a plane through `centre` with normal z: 21 x 21 points.
Cloud plane() {
  Cloud cloud;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      cloud.points.emplace_back(i, j, 5.0);
      cloud.normals.emplace_back(0, 0, 1);
    }
  }
  return cloud;
}

// Radius 10 about z, height 40, evenly sampled.
Cloud cylinder() {
  Cloud cloud;
  for (int i = -20; i <= 20; ++i) {
    for (int j = 0; j < 36; ++j) {
      const double a = 2.0 * kPi * j / 36;
      cloud.points.emplace_back(10 * std::cos(a), 10 * std::sin(a), i);
      cloud.normals.emplace_back(std::cos(a), std::sin(a), 0);
    }
  }
  return cloud;
}

Cloud sphere() {
  Cloud cloud;
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 d = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    cloud.points.push_back(Vec3(1, 2, 3) + 10.0 * d);
    cloud.normals.push_back(d);
  }
  return cloud;
}

// Three unequal sides of a box's corner: holds everything.
Cloud corner() {
  Cloud cloud;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; j <= 10 + 3 * axis; ++j) {
        Vec3 p = Vec3::Zero();
        p[(axis + 1) % 3] = i;
        p[(axis + 2) % 3] = j;
        cloud.points.push_back(p);
        cloud.normals.push_back(Vec3::Unit(axis));
      }
    }
  }
  return cloud;
}

TEST(MotionInformation, OfOnePointIsTheOuterProductOfItsMotion) {
  MotionSums sums;
  sums.add(Vec3(1, 2, 3), Vec3(0, 0, 1), 2.0, 0.0);
  // (1, 2, 3) x (0, 0, 1) = (2, -1, 0).
  Vec6 j;
  j << 2, -1, 0, 0, 0, 1;
  EXPECT_TRUE(sums.pairs.isApprox(2.0 * j * j.transpose()));
}

TEST(MotionInformation, PretendedIsTheMeanOfWhatNoisyNormalsAdd) {
  // For a normal along z the noise tilts it along x and y: J for those two normals.
  const Vec3 d(1, 2, 3);
  MotionSums sums;
  sums.add(d, Vec3::UnitZ(), 1.0, 0.1);
  Mat6 expected = Mat6::Zero();
  for (int axis = 0; axis < 2; ++axis) {
    Vec6 j;
    j << d.cross(Vec3::Unit(axis)), Vec3::Unit(axis);
    expected += 0.01 * j * j.transpose();
  }
  EXPECT_TRUE(sums.pretended().isApprox(expected));
}

TEST(Stability, OfAPlaneLetsItSlideAndTurnInItself) {
  const Stability s = plane().analyse();
  // 441 points, noise 0.1 mm: across the plane each adds 1 / 0.01.
  EXPECT_NEAR(s.information(5, 5), 441 / 0.01, 1e-6);
  EXPECT_NEAR(s.eigenvalues[2], 0.0, 1e-9 * s.eigenvalues[5]);
  EXPECT_GT(s.eigenvalues[3], 0.1 * s.eigenvalues[5]);
  EXPECT_EQ(s.weakMotions,
            (WeakMotions{{Kind::Slide, Vec3::UnitX()}, {Kind::Slide, Vec3::UnitY()}, {Kind::Turn, Vec3::UnitZ()}}));
  EXPECT_EQ(s.poseSigma, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(s.centre.isApprox(Vec3(0, 0, 5)));
  // Mean square of -10..10 is 110 / 3, for x and for y.
  EXPECT_NEAR(s.radius, std::sqrt(2.0 * 110.0 / 3.0), 1e-9);
}

TEST(Stability, OfACylinderLetsItSlideAndTurnAlongItsAxis) {
  const Stability s = cylinder().analyse();
  EXPECT_NEAR(s.eigenvalues[1], 0.0, 1e-9 * s.eigenvalues[5]);
  EXPECT_GT(s.eigenvalues[2], 1e-3 * s.eigenvalues[5]);
  EXPECT_EQ(s.weakMotions, (WeakMotions{{Kind::Slide, Vec3::UnitZ()}, {Kind::Turn, Vec3::UnitZ()}}));
}

TEST(Stability, NamesTheAxisOfATurnThatLiesBesideThePoints) {
  // A quarter of a cylinder, its centroid off the axis, held along z by some points of its floor.
  Cloud cloud;
  const Cloud full = cylinder();
  for (std::size_t i = 0; i < full.points.size(); ++i) {
    if (full.points[i].x() < 0.0 || full.points[i].y() < 0.0) continue;
    cloud.points.push_back(full.points[i]);
    cloud.normals.push_back(full.normals[i]);
  }
  for (int i = 0; i < 9; ++i) {
    cloud.points.emplace_back(i % 3, i / 3, -20);
    cloud.normals.emplace_back(0, 0, 1);
  }
  EXPECT_EQ(cloud.analyse().weakMotions, (WeakMotions{{Kind::Turn, Vec3::UnitZ()}}));
}

TEST(Stability, OfASphereLetsItTurnAboutItsCentre) {
  EXPECT_EQ(sphere().analyse().weakMotions,
            (WeakMotions{{Kind::Turn, Vec3::UnitX()}, {Kind::Turn, Vec3::UnitY()}, {Kind::Turn, Vec3::UnitZ()}}));
}

TEST(Stability, NamesASlantedSlide) {
  // Two planes that hold all but slides along their common line (1, 1, 0).
  Cloud cloud;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      cloud.points.push_back(i * Vec3(1, 1, 0).normalized() + j * Vec3(1, -1, 0).normalized());
      cloud.normals.emplace_back(0, 0, 1);
      cloud.points.push_back(i * Vec3(1, 1, 0).normalized() + j * Vec3(0, 0, 1));
      cloud.normals.push_back(Vec3(1, -1, 0).normalized());
    }
  }
  EXPECT_EQ(cloud.analyse().weakMotions, (WeakMotions{{Kind::Slide, Vec3(0.7, 0.7, 0.0)}}));
}

TEST(Stability, OfACornerIsFirmAndGivesTheSigmaOfItsWeakestMotion) {
  const Stability s = corner().analyse();
  EXPECT_GT(s.eigenvalues[0], 0.0);
  // At least 121 points hold each direction to 0.1 / sqrt(121) mm; turns are a few times weaker.
  EXPECT_GT(s.poseSigma, 0.1 / std::sqrt(187.0));
  EXPECT_LT(s.poseSigma, 0.1);
}

TEST(Stability, GrowsWithTheNumberOfPointsAndShrinksWithTheirNoise) {
  const Stability once = corner().analyse();
  StabilityOptions noisy;
  noisy.noiseSigma = 0.2;
  EXPECT_NEAR(corner().analyse(noisy).poseSigma, 2.0 * once.poseSigma, 1e-9);
  Cloud four;
  for (int i = 0; i < 4; ++i) {
    const Cloud c = corner();
    four.points.insert(four.points.end(), c.points.begin(), c.points.end());
    four.normals.insert(four.normals.end(), c.normals.begin(), c.normals.end());
  }
  EXPECT_NEAR(four.analyse().poseSigma, 0.5 * once.poseSigma, 1e-9);
}

TEST(Stability, IsTheSameForAnObjectElsewhere) {
  const Cloud here = corner();
  Pose motion = Pose::Identity();
  motion.translate(Vec3(100, -50, 20));
  motion.rotate(Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()));
  Cloud there;
  for (const Vec3& p : here.points) there.points.push_back(motion * p);
  for (const Vec3& n : here.normals) there.normals.push_back(motion.linear() * n);
  const Stability a = here.analyse();
  const Stability b = there.analyse();
  EXPECT_TRUE(a.eigenvalues.isApprox(b.eigenvalues, 1e-9));
  EXPECT_NEAR(a.poseSigma, b.poseSigma, 1e-9);
}

TEST(Stability, APriorHoldsWhatThePointsDoNot) {
  StabilityOptions options;
  Mechanics mechanics;
  mechanics.angleSigma = radians(0.3);
  mechanics.positionSigma = 0.01;
  options.prior = turntablePrior(mechanics);
  const Stability s = cylinder().analyse(options);
  EXPECT_EQ(s.weakMotions, (WeakMotions{{Kind::Turn, Vec3::UnitZ()}}));
  // A turn by one sigma of 0.3 degrees moves the points by 10 mm times the angle.
  EXPECT_NEAR(s.poseSigma, 10.0 * radians(0.3), 1e-4);
}

TEST(Stability, NoiseOfNormalsIsNotTakenForRelief) {
  Cloud cloud = cylinder();
  Random random(9);
  const double sigma = 0.03;
  for (Vec3& n : cloud.normals) n = (n + sigma * Vec3(random.normal(), random.normal(), random.normal())).normalized();
  StabilityOptions options;
  const double pretended = cloud.analyse(options).eigenvalues[1];
  options.normalSigma = sigma;
  EXPECT_LT(cloud.analyse(options).eigenvalues[1], 0.2 * pretended);
}

TEST(Stability, OfNoPointsIsThePriorAlone) {
  StabilityOptions options;
  options.prior = isotropicPrior(radians(10.0), 2.0, Vec3::Zero());
  EXPECT_NEAR(analyseStability({}, {}, {}, options).information(5, 5), 0.25, 1e-12);
}

TEST(Stability, RefusesCountsThatDiffer) {
  const std::vector<Vec3> two(2, Vec3::Zero());
  const std::vector<Vec3> one(1, Vec3::UnitZ());
  EXPECT_THROW((void)analyseStability(two, one, {}, {}), InvalidInput);
  StabilityOptions options;
  options.noiseSigma = 0.0;
  EXPECT_THROW((void)analyseStability(one, one, {}, options), InvalidInput);
}

TEST(WeakDirection, IsFreeWithoutAnyInformation) {
  EXPECT_EQ(weakestDirection(Vec6::Zero(), Mat6::Identity()).motions, (WeakMotions{{Kind::Free, Vec3::Zero()}}));
}

TEST(WeakDirection, GivesASlantedAxisToATenth) {
  Vec6 motion;
  motion << 0, 0, 0, -3.0, 1.0, 0.02;
  EXPECT_EQ(plainMotion(motion), (WeakMotion{Kind::Slide, Vec3(0.9, -0.3, 0.0)}));
}

TEST(WeakDirection, KindsHaveNames) {
  EXPECT_EQ(name(Kind::Slide), "slide");
  EXPECT_EQ(name(Kind::Turn), "turn");
  EXPECT_EQ(name(Kind::Free), "free");
}

TEST(WeakDirection, NamesAScrewByItsMainPart) {
  Vec6 motion;
  motion << 0, 0, 0.9, 0, 0, 0.3;
  EXPECT_EQ(plainMotion(motion), (WeakMotion{Kind::Turn, Vec3::UnitZ()}));
  motion << 0, 0, 0.3, 0, 0, 0.9;
  EXPECT_EQ(plainMotion(motion), (WeakMotion{Kind::Slide, Vec3::UnitZ()}));
}

TEST(WeakDirection, CallsATurnAboutAFarAxisASlide) {
  Vec6 motion;
  motion << 0, 0, 0.1, 1.0, 0, 0;
  EXPECT_EQ(plainMotion(motion), (WeakMotion{Kind::Slide, Vec3::UnitX()}));
}

TEST(WeakDirection, PointsAlongThePositiveAxis) {
  Vec6 motion;
  motion << 0, 0, 0, 0.01, -1.0, 0;
  EXPECT_EQ(plainMotion(motion), (WeakMotion{Kind::Slide, Vec3::UnitY()}));
}

}  // namespace
}  // namespace vantage
