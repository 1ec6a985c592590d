#include "io/scan_poses.h"

#include <cmath>

#include "core/io/expect_error.h"
#include "support/test_data.h"

namespace vantage {
namespace {

using testing::expectError;
using testing::TemporaryFolder;

TEST(ScanPoses, TurnByTheConjugateOfTheQuaternion) {
  const TemporaryFolder folder;
  // The quaternion turns by +90 degrees about z, so points turn by -90: x goes to -y.
  const double half = std::sqrt(0.5);
  const std::string path =
      folder.write("a.conf", "camera 1 2 3 0 0 0 1\nmesh other 9 9 9 0 0 0 1\n\nbmesh folder/one.ply 1 2 3 0 0 " +
                                 std::to_string(half) + " " + std::to_string(half) + "\nbmesh two 0 0 0 0 0 0 1\n");
  const auto poses = readScanPoses(path, 1000.0);
  ASSERT_EQ(poses.size(), 2U);
  const Vec3 moved = poses[0].T_object_scanner * Vec3(5, 0, 0);
  EXPECT_NEAR((moved - Vec3(1000, 1995, 3000)).norm(), 0.0, 1e-9);
}

TEST(ScanPoses, AreFoundByNameWithOrWithoutFolderAndExtension) {
  std::vector<ScanPose> poses(2);
  poses[0].file = "one.ply";
  poses[1].file = "two";
  poses[1].T_object_scanner.translation() = Vec3(1, 0, 0);
  EXPECT_TRUE(findPose(poses, "/data/one.ply"));
  EXPECT_TRUE(findPose(poses, "one"));
  EXPECT_EQ(findPose(poses, "scans/two.ply")->translation(), Vec3(1, 0, 0));
  EXPECT_FALSE(findPose(poses, "three.ply"));
}

TEST(ScanPoses, KnowNamesWithBlanksPlainAndInQuotes) {
  const TemporaryFolder folder;
  const auto poses = readScanPoses(
      folder.write("a.conf",
                   "bmesh front view.ply 1 0 0 0 0 0 1\nbmesh \"left  view 2.ply\" 2 0 0 0 0 0 1\n"
                   "bmesh 'back view' 3 0 0 0 0 0 1\nbmesh scan 1 4 0 0 0 0 0 1\nbmesh plain.ply 5 0 0 0 0 0 1 # x\n"),
      1.0);
  ASSERT_EQ(poses.size(), 5U);
  EXPECT_EQ(findPose(poses, "in/front view.ply")->translation().x(), 1.0);
  EXPECT_EQ(findPose(poses, "left  view 2.ply")->translation().x(), 2.0);
  EXPECT_EQ(findPose(poses, "back view.pcd")->translation().x(), 3.0);
  EXPECT_EQ(findPose(poses, "scan 1.ptx")->translation().x(), 4.0);
  EXPECT_EQ(findPose(poses, "plain.ply")->translation().x(), 5.0);
}

TEST(ScanPoses, RefuseBrokenRecordsByLine) {
  const TemporaryFolder folder;
  auto refuse = [&](const std::string& text, const std::vector<std::string>& parts) {
    const std::string path = folder.write("a.conf", text);
    expectError<InvalidInput>([&] { static_cast<void>(readScanPoses(path, 1.0)); }, parts);
  };
  refuse("camera 0\nbmesh a 0 0 0 0 0 0\n", {"a.conf", "line 2", "'a'", "seven numbers"});
  refuse("bmesh a 0 0 x 0 0 0 1\n", {"line 1", "'x'"});
  refuse("bmesh a 0 0 nan 0 0 0 1\n", {"line 1", "'nan'"});
  refuse("bmesh a 0 0 0 0 0 0 0\n", {"line 1", "length 0", "expected 1"});
  refuse("hello\n", {"no line 'bmesh"});
}

}  // namespace
}  // namespace vantage
