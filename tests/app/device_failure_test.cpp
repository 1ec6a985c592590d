// What a session does when its devices fail, and when a person takes the place of one.
#include <gtest/gtest.h>

#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "app/told_devices.h"
#include "ending_text.h"
#include "session_controller.h"
#include "wizard/other_turn_box.h"

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

// A person turned the table by far more than was asked: the scan is refused, where it fits is offered, and taken there
// it is a view.
TEST_F(DeviceFailure, AScanThatAPersonTookElsewhereIsTakenFromThere) {
  prepare(HandTableDevice{});
  // From every side, so that a place that is not the right one is seen to be wrong.
  for (const int position : {0, 1, 2, 3}) {
    if (controller_.hasSession()) controller_.choosePosition(position);
    controller_.step();
  }
  ASSERT_EQ(countScans(*controller_.now(), ScanStatus::In), 4U) << failure_.toStdString();
  OtherTurnBox box(controller_);
  const auto offers = [&] {
    std::vector<QPushButton*> shown;
    for (auto* button : box.findChildren<QPushButton*>("takeAsFrom"))
      if (button->isVisibleTo(&box)) shown.push_back(button);
    return shown;
  };
  EXPECT_TRUE(offers().empty());
  controller_.choosePosition(4);
  devices_.handOff = 55.0;
  controller_.step();
  ASSERT_EQ(controller_.now()->scans.back().status, ScanStatus::Rejected)
      << static_cast<int>(controller_.now()->scans.back().record.registration.verdict) << ' '
      << name(controller_.now()->scans.back().record.registration.finding.reason);
  ASSERT_EQ(offers().size(), 1U) << failedScanText(*controller_.now()).toStdString();
  EXPECT_TRUE(failedScanText(*controller_.now()).contains("fits")) << failedScanText(*controller_.now()).toStdString();
  offers().front()->click();
  EXPECT_EQ(controller_.now()->scans.back().status, ScanStatus::In) << failure_.toStdString();
  EXPECT_TRUE(offers().empty());
  controller_.undo();
  EXPECT_EQ(controller_.now()->scans.back().status, ScanStatus::Rejected);
}

// A scanner of five million rays: what it is going to take is known while it is still being prepared.
TEST(MemoryOfAScanner, IsToldBeforeItIsPrepared) {
  const QTemporaryDir folder;
  const QString profile = folder.filePath("large.json");
  std::ofstream(profile.toStdString()) << R"({"name": "large", "scanner": {"type": "pinhole", "position": [450, 0, 250],
    "look_at": [0, 0, 60], "rows": 2048, "columns": 2448, "horizontal_fov_deg": 40, "vertical_fov_deg": 34,
    "receivers": [[75, 0, 0]], "breakdown_angle_deg": 70, "range_mm": [300, 1500], "noise": {"range_sigma_mm": 0.1}},
    "workspace": {"type": "turntable", "steps": 36}, "viewing_volume": {"radius_mm": 100, "height_mm": 150},
    "mechanics": {"angle_sigma_deg": 0.3, "position_sigma_mm": 0.3}})";
  ThreadedJobRunner jobs(1);
  SessionController controller(jobs, "");
  QString failure;
  QObject::connect(&controller, &SessionController::failed, [&](const QString& what) { failure = what; });
  SetUpChoice choice;
  choice.scanner = profile.toStdString();
  choice.folder = folder.filePath("out").toStdString();
  choice.rig = {FolderDevice{folder.path().toStdString()}, NoTableDevice{}, {}, {}};
  controller.setChoice(choice);
  controller.prepare();
  EXPECT_TRUE(controller.memoryNote().isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !controller.memoryNote().isEmpty(); }, 60'000)) << failure.toStdString();
  EXPECT_EQ(controller.activity(), Activity::Preparing);
  EXPECT_TRUE(controller.memoryNote().contains("million rays")) << controller.memoryNote().toStdString();
  EXPECT_TRUE(controller.memoryNote().contains("GB"));
  controller.stop();
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller.idle(); }, 200'000));
  choice.scanner.clear();
  controller.setChoice(choice);
  EXPECT_TRUE(controller.memoryNote().isEmpty());
}

}  // namespace
}  // namespace vantage
