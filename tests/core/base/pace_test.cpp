#include "base/pace.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

TEST(Pace, ReportsNowAndThen) {
  std::vector<double> reports;
  const Progress progress([&](double fraction, std::string_view) { reports.push_back(fraction); }, {}, 1);
  Pace pace(progress, 0.25);
  for (int i = 0; i < 1000; ++i) pace.step();
  EXPECT_TRUE(reports.empty());
  for (int i = 0; i < 1'000'000; ++i) pace.step();
  EXPECT_GT(reports.size(), 10U);
  EXPECT_LT(reports.size(), 1000U);
  EXPECT_EQ(reports[0], 0.25);
}

TEST(Pace, AsksWhetherToGoOn) {
  std::stop_source stop;
  Pace pace(Progress({}, stop.get_token(), 1));
  const auto loop = [&] {
    for (int i = 0; i < 200'000; ++i) pace.step();
  };
  EXPECT_NO_THROW(loop());
  stop.request_stop();
  EXPECT_THROW(loop(), Cancelled);
}

}  // namespace
}  // namespace vantage
