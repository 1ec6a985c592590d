#include "acquisition/further_scan.h"

#include <gtest/gtest.h>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// A state of a baseline of four views with views of these positions, of which nothing else is known.
AcquisitionState baselineWith(const std::vector<int>& positions) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  state.settings.strategy = parseStrategy("uniform:4");
  for (const int position : positions) {
    auto image = std::make_shared<RangeImage>();
    image->station.position = position;
    KeptScan scan;
    scan.number = static_cast<std::int64_t>(state.scans.size());
    scan.view.image = std::move(image);
    state.scans.push_back(std::move(scan));
    state.model = std::make_shared<const Model>();
  }
  return state;
}

TEST(FurtherScan, IsThatOfARunWhichWasNotEnded) {
  AcquisitionState state = baselineWith({0});
  ASSERT_TRUE(furtherScan(state));
  EXPECT_EQ(furtherScan(state)->position, 6);
  state.termination = Termination::EndedByOperator;
  ASSERT_TRUE(std::holds_alternative<Ended>(nextScan(state)));
  ASSERT_TRUE(furtherScan(state));
  EXPECT_EQ(furtherScan(state)->position, 6);
}

TEST(FurtherScan, IsOneMoreThanTheGreatestNumberOfViews) {
  AcquisitionState state = baselineWith({0, 6});
  state.settings.maxViews = 2;
  ASSERT_EQ(terminationOf(nextScan(state)), Termination::MaxViews);
  ASSERT_TRUE(furtherScan(state));
  EXPECT_EQ(furtherScan(state)->position, 12);
  EXPECT_EQ(state.settings.maxViews, 2);
}

TEST(FurtherScan, IsNoneWhereNothingIsProposed) {
  EXPECT_FALSE(furtherScan(baselineWith({0, 6, 12, 18})));
  AcquisitionState unplanned = baselineWith({0});
  unplanned.settings.strategy = {};
  EXPECT_FALSE(furtherScan(unplanned));
}

TEST(ProposedScan, ForgetsWhatTheOperatorChose) {
  AcquisitionState state = baselineWith({0});
  state.chosenPosition = 3;
  ASSERT_TRUE(furtherScan(state));
  EXPECT_EQ(furtherScan(state)->position, 3);
  ASSERT_TRUE(proposedScan(state));
  EXPECT_EQ(proposedScan(state)->position, 6);
}

}  // namespace
}  // namespace vantage
