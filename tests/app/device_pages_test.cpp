// The pages of the whole window before devices, drawn without a display.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <fstream>

#include "app/told_devices.h"
#include "app/window_checks.h"
#include "ending_text.h"
#include "main_window.h"
#include "screenshots/screenshot.h"
#include "support/scenes/small_scene.h"
#include "wizard/device_editor.h"

namespace vantage {
namespace {

// The window before real devices that a test tells what to do.
class DevicePages : public ::testing::Test {
 protected:
  void goToAcquire(const TableDevice& table) {
    std::ofstream(folder_.filePath("scanner.json").toStdString()) << testing::smallProfileSource().text;
    window_.resize(1280, 800);
    window_.show();
    auto* scanner = window_.findChild<QComboBox*>("scanner");
    scanner->addItem("small", folder_.filePath("scanner.json"));
    scanner->setCurrentIndex(scanner->count() - 1);
    window_.findChild<QLineEdit*>("folder")->setText(folder_.filePath("out"));
    window_.findChild<DeviceEditor*>()->setRig({FolderDevice{folder_.path().toStdString()}, table, {}, {}});
    // The small object has few samples to lose.
    for (const char* cut : {"cut.volume", "cut.flying_pixels", "cut.isolated"})
      window_.findChild<QCheckBox*>(cut)->setChecked(false);
    for (int i = 0; i < 5 && window_.wizard().page().key() != "acquire"; ++i) window_.wizard().goOn();
    ASSERT_EQ(window_.wizard().page().key(), "acquire");
  }
  [[nodiscard]] qsizetype boxes() const { return window_.findChildren<QMessageBox*>().size(); }

  QTemporaryDir folder_;
  testing::ToldDevices devices_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, "", devices_.factory()};
  MainWindow window_{WindowParts{controller_, jobs_, testing::testSurfaces(), QStringLiteral(VANTAGE_RESOURCES)}, {}};
};

// A table that fails in a run: its card says so with the ways on, and no box says it a second time.
TEST_F(DevicePages, AScanThatTheyFailedIsToldOnceWithTheWaysOn) {
  goToAcquire(SerialTableDevice{"/dev/nothing", {}});
  controller_.step();
  devices_.table->failsNext = "was unplugged";
  controller_.step();
  ASSERT_TRUE(controller_.scanFailure().contains("was unplugged")) << controller_.scanFailure().toStdString();
  EXPECT_TRUE(testing::says(window_, controller_.scanFailure()));
  for (const char* name : {"again", "byHand"}) EXPECT_TRUE(window_.findChild<QPushButton*>(name)->isVisible()) << name;
  EXPECT_EQ(boxes(), 0);
  window_.wizard().goOn();
  ASSERT_EQ(window_.wizard().page().key(), "review");
  devices_.table->failsNext = "was unplugged";
  controller_.step();
  EXPECT_EQ(boxes(), 1) << "the card is out of sight";
}

TEST_F(DevicePages, AScanThatFitsElsewhereIsOfferedFromThere) {
  goToAcquire(HandTableDevice{});
  for (const int position : {0, 1, 2, 3}) {
    if (controller_.hasSession()) controller_.choosePosition(position);
    controller_.step();
  }
  controller_.choosePosition(4);
  devices_.handOff = 55.0;
  controller_.step();
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  QPushButton* offer = nullptr;
  for (auto* button : window_.findChildren<QPushButton*>("takeAsFrom"))
    if (button->isVisible()) offer = button;
  // The acquisition goes on: the same position is asked for once more.
  EXPECT_EQ(window_.wizard().page().key(), "acquire");
  ASSERT_TRUE(offer) << failedScanText(*controller_.now()).toStdString();
  QDir().mkpath(QStringLiteral(VANTAGE_SCREENSHOT_DIR));
  window_.grab().save(QStringLiteral(VANTAGE_SCREENSHOT_DIR) + "/window_3_fits_elsewhere.png");
  EXPECT_EQ(testing::clipped(window_).join(" | ").toStdString(), "");
  // Something else changes: the button stays the one that somebody is about to click.
  controller_.setMode(controller_.mode() == Mode::Automatic ? Mode::Assisted : Mode::Automatic);
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  EXPECT_EQ(window_.findChildren<QPushButton*>("takeAsFrom").count(offer), 1);
  EXPECT_TRUE(offer->isVisible());
  offer->click();
  EXPECT_EQ(controller_.now()->scans.back().status, ScanStatus::In);
}

}  // namespace
}  // namespace vantage
