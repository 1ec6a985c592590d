#include "planning/termination.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

constexpr TerminationOptions kOptions{.threshold = std::nullopt, .edges = 20.0, .share = 0.001};

TEST(TerminationThreshold, OfASmallModelIsWhatSoManyEdgesShow) {
  EXPECT_DOUBLE_EQ(terminationThreshold(kOptions, 2.0, 1000.0), 80.0);  // 20 edges of 2 mm, a spacing deep each
}

TEST(TerminationThreshold, OfALargeModelIsAShareOfIt) {
  EXPECT_DOUBLE_EQ(terminationThreshold(kOptions, 2.0, 1e6), 1000.0);
}

TEST(TerminationThreshold, IsTheOneThatIsGiven) {
  TerminationOptions options = kOptions;
  options.threshold = 7.0;
  EXPECT_DOUBLE_EQ(terminationThreshold(options, 2.0, 1e6), 7.0);
}

}  // namespace
}  // namespace vantage
