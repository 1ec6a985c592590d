// What a session does when its devices fail, and when a person takes the place of one.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "app/told_devices.h"
#include "session_controller.h"

namespace vantage {
namespace {

class DeviceFailure : public ::testing::Test {
 protected:
  DeviceFailure() {
    std::ofstream(path("scanner.json").toStdString()) << testing::smallProfileSource().text;
    QObject::connect(&controller_, &SessionController::failed, [this](const QString& what) { failure_ = what; });
  }
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
  void prepare(const TableDevice& table) {
    SetUpChoice choice;
    choice.scanner = path("scanner.json").toStdString();
    choice.folder = path("out").toStdString();
    choice.rig = {FolderDevice{path("scans").toStdString()}, table, {}, {}};
    choice.settings.maxViews = 4;
    controller_.setChoice(choice);
    controller_.prepare();
    ASSERT_TRUE(controller_.setUp()) << failure_.toStdString();
  }

  QTemporaryDir folder_;
  testing::ToldDevices devices_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, "", devices_.factory()};
  QString failure_;
};

TEST_F(DeviceFailure, PausesTheRunAndItGoesOnWithTheDevicesOpenedAnew) {
  prepare(SerialTableDevice{"/dev/nothing", {}});
  controller_.step();
  ASSERT_TRUE(controller_.now()) << failure_.toStdString();
  devices_.table->failsNext = "was unplugged";
  controller_.run();
  EXPECT_TRUE(controller_.scanFailure().contains("was unplugged"));
  EXPECT_TRUE(controller_.canTurnByHand());
  EXPECT_EQ(controller_.now()->scans.size(), 1U);
  EXPECT_EQ(controller_.now()->termination, Termination::Running);
  controller_.run();
  EXPECT_TRUE(controller_.scanFailure().isEmpty()) << controller_.scanFailure().toStdString();
  EXPECT_EQ(devices_.made, 2);
  EXPECT_EQ(countScans(*controller_.now(), ScanStatus::In), 4U);
}

TEST_F(DeviceFailure, BeforeTheFirstScanLeavesNoSession) {
  prepare(SerialTableDevice{"/dev/nothing", {}});
  devices_.failsToOpen = "there is no such port";
  controller_.run();
  EXPECT_TRUE(controller_.scanFailure().contains("no such port"));
  EXPECT_FALSE(controller_.hasSession());
  EXPECT_FALSE(QFile::exists(path("out/session.vantage")));
}

TEST_F(DeviceFailure, APersonTakesThePlaceOfTheTableAndTheSessionRemembersIt) {
  prepare(SerialTableDevice{"/dev/nothing", {}});
  controller_.step();
  devices_.table->failsNext = "was unplugged";
  controller_.run();
  controller_.turnByHand();
  EXPECT_EQ(controller_.mode(), Mode::Assisted);
  EXPECT_TRUE(controller_.scanFailure().isEmpty());
  EXPECT_FALSE(controller_.canTurnByHand());
  controller_.step();
  EXPECT_EQ(countScans(*controller_.now(), ScanStatus::In), 2U) << controller_.scanFailure().toStdString();
  const QString session = controller_.sessionPath();
  controller_.close();
  controller_.open(session);
  ASSERT_TRUE(controller_.setUp()) << failure_.toStdString();
  EXPECT_TRUE(turnedByHand(*controller_.setUp()));
}

TEST_F(DeviceFailure, ScansAreTakenAsTheyComeWhileAPersonTurnsTheTable) {
  prepare(HandTableDevice{});
  EXPECT_EQ(controller_.mode(), Mode::Assisted);
  ASSERT_TRUE(controller_.takesAsTheyCome());
  EXPECT_TRUE(controller_.permissions().whyNotRun().isEmpty());
  controller_.run();
  EXPECT_GE(countScans(*controller_.now(), ScanStatus::In), 3U) << controller_.scanFailure().toStdString();
  for (const KeptScan& scan : controller_.now()->scans) EXPECT_EQ(scan.view.image->poseKnownBy, PoseSource::ByHand);
}

}  // namespace
}  // namespace vantage
