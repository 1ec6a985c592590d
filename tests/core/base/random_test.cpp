#include "base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace vantage {
namespace {

constexpr int kDraws = 100000;

TEST(Random, SameSeedAndStreamRepeat) {
  Random a(42, 7);
  Random b(42, 7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Random, StreamsAndSeedsDiffer) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (std::uint64_t stream = 0; stream < 100; ++stream) first.insert(Random(seed, stream).bits());
  EXPECT_EQ(first.size(), 10000U);
}

// Limits of the means below are five standard errors.
TEST(Random, UniformFillsTheUnitInterval) {
  Random random(1);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 1.0 / 2.0, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kDraws));
}

TEST(Random, NormalHasTheMomentsOfANormalDistribution) {
  Random random(2);
  std::array<double, 5> moment{};
  for (int i = 0; i < kDraws; ++i) {
    double power = 1.0;
    const double x = random.normal();
    for (double& m : moment) {
      m += power / kDraws;
      power *= x;
    }
  }
  EXPECT_NEAR(moment[1], 0.0, 5.0 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(moment[2], 1.0, 5.0 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(moment[3], 0.0, 5.0 * std::sqrt(15.0 / kDraws));
  EXPECT_NEAR(moment[4], 3.0, 5.0 * std::sqrt(96.0 / kDraws));
}

TEST(Random, FirstDrawsOfNeighbouringStreamsAreUncorrelated) {
  double sum = 0.0;
  double product = 0.0;
  for (std::uint64_t stream = 0; stream < kDraws; ++stream) {
    const double a = Random(3, stream).uniform() - 0.5;
    const double b = Random(3, stream + 1).uniform() - 0.5;
    sum += a;
    product += a * b;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));
  EXPECT_NEAR(product / kDraws, 0.0, 5.0 / 12.0 / std::sqrt(kDraws));
}

TEST(Random, BelowReachesEveryValueAboutEquallyOften) {
  Random random(4);
  std::array<int, 7> count{};
  for (int i = 0; i < kDraws; ++i) ++count.at(random.below(7));
  const double expected = kDraws / 7.0;
  for (const int n : count) EXPECT_NEAR(n, expected, 5.0 * std::sqrt(expected));
  EXPECT_EQ(random.below(1), 0U);
}

}  // namespace
}  // namespace vantage
