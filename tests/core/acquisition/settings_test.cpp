#include "acquisition/settings.h"

#include <gtest/gtest.h>

#include "core/io/expect_error.h"

namespace vantage {
namespace {

using testing::expectError;

TEST(Strategy, ComesBackFromItsName) {
  for (const char* text : {"ps", "random", "uniform:1", "uniform:12"}) EXPECT_EQ(name(parseStrategy(text)), text);
  EXPECT_EQ(parseStrategy("uniform:12").kind, Strategy::Kind::Uniform);
  EXPECT_EQ(parseStrategy("uniform:12").uniformViews, 12);
}

TEST(Strategy, IsOneOfThreeOrRefused) {
  for (const char* text : {"", "PS", "uniform", "uniform:", "uniform:0", "uniform:-3", "uniform:2x", "random "})
    expectError<InvalidInput>([&] { static_cast<void>(parseStrategy(text)); },
                              {std::string(text) + "', expected ps", "uniform:N"});
}

TEST(Settings, OfAnAcquisitionWithScansKeepObjectAndMeshes) {
  const AcquisitionSettings before;
  AcquisitionSettings after = before;
  after.maxViews = 3;
  after.planner.tolerance = 0.4;
  EXPECT_TRUE(mayFollow(before, after));
  EXPECT_NO_THROW(checkChange(before, after));
  after.triangulation.angleSlack = radians(1.0);
  EXPECT_FALSE(mayFollow(before, after));
  expectError<InvalidInput>([&] { checkChange(before, after); },
                            {"triangulation.angle_slack", "as the session was begun"});
  after = before;
  after.simulation.object = "other.ply";
  EXPECT_FALSE(mayFollow(before, after));
  expectError<InvalidInput>([&] { checkChange(before, after); }, {"simulation.object", "other.ply"});
}

TEST(Settings, AgreeUntilAFineGateIsLargerThanTheCoarseOne) {
  AcquisitionSettings settings;
  EXPECT_TRUE(agree(settings));
  settings.refinement.coarseGate = 2.0;
  settings.refinement.finalGate = settings.refinement.coarseGate;
  EXPECT_TRUE(agree(settings));
  settings.refinement.finalGate = 3.0;
  EXPECT_FALSE(agree(settings));
  expectError<InvalidInput>([&] { checkSettings(settings); }, {"refinement.final_gate", "refinement.coarse_gate"});
}

TEST(Settings, AsTheyWereBeforeTheyHadNamesCountForNothingInTheHash) {
  const AcquisitionSettings before = settingsBefore();
  EXPECT_EQ(before, settingsBefore());
  AcquisitionSettings other = before;
  other.maxViews = before.maxViews + 1;
  EXPECT_FALSE(other == before);
  EXPECT_NE(settingsHash(other), settingsHash(before));
  other.maxViews = before.maxViews;
  EXPECT_EQ(settingsHash(other), settingsHash(before));
}

}  // namespace
}  // namespace vantage
