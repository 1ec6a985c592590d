#include "composites/even_rotations.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace vantage {
namespace {

TEST(EvenRotations, AreUnitAndTheSameEveryTime) {
  const auto some = evenRotations(200);
  ASSERT_EQ(some.size(), 200U);
  for (const auto& q : some) EXPECT_NEAR(q.norm(), 1.0, 1e-12);
  const auto again = evenRotations(200);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i].coeffs(), again[i].coeffs());
}

// 1000 balls of this radius that fill all rotations without a gap or overlap would have a radius of about 12 degrees.
TEST(EvenRotations, NoRotationIsFarFromAllOfThem) {
  const auto some = evenRotations(1000);
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
    double nearest = 10.0;
    for (const auto& r : some) nearest = std::min(nearest, q.angularDistance(r));
    EXPECT_LT(degrees(nearest), 28.0);
  }
}

}  // namespace
}  // namespace vantage
