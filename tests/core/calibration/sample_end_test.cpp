#include "calibration/sample_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

namespace vantage::testing {
namespace {

// Angles of surface that leans all ways: rays that meet a ball evenly, up to an angle.
std::vector<double> ofBall(std::size_t count, double end, std::uint64_t seed) {
  Random random(seed, 1);
  std::vector<double> angles;
  while (angles.size() < count) {
    const double angle = std::asin(std::sqrt(random.uniform()));
    if (angle <= end) angles.push_back(angle);
  }
  return angles;
}

TEST(SampleEnd, IsWhereABallEnds) {
  for (const double end : {55.0, 60.0, 68.0, 75.0, 80.0}) {
    const SampleEnd found = sampleEnd(ofBall(20000, radians(end), 3));
    EXPECT_NEAR(degrees(found.angle), end, 2.0);
    EXPECT_LE(degrees(found.from), end + 1.0);
    EXPECT_GE(degrees(found.to), end - 1.0);
  }
}

TEST(SampleEnd, FlatThingsPileUpAndDoNotCount) {
  std::vector<double> angles = ofBall(20000, radians(75.0), 4);
  for (const double wall : {2.0, 61.0}) angles.insert(angles.end(), 60000, radians(wall + 0.5));
  EXPECT_NEAR(degrees(sampleEnd(angles).angle), 75.0, 2.0);
}

TEST(SampleEnd, AFewSteepOnesAreNotItsEnd) {
  std::vector<double> angles = ofBall(20000, radians(65.0), 5);
  for (int k = 0; k < 40; ++k) angles.push_back(radians(66.0 + 0.45 * k));
  EXPECT_NEAR(degrees(sampleEnd(angles).angle), 65.0, 2.0);
}

TEST(SampleEnd, WhereNothingLeansAllWaysItIsLeftOpen) {
  const SampleEnd found = sampleEnd(std::vector<double>(1000, radians(20.0)));
  EXPECT_NEAR(degrees(found.angle), 20.0, 0.1);
  EXPECT_NEAR(degrees(found.to), 85.0, 0.1);
}

}  // namespace
}  // namespace vantage::testing
