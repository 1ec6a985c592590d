// The object turned over in the whole window, drawn without a display.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <fstream>

#include "acquisition/stand_composites.h"
#include "app/told_devices.h"
#include "app/window_checks.h"
#include "docks/stand_strip.h"
#include "docks/time_line.h"
#include "io/mesh_writer.h"
#include "main_window.h"
#include "screenshots/painted_text.h"
#include "screenshots/screenshot.h"
#include "stand_text.h"
#include "stands/stand_dialog.h"
#include "wizard/device_editor.h"
#include "wizard/stand_box.h"
#include "wizard/stand_sides.h"

namespace vantage {
namespace {

void settle() {
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
}

// What is done to the window, and how it looks then.
class StandPages : public ::testing::Test {
 protected:
  void click(const char* name) {
    for (auto* button : window_.findChildren<QPushButton*>(QString::fromLatin1(name))) {
      if (!button->isVisible()) continue;
      ASSERT_TRUE(button->isEnabled()) << name << ": " << button->toolTip().toStdString();
      button->click();
      return settle();
    }
    FAIL() << "no button " << name << " in sight";
  }
  QImage look(const QString& name) {
    window_.views().model().view().finishLoading();
    settle();
    QImage image = window_.grab().toImage();
    const QString folder = qEnvironmentVariable("VANTAGE_SCREENSHOTS", QStringLiteral(VANTAGE_SCREENSHOT_DIR));
    QDir().mkpath(folder);
    image.save(folder + QStringLiteral("/stands_") + name + QStringLiteral(".png"));
    EXPECT_TRUE(testing::isNotBlank(image)) << name.toStdString();
    EXPECT_EQ(testing::clipped(window_).join(" | ").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::nameless(window_).join(" | ").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::unexplained(window_).join(" | ").toStdString(), "") << name.toStdString();
    const auto texts = testing::paintedText(window_);
    EXPECT_EQ(testing::cutOff(texts).join(" | ").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::overlapping(texts).join(" | ").toStdString(), "") << name.toStdString();
    return image;
  }
  void expectSaid(const QString& text) {
    EXPECT_TRUE(testing::says(window_, text)) << "nowhere: " << text.toStdString();
  }
  void expectPage(const char* key) { EXPECT_EQ(window_.wizard().page().key().toStdString(), key); }
  [[nodiscard]] QWidget& strip() { return *window_.findChild<QWidget*>(QStringLiteral("standStrip")); }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  testing::ToldDevices devices_;
  SessionController controller_{jobs_, QDir::temp().filePath("vantage-pages-cache").toStdString(),
                                usesTold_ ? devices_.factory() : DeviceFactory()};
  MainWindow window_{WindowParts{controller_, jobs_, testing::testSurfaces(), QStringLiteral(VANTAGE_RESOURCES)}, {}};

