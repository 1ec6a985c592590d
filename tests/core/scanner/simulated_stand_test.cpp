#include "scanner/simulated_stand.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/meshes.h"

namespace vantage {
namespace {

// Two balls side by side, one of them small.
Mesh object() {
  return testing::joined(testing::makeSphere(30, 16, {0, 0, 30}), testing::makeSphere(10, 12, {45, 0, 10}));
}

TEST(SimulatedStand, TheFirstOneIsAsItIs) {
  EXPECT_EQ(simulatedStand(object(), {}, 0, 7).matrix(), Pose::Identity().matrix());
}

TEST(SimulatedStand, TheObjectRestsOnTheTableNearTheAxisOnTheSideThatWasMeant) {
  for (const Vec3& down : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    const Pose T_table_object = simulatedStand(object(), down, 1, 7);
    const Mesh turned = transformed(object(), T_table_object);
    double lowest = 1e9;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : turned.vertices) {
      lowest = std::min(lowest, v.z());
      middle += v / static_cast<double>(turned.vertices.size());
    }
    EXPECT_NEAR(lowest, 0.0, 1.0);
    EXPECT_LT(middle.head<2>().norm(), 30.0);
    EXPECT_LT((T_table_object.linear() * down).z(), -0.5);
  }
}

TEST(SimulatedStand, DependsOnSeedAndStandOnly) {
  const Vec3 down(0, 0, 1);
  EXPECT_EQ(simulatedStand(object(), down, 1, 7).matrix(), simulatedStand(object(), down, 1, 7).matrix());
  EXPECT_NE(simulatedStand(object(), down, 2, 7).matrix(), simulatedStand(object(), down, 1, 7).matrix());
  EXPECT_NE(simulatedStand(object(), down, 1, 8).matrix(), simulatedStand(object(), down, 1, 7).matrix());
}

}  // namespace
}  // namespace vantage
