#include "planning/turn_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vantage {
namespace {

// A turntable of 36 positions, and the same again tilted by 20 degrees.
Workspace twoTilts() {
  Workspace workspace;
  for (const double tilt : {0.0, 20.0})
    for (int i = 0; i < 36; ++i)
      workspace.poses.push_back(Eigen::AngleAxisd(radians(10.0 * i), Vec3::UnitZ()) *
                                Eigen::AngleAxisd(radians(tilt), Vec3::UnitY()) * Eigen::Translation3d(300, 0, 0));
  return workspace;
}

TEST(TurnSpread, ATableEndsAtItsPosition) {
  const TurnSpread spread(twoTilts(), {radians(0.3), 0.3});
  EXPECT_FALSE(spread.isWide());
  EXPECT_EQ(spread.around(7), std::vector<int>{7});
  EXPECT_EQ(spread.extremes(7), std::vector<int>{7});
  const std::vector<double> values(72, 3.0);
  EXPECT_EQ(spread.least(values), values);
}

TEST(TurnSpread, AHandEndsUpToTwoSigmasAwayAtTheSameTilt) {
  const TurnSpread spread(twoTilts(), {radians(7.5), 3.0});
  EXPECT_TRUE(spread.isWide());
  EXPECT_EQ(spread.around(7), (std::vector<int>{6, 7, 8}));
  EXPECT_EQ(spread.around(0), (std::vector<int>{0, 1, 35}));
  EXPECT_EQ(spread.around(36), (std::vector<int>{36, 37, 71}));
  std::vector<int> ends = spread.extremes(0);
  EXPECT_EQ(ends.front(), 0);
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(ends, (std::vector<int>{0, 1, 35}));
}

TEST(TurnSpread, CountsOnTheLeastOfWhereAHandMayEnd) {
  const TurnSpread spread(twoTilts(), {radians(7.5), 3.0});
  std::vector<double> values(72, 5.0);
  values[8] = 1.0;
  const std::vector<double> least = spread.least(values);
  for (int i = 0; i < 72; ++i) EXPECT_EQ(least[static_cast<std::size_t>(i)], i >= 7 && i <= 9 ? 1.0 : 5.0) << i;
}

}  // namespace
}  // namespace vantage
