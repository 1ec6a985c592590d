#include "registration/pose_list.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace vantage {
namespace {

Pose turn(double angle) {
  return Pose(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

// Scanners about the z axis, 200 mm away, looking at it.
std::vector<Pose> aboutZ(int count, double step) {
  Pose first = Pose::Identity();
  first.translation() = Vec3(200, 0, 40);
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) poses.push_back(turn(k * step) * first);
  return poses;
}

TEST(PoseList, TurnsAreCountedBeyondAHalfTurn) {
  const auto turns = turnsOf(aboutZ(12, radians(30.0)));
  ASSERT_TRUE(turns);
  EXPECT_NEAR(std::abs(turns->axis.z()), 1.0, 1e-9);
  EXPECT_NEAR(turns->point.head<2>().norm(), 0.0, 1e-6);
  EXPECT_NEAR(std::abs(turns->angles.back()), radians(330.0), 1e-9);
}

TEST(PoseList, WithoutACommonAxisThereAreNoTurns) {
  EXPECT_FALSE(turnsOf(std::vector<Pose>(3, Pose::Identity())));
  EXPECT_FALSE(turnsOf(std::vector<Pose>{Pose::Identity(), turn(1.0), Pose(Eigen::AngleAxisd(1.0, Vec3::UnitX()))}));
}

TEST(PoseList, TurnsTakenTimesAFactorAreThoseOfTheSlowerTable) {
  const std::vector<Pose> listed = aboutZ(12, radians(30.0));
  const std::vector<Pose> truth = aboutZ(12, radians(15.0));
  const MendedList half = withTurns(listed, *turnsOf(listed), 0.5);
  for (std::size_t i = 0; i < listed.size(); ++i) EXPECT_TRUE(half.poses[i].isApprox(truth[i], 1e-6)) << i;
}

TEST(PoseList, NamesTurnsThatAreHalfOfWhatTheListSays) {
  const auto fault = commonFault(aboutZ(8, radians(30.0)), aboutZ(8, radians(15.0)), 1.0);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->fault, PoseListFault::Turns);
  EXPECT_NEAR(fault->value, 0.5, 1e-6);
}

TEST(PoseList, NamesTurnsTheOtherWay) {
  const auto fault = commonFault(aboutZ(8, radians(20.0)), aboutZ(8, radians(-20.0)), 1.0);
  ASSERT_TRUE(fault);
  EXPECT_NEAR(fault->value, -1.0, 1e-6);
}

TEST(PoseList, NamesAnAxisThatIsBeside) {
  // The table turns about an axis 4 mm beside the one that the list turns about.
  std::vector<Pose> found = aboutZ(8, radians(45.0));
  const Pose first = found.front();
  for (int k = 0; k < 8; ++k) {
    Pose beside = Pose::Identity();
    beside.translation() = Vec3(0, 4, 0) - turn(k * radians(45.0)) * Vec3(0, 4, 0);
    found[static_cast<std::size_t>(k)] = beside * turn(k * radians(45.0)) * first;
  }
  const auto fault = commonFault(aboutZ(8, radians(45.0)), found, 1.0);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->fault, PoseListFault::Axis);
  EXPECT_NEAR(fault->value, 4.0, 1e-6);
}

TEST(PoseList, OfPosesThatAreRightHasNoFault) {
  std::vector<Pose> found = aboutZ(8, radians(45.0));
  for (std::size_t i = 1; i < found.size(); ++i) found[i].translation() += Vec3(0.2, i % 2 == 0 ? 0.3 : -0.3, 0.1);
  EXPECT_FALSE(commonFault(aboutZ(8, radians(45.0)), found, 1.0));
  EXPECT_THROW((void)commonFault(aboutZ(8, 0.1), aboutZ(7, 0.1), 1.0), InvalidInput);
}

TEST(PoseList, IsMendedInOneWayAtATime) {
  const std::vector<Pose> poses = aboutZ(3, radians(30.0));
  std::vector<Pose> metres = poses;
  for (Pose& pose : metres) pose.translation() /= 1000.0;
  bool found = false;
  for (const MendedList& list : mendedLists(metres)) {
    ASSERT_EQ(list.poses.size(), 3U);
    if (list.finding.fault != PoseListFault::Unit || list.finding.value != 1000.0) continue;
    found = list.poses[1].isApprox(poses[1], 1e-9);
  }
  EXPECT_TRUE(found);
  EXPECT_TRUE(mendedLists(poses).front().poses[2].isApprox(poses[2].inverse(), 1e-12));
}

}  // namespace
}  // namespace vantage
