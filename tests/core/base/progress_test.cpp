#include "base/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

using Reports = std::vector<std::pair<double, std::string>>;

Progress recording(Reports& reports, std::stop_token stop = {}, int threads = 1) {
  return {[&](double fraction, std::string_view step) { reports.emplace_back(fraction, step); }, std::move(stop),
          threads};
}

TEST(Progress, DefaultReportsNowhereAndNeverStops) {
  const Progress progress;
  EXPECT_NO_THROW(progress.checkpoint(0.5));
  EXPECT_FALSE(progress.stopRequested());
  EXPECT_EQ(progress.threads(), 1);
}

TEST(Progress, PartsOfPartsMapToTheWhole) {
  Reports reports;
  const Progress second = recording(reports).part(0.5, 1.0, "second");
  const Progress quarter = second.part(0.25, 0.5, "inner");
  second.checkpoint(0.0);
  quarter.checkpoint(0.0);
  quarter.checkpoint(0.5);
  second.checkpoint(1.0);
  EXPECT_EQ(reports, (Reports{{0.5, "second"}, {0.625, "inner"}, {0.6875, "inner"}, {1.0, "second"}}));
}

TEST(Progress, AnUnnamedPartKeepsTheStep) {
  Reports reports;
  recording(reports).part(0.0, 1.0, "outer").part(0.0, 0.5).checkpoint(1.0);
  EXPECT_EQ(reports, (Reports{{0.5, "outer"}}));
}

TEST(Progress, FractionsOutsideOfTheRangeAreClamped) {
  Reports reports;
  const Progress part = recording(reports).part(0.25, 0.75);
  part.checkpoint(-1.0);
  part.checkpoint(7.0);
  EXPECT_EQ(reports, (Reports{{0.25, ""}, {0.75, ""}}));
}

TEST(Progress, CheckpointThrowsOnceAStopWasRequested) {
  std::stop_source source;
  Reports reports;
  const Progress progress = recording(reports, source.get_token());
  const Progress part = progress.part(0.0, 0.5, "part");
  part.checkpoint(0.0);
  source.request_stop();
  EXPECT_TRUE(part.stopRequested());
  EXPECT_THROW(part.checkpoint(0.5), Cancelled);
  EXPECT_THROW(progress.checkpoint(0.5), Cancelled);
  EXPECT_EQ(reports.size(), 1U);
}

TEST(Progress, ThreadsAreAtLeastOneAndSharedByParts) {
  EXPECT_EQ(Progress({}, {}, 0).threads(), 1);
  EXPECT_EQ(Progress({}, {}, -3).threads(), 1);
  EXPECT_EQ(Progress({}, {}, 8).part(0.0, 0.5).threads(), 8);
  EXPECT_EQ(Progress({}, {}, 8).withThreads(3).threads(), 3);
  EXPECT_EQ(Progress({}, {}, 8).withThreads(0).threads(), 1);
}

TEST(Progress, AnObserverHearsWhatTheReportHears) {
  Reports reports;
  Reports observed;
  const Progress progress = recording(reports).observedBy(
      [&](double fraction, std::string_view step) { observed.emplace_back(fraction, step); });
  progress.part(0.0, 0.5, "half").checkpoint(1.0);
  EXPECT_EQ(reports, (Reports{{0.5, "half"}}));
  EXPECT_EQ(observed, reports);
}

}  // namespace
}  // namespace vantage
