#include "registration/pose_covariance.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace vantage {
namespace {

// A view without points: what counts is how far its pose moves.
OrientedVertices noPoints() {
  static const std::vector<Vec3> positions;
  static const std::vector<float> confidence;
  return {positions, std::make_shared<const std::vector<Vec3>>(), confidence, {}};
}

// Two views besides the first: the second hangs loosely on the first, the third firmly on the second.
PoseCovariance chain() {
  const Mat6 loose = Mat6::Identity() / (5.0 * 5.0);
  const Mat6 firm = Mat6::Identity() / (0.1 * 0.1);
  Eigen::MatrixXd information(12, 12);
  information << loose + firm, -firm, -firm, firm;
  return {information, Vec3::Zero(), 10.0, 1000.0};
}

TEST(PoseCovariance, TellsHowSureViewsAreOfEachOther) {
  const OrientedVertices none = noPoints();
  const PoseCovariance covariance = chain();
  EXPECT_NEAR(covariance.sigma(1, 0, none, Pose::Identity()), 5.0, 0.01);
  EXPECT_NEAR(covariance.sigma(2, 0, none, Pose::Identity()), 5.0, 0.01);
  EXPECT_NEAR(covariance.sigma(2, 1, none, Pose::Identity()), 0.1, 1e-4);
  EXPECT_NEAR(covariance.sigma(0, 2, none, Pose::Identity()), 5.0, 0.01);
  EXPECT_EQ(covariance.sigma(2, 2, none, Pose::Identity()), 0.0);
}

TEST(PoseCovariance, WhatNothingHoldsIsAsLooseAsSaid) {
  const PoseCovariance covariance(Eigen::MatrixXd::Zero(6, 6), Vec3::Zero(), 10.0, 300.0);
  EXPECT_NEAR(covariance.sigma(1, 0, noPoints(), Pose::Identity()), 300.0, 1e-6);
}

}  // namespace
}  // namespace vantage
