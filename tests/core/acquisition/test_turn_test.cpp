#include "acquisition/test_turn.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/meshes.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

TestTurn turn(int from, int to, bool ideal) {
  const auto profile = testing::smallProfile();
  SimulatedScanner scanner(testing::smallObject(), profile, {7, ideal});
  return testTurn(scanner, *profile, from, to, {});
}

TEST(TestTurn, MeasuresTheTurnThatAPerfectTableMakes) {
  const TestTurn result = turn(0, 2, true);
  EXPECT_NEAR(result.expected, radians(30.0), 1e-9);
  EXPECT_NEAR(result.measured, result.expected, radians(0.1));
  EXPECT_LT(result.axisOffset, 0.2);
  EXPECT_NE(result.registration.verdict, Verdict::Failed);
  EXPECT_GT(result.samples, 500U);
}

TEST(TestTurn, FindsTheErrorThatTheMechanicsMade) {
  const auto profile = testing::smallProfile();
  const SimulationOptions options{7, false};
  SimulatedScanner scanner(testing::smallObject(), profile, options);
  const TestTurn result = testTurn(scanner, *profile, 0, 1, {});
  const SimulatedTable table(profile, options);
  const Pose truth = table.mechanicalError(1) * table.mechanicalError(0).inverse();
  const double error = std::atan2(truth.linear()(1, 0), truth.linear()(0, 0));
  // The scans are about 3 mm apart and register to a fraction of that.
  EXPECT_NEAR(result.measured - result.expected, error, radians(0.15));
}

TEST(TestTurn, SaysWhenTheScannerSeesNothing) {
  const auto profile = testing::smallProfile();
  SimulatedScanner scanner(testing::makeSphere(5, 8, {0, 0, 900}), profile, {7, true});
  EXPECT_THROW(static_cast<void>(testTurn(scanner, *profile, 0, 1, {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
