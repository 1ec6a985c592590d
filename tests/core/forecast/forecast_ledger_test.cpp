#include "forecast/forecast_ledger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace vantage {
namespace {

const LedgerOptions kOptions{4, 60.0, 0.7, 0.5};

TEST(ForecastLedger, BeforeTheFirstViewIsWhatIsKnownBeforehand) {
  const ForecastTrust trust = trustIn({}, 1.2, kOptions);
  EXPECT_NEAR(trust.factor, 0.7, 1e-12);
  EXPECT_NEAR(trust.spread, 0.5, 1e-12);
}

// By hand, with samples 1 mm apart: 60 of what is known beforehand, 240 of a view that found half.
TEST(ForecastLedger, IsTheMeanShareByArea) {
  const std::vector<ForecastEntry> ledger{{240.0, 120.0}};
  const ForecastTrust trust = trustIn(ledger, 1.0, kOptions);
  EXPECT_NEAR(trust.factor, (60.0 * 0.7 + 240.0 * 0.5) / 300.0, 1e-12);
  const double squares = (60.0 * (0.49 + 0.25) + 240.0 * 0.25) / 300.0;
  EXPECT_NEAR(trust.spread, std::sqrt(squares - trust.factor * trust.factor), 1e-12);
}

TEST(ForecastLedger, CountsTheLastViewsAndNoneTooMuch) {
  const std::vector<ForecastEntry> old{{100.0, 1000.0}, {100.0, 50.0}, {100.0, 50.0}, {100.0, 50.0}, {100.0, 50.0}};
  const std::vector<ForecastEntry> last(old.begin() + 1, old.end());
  EXPECT_EQ(trustIn(old, 1.0, kOptions).factor, trustIn(last, 1.0, kOptions).factor);
  const std::vector<ForecastEntry> large{{1e6, 1e6}};
  const std::vector<ForecastEntry> largest{{1e9, 1e9}};
  EXPECT_EQ(trustIn(large, 1.0, kOptions).factor, trustIn(largest, 1.0, kOptions).factor);
}

TEST(ForecastLedger, StaysWithinItsBounds) {
  const std::vector<ForecastEntry> nothing(4, {300.0, 0.0});
  EXPECT_EQ(trustIn(nothing, 1.0, kOptions).factor, 0.2);
  const std::vector<ForecastEntry> much(4, {300.0, 9000.0});
  EXPECT_EQ(trustIn(much, 1.0, kOptions).factor, 1.3);
  EXPECT_GE(trustIn(much, 1.0, kOptions).spread, 0.0);
}

TEST(ForecastLedger, AViewOfWhichNothingWasForecastSaysNothing) {
  const std::vector<ForecastEntry> ledger{{0.0, 80.0}};
  EXPECT_EQ(trustIn(ledger, 1.0, kOptions).factor, trustIn({}, 1.0, kOptions).factor);
}

}  // namespace
}  // namespace vantage
