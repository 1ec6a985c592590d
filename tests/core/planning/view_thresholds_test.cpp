#include "planning/view_thresholds.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

constexpr TerminationOptions kOptions{
    .threshold = std::nullopt, .edges = 20.0, .share = 0.001, .leftShare = 0.01, .leastEdges = 5.0};

TEST(ViewThresholds, OfASmallModelAreWhatSoManyEdgesShow) {
  const ViewThresholds thresholds = viewThresholds(kOptions, 2.0, 1000.0);
  EXPECT_DOUBLE_EQ(thresholds.usual, 80.0);  // 20 edges of 2 mm with a sample spacing of depth each
  EXPECT_DOUBLE_EQ(thresholds.least, 20.0);
  EXPECT_DOUBLE_EQ(thresholds.left, 10.0);
}

TEST(ViewThresholds, OfALargeModelAreAShareOfIt) {
  const ViewThresholds thresholds = viewThresholds(kOptions, 2.0, 1e6);
  EXPECT_DOUBLE_EQ(thresholds.usual, 1000.0);
  EXPECT_DOUBLE_EQ(thresholds.least, 250.0);
  EXPECT_DOUBLE_EQ(thresholds.left, 10000.0);
}

TEST(ViewThresholds, AreTheSameWhenOneIsGiven) {
  TerminationOptions options = kOptions;
  options.threshold = 7.0;
  const ViewThresholds thresholds = viewThresholds(options, 2.0, 1e6);
  EXPECT_DOUBLE_EQ(thresholds.usual, 7.0);
  EXPECT_DOUBLE_EQ(thresholds.least, 7.0);
}

}  // namespace
}  // namespace vantage