 private:
  static inline bool usesTold_ = false;
  friend class DevicesTurnedOver;
};

TEST_F(StandPages, AWholeJobInTwoStands) {
  window_.resize(1280, 800);
  window_.show();
  window_.findChild<QSpinBox*>("max_views")->setValue(5);
  window_.findChild<QLineEdit*>("folder")->setText(folder_.path());
  window_.wizard().goOn();
  window_.wizard().goOn();
  settle();
  EXPECT_FALSE(window_.findChild<QPushButton*>("turnOver")->isEnabled()) << "nothing was scanned";
  EXPECT_FALSE(strip().isVisible());
  click("run");
  expectPage("review");
  click("turnOver");
  expectPage("turn_over");
  auto* sides = window_.findChild<StandSides*>();
  ASSERT_GE(sides->count(), 2);
  EXPECT_EQ(sides->chosen(), 0);
  EXPECT_FALSE(sides->item(0)->icon().isNull());
  expectSaid("On another side the scanner would see up to ");
  expectSaid("It falls over beyond a tilt of");
  look("turn_over");
  sides->setCurrentRow(1);
  look("turn_over_other");
  window_.resize(1024, 768);
  look("turn_over_small");
  window_.resize(1280, 800);
  sides->setCurrentRow(0);
  const SharedState first = controller_.now();
  click("turned");
  expectPage("acquire");
  ASSERT_EQ(controller_.now()->stand(), 1);
  look("begun");
  expectSaid("Stand 1 is a model of its own");
  expectSaid("No view of stand 1 taken yet");
  EXPECT_TRUE(strip().isVisible());
  click("step");
  look("own_model");
  expectSaid("Stand 1 alone after 1 view");
  expectSaid("The object without it");
  window_.wizard().goTo(QStringLiteral("review"));
  look("own_model_review");
  expectSaid("Stand 1, not put together with the object yet");
  window_.wizard().goTo(QStringLiteral("finish"));
  look("own_model_finish");
  expectSaid("Stand 1 is not in it: it is not put together with the object.");
  window_.wizard().goTo(QStringLiteral("acquire"));
  click("run");
  const AcquisitionState& now = *controller_.now();
  look("ended");
  ASSERT_TRUE(now.stands[1].T_object_table) << standSentence(now.stands, 1).toStdString();
  expectPage("review");
  expectSaid(standSentence(now.stands, 1));
  EXPECT_EQ(compositeInWork(now), referenceOf(now.stands));
  EXPECT_GT(area(now.model->mesh), area(first->model->mesh));
  EXPECT_TRUE(strip().accessibleDescription().contains("Stand 1 · aligned"))
      << strip().accessibleDescription().toStdString();
  window_.wizard().goTo(QStringLiteral("acquire"));
  look("aligned");
  click("backToOneStand");
  EXPECT_EQ(controller_.now()->stand(), 0);
  EXPECT_EQ(controller_.now()->scans.size(), first->scans.size());
  EXPECT_TRUE(strip().accessibleDescription().contains("Stand 1 · aligned (undone)"));
  look("back");
}

TEST_F(StandPages, PosesAreComparedWhereTheStandIsNotInPlace) {
  window_.resize(1280, 800);
  window_.show();
  window_.findChild<QSpinBox*>("max_views")->setValue(1);
  window_.findChild<QLineEdit*>("folder")->setText(folder_.path());
  window_.wizard().goOn();
  window_.wizard().goOn();
  settle();
  click("run");
  window_.wizard().goTo(QStringLiteral("turn_over"));
  settle();
  click("turned");
  const auto* compare = window_.findChild<QPushButton*>("comparePoses");
  EXPECT_FALSE(compare->isVisible()) << "nothing was tried yet";
  click("step");
  window_.wizard().goTo(QStringLiteral("acquire"));
  settle();
  ASSERT_FALSE(controller_.now()->stands[1].T_object_table) << "one view of either side";
  look("not_in_place");
  click("comparePoses");
  const auto* dialog = window_.findChild<StandDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_TRUE(dialog->isVisible());
}

// The same with real devices: the scanner sees what stands there, whoever put it so.
class DevicesTurnedOver : public StandPages {
 protected:
  static void SetUpTestSuite() { usesTold_ = true; }
  static void TearDownTestSuite() { usesTold_ = false; }

  void goToAcquire(const TableDevice& table) {
    std::ofstream(folder_.filePath("scanner.json").toStdString()) << testing::smallProfileSource().text;
    window_.resize(1280, 800);
    window_.show();
    auto* scanner = window_.findChild<QComboBox*>("scanner");
    scanner->addItem("small", folder_.filePath("scanner.json"));
    scanner->setCurrentIndex(scanner->count() - 1);
    window_.findChild<QLineEdit*>("folder")->setText(folder_.filePath("out"));
    window_.findChild<DeviceEditor*>()->setRig({FolderDevice{folder_.path().toStdString()}, table, {}, {}});
    for (const char* cut : {"cut.volume", "cut.flying_pixels", "cut.isolated"})
      window_.findChild<QCheckBox*>(cut)->setChecked(false);
    for (int i = 0; i < 5 && window_.wizard().page().key() != "acquire"; ++i) window_.wizard().goOn();
    expectPage("acquire");
  }

  void turnOverAndScanOn() {
    for (int i = 0; i < 3; ++i) controller_.step();
    const auto open = window_.wizard().page().key();
    if (open != "acquire") window_.wizard().goTo(QStringLiteral("acquire"));
    settle();
    click("turnOver");
    expectPage("turn_over");
    expectSaid("Put it on that side anywhere near the axis, turned in any way");
    look(QStringLiteral("turn_over_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    click("turned");
    expectPage("acquire");
    controller_.step();
    EXPECT_EQ(controller_.now()->scans.back().station().stand, 1);
    EXPECT_EQ(controller_.now()->scans.back().status, ScanStatus::In);
    settle();
    expectSaid("Stand 1 alone after 1 view");
  }
};

TEST_F(DevicesTurnedOver, ByAPersonWhoTurnsTheTable) {
  goToAcquire(HandTableDevice{});
  EXPECT_EQ(controller_.mode(), Mode::Assisted);
  turnOverAndScanOn();
  EXPECT_EQ(controller_.mode(), Mode::Assisted);
}

TEST_F(DevicesTurnedOver, BeforeATableThatTurnsByItself) {
  goToAcquire(SerialTableDevice{"/dev/nothing", {}});
  turnOverAndScanOn();
}

}  // namespace
}  // namespace vantage
