#include "permissions.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

// Whoever asks for everything that can be asked for.
std::vector<QString> allOf(const Permissions& may) {
  return {may.whyNotRun(),  may.whyNotScan(), may.whyNotTestTurn(), may.whyNot(Finish{Termination::EndedByOperator}),
          may.whyNotUndo(), may.whyNotRedo(), may.whyNotExport(),   may.whyNotOpen(),
          may.whyNotClose()};
}

// A set-up that can scan, as far as permissions look at it.
SharedSetUp ready() {
  auto setUp = std::make_shared<SetUp>();
  setUp->profile = testing::smallProfile();
  setUp->devices = DeviceSetUp{};
  return setUp;
}

SharedSetUp without(const std::string& notes) {
  auto setUp = std::make_shared<SetUp>(*ready());
  setUp->devices = {};
  setUp->notes = notes;
  return setUp;
}

SharedState ended(Termination termination) {
  AcquisitionState state;
  state.profile = testing::smallProfile();
  state.termination = termination;
  return std::make_shared<const AcquisitionState>(state);
}

TEST(Permissions, EverythingWaitsForWhatIsUnderWay) {
  Situation busy{.busy = true, .sessionOpen = true, .setUp = ready(), .now = ended(Termination::Running)};
  busy.somethingBefore = busy.somethingUndone = true;
  for (const QString& why : allOf(Permissions(busy))) EXPECT_EQ(why, "Something else is under way.");
}

TEST(Permissions, BeforeThereIsAnythingEveryRefusalIsASentence) {
  for (const QString& why : allOf(Permissions({}))) {
    EXPECT_TRUE(why.isEmpty() || why.endsWith('.')) << why.toStdString();
  }
  EXPECT_TRUE(Permissions({}).whyNotScan().contains("not read yet"));
  EXPECT_TRUE(Permissions({}).whyNotOpen().isEmpty());
}

TEST(Permissions, AReadySetUpMayScanAndTurn) {
  const Permissions may({.setUp = ready()});
  EXPECT_EQ(may.whyNotRun(), "");
  EXPECT_EQ(may.whyNotScan(), "");
  EXPECT_EQ(may.whyNotTestTurn(), "");
}

TEST(Permissions, AssistedNothingRunsButOneScanMay) {
  const Permissions may({.mode = Mode::Assisted, .setUp = ready()});
  EXPECT_TRUE(may.whyNotRun().contains("one view at a time"));
  EXPECT_EQ(may.whyNotScan(), "");
}

TEST(Permissions, WhatThereIsNothingToScanWithIsNamed) {
  EXPECT_TRUE(Permissions({.setUp = without({})}).whyNoDevices().contains("needs an object"));
  EXPECT_TRUE(Permissions({.setUp = without("it is empty")}).whyNoDevices().contains("it is empty"));
  EXPECT_TRUE(Permissions({.sessionOpen = true, .setUp = without({})}).whyNoDevices().contains("recorded elsewhere"));
}

TEST(Permissions, OnlyAnEndThatTheOperatorWantedIsOpenedAgainByScanning) {
  EXPECT_EQ(
      Permissions({.sessionOpen = true, .setUp = ready(), .now = ended(Termination::EndedByOperator)}).whyNotScan(),
      "");
  const Permissions imported({.sessionOpen = true, .setUp = ready(), .now = ended(Termination::Imported)});
  EXPECT_EQ(imported.whyNotScan(), "The acquisition has ended.");
}

TEST(Permissions, UndoAndRedoFollowTheSteps) {
  EXPECT_FALSE(Permissions({}).whyNotUndo().isEmpty());
  EXPECT_EQ(Permissions({.somethingBefore = true}).whyNotUndo(), "");
  EXPECT_FALSE(Permissions({}).whyNotRedo().isEmpty());
  EXPECT_EQ(Permissions({.somethingUndone = true}).whyNotRedo(), "");
}

}  // namespace
}  // namespace vantage
