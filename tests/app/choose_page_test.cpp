#include "wizard/choose_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "app/told_devices.h"
#include "io/mesh_writer.h"
#include "support/scenes/small_scene.h"
#include "wizard/device_editor.h"

namespace vantage {
namespace {

// The page over a folder of resources with one scanner and one object.
class ChoosePageTest : public ::testing::Test {
 protected:
  ChoosePageTest() {
    QDir(folder_.path()).mkpath("scanners");
    QDir(folder_.path()).mkpath("objects");
    std::ofstream(path("scanners/rotating_stripe.json")) << testing::smallProfileSource().text;
    exportMesh(testing::smallObject(), path("objects/mug.ply"));
    page_ = std::make_unique<ChoosePage>(controller_, folder_.path());
    object_ = page_->findChild<QComboBox*>("object");
  }

  [[nodiscard]] std::string path(const QString& name) const { return folder_.filePath(name).toStdString(); }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  std::unique_ptr<ChoosePage> page_;
  QComboBox* object_ = nullptr;
};

TEST_F(ChoosePageTest, AsksForTheObjectOfTheSimulatedScanner) {
  EXPECT_TRUE(page_->complete());
  object_->setCurrentIndex(-1);
  EXPECT_FALSE(page_->complete());
}

TEST_F(ChoosePageTest, ShowsNoObjectForASessionOfRecordedScansAndOneAgainAfterIt) {
  static_cast<void>(Session::create(path("recorded.vantage"), {std::nullopt, {}, nullptr}));
  controller_.open(folder_.filePath("recorded.vantage"));
  ASSERT_TRUE(controller_.hasSession());
  EXPECT_TRUE(object_->currentText().isEmpty()) << object_->currentText().toStdString();
  EXPECT_TRUE(page_->complete());
  controller_.close();
  EXPECT_TRUE(object_->currentData().toString().endsWith("mug.ply"));
  EXPECT_TRUE(page_->complete());
}

TEST_F(ChoosePageTest, AFolderThatWasTypedIsNotReplacedByASuggestion) {
  exportMesh(testing::smallObject(), path("objects/vase.ply"));
  page_ = std::make_unique<ChoosePage>(controller_, folder_.path());
  object_ = page_->findChild<QComboBox*>("object");
  auto* folder = page_->findChild<QLineEdit*>("folder");
  object_->setCurrentIndex(1 - object_->currentIndex());
  EXPECT_TRUE(folder->text().endsWith(object_->currentText().toLower())) << folder->text().toStdString();
  folder->selectAll();
  QTest::keyClicks(folder, "/tmp/mine");
  object_->setCurrentIndex(1 - object_->currentIndex());
  EXPECT_EQ(folder->text(), "/tmp/mine");
  folder->selectAll();
  QTest::keyClick(folder, Qt::Key_Delete);
  object_->setCurrentIndex(1 - object_->currentIndex());
  EXPECT_TRUE(folder->text().endsWith(object_->currentText().toLower())) << folder->text().toStdString();
}

TEST_F(ChoosePageTest, AsksForNothingOfTheSimulationWhereDevicesAreReal) {
  page_->show();
  const auto asks = [this](const char* name) { return page_->findChild<QWidget*>(name)->isVisible(); };
  page_->entered();
  EXPECT_TRUE(asks("object"));
  EXPECT_TRUE(asks("simulation.ideal"));
  auto* sensor = page_->findChild<QComboBox*>("sensor");
  sensor->setCurrentIndex(sensor->findText("Files in a folder"));
  EXPECT_FALSE(asks("object"));
  EXPECT_FALSE(asks("simulation.ideal"));
  EXPECT_TRUE(asks("max_views"));
}

// Devices, scanner and a calibration made with them: it is there still when the page is left once more.
TEST_F(ChoosePageTest, ACalibrationThatWasMadeStaysWhenTheOperatorGoesBack) {
  testing::ToldDevices devices;
  SessionController controller{jobs_, "", devices.factory()};
  ChoosePage page(controller, folder_.path());
  page.findChild<DeviceEditor*>()->setRig({FolderDevice{path("scans")}, SerialTableDevice{"/dev/nothing", {}}, {}, {}});
  page.leaving();
  controller.prepare();
  controller.calibrating().calibrate(4);
  ASSERT_TRUE(controller.calibrating().usable()) << controller.calibrating().failure().toStdString();
  controller.calibrating().keep(folder_.path());
  const std::string made = path("calibration.json");
  EXPECT_EQ(controller.choice().rig.calibration, made);
  page.entered();
  EXPECT_EQ(page.findChild<DeviceEditor*>()->rig().calibration, made);
  page.leaving();
  EXPECT_EQ(controller.choice().rig.calibration, made);
}

}  // namespace
}  // namespace vantage
