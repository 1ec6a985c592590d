// Recorded scans brought into the window.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "io/mesh_writer.h"
#include "io/range_files.h"
#include "session_controller.h"
#include "session_import.h"
#include "support/scenes/small_scene.h"
#include "wizard/import_dialog.h"
#include "wizard/scan_list.h"

namespace vantage {
namespace {

// Scans of the small object as files, and a window's controller that works at once.
class ImportTest : public ::testing::Test {
 protected:
  ImportTest() {
    std::ofstream(path("scanner.json").toStdString()) << testing::smallProfileSource().text;
    exportMesh(testing::smallObject(), path("object.ply").toStdString());
    const auto profile = testing::smallProfile();
    const Rig rig = testing::simulation(testing::smallObject(), profile, {});
    for (const int position : kPositions) {
      files_ << path(QStringLiteral("scan_%1.ply").arg(position));
      writeRangeFile(scanFrom(rig, position, {}), files_.back().toStdString());
    }
    QObject::connect(&controller_, &SessionController::failed, [this](const QString& what) { failure_ = what; });
    QObject::connect(&controller_, &SessionController::importFailed, [this](const QString& what) { failure_ = what; });
  }
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] ImportChoice choice() const {
    ImportChoice choice;
    choice.scanner = path("scanner.json").toStdString();
    choice.folder = path("out/imported").toStdString();
    for (int i = 0; i < files_.size(); ++i) {
      choice.recorded.files.push_back(files_[i].toStdString());
      choice.recorded.positions.emplace_back(kPositions[static_cast<std::size_t>(i)]);
    }
    return choice;
  }
  void beginSession() {
    SetUpChoice setUp;
    setUp.scanner = path("scanner.json").toStdString();
    setUp.folder = path("session").toStdString();
    setUp.settings.simulation.object = path("object.ply").toStdString();
    controller_.setChoice(setUp);
    controller_.prepare();
    controller_.step();
    ASSERT_TRUE(controller_.now()) << failure_.toStdString();
  }

  static constexpr std::array kPositions{0, 3, 6};
  QTemporaryDir folder_;
  QStringList files_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  QString failure_;
};

TEST_F(ImportTest, MakesASessionOfRecordedScans) {
  controller_.importScans(choice());
  ASSERT_TRUE(controller_.hasSession()) << failure_.toStdString();
  EXPECT_EQ(countScans(*controller_.now(), ScanStatus::In), 3U);
  EXPECT_EQ(controller_.now()->termination, Termination::Imported);
  EXPECT_TRUE(QFile::exists(path("out/imported/session.vantage")));
}

TEST_F(ImportTest, WhatFailsLeavesNothingAndNothingOpenIsClosed) {
  beginSession();
  const QString open = controller_.sessionPath();
  ImportChoice broken = choice();
  broken.recorded.files[1] = path("nothing.ply").toStdString();
  controller_.importScans(broken);
  EXPECT_TRUE(failure_.contains("nothing.ply")) << failure_.toStdString();
  EXPECT_FALSE(QDir(path("out")).exists());
  EXPECT_EQ(controller_.sessionPath(), open);
}

TEST_F(ImportTest, AddsScansToTheOpenSessionAtTheirPositions) {
  beginSession();
  RecordedScans recorded{{files_[1].toStdString()}, {}, {3}, {}};
  controller_.addScans(recorded);
  EXPECT_TRUE(failure_.isEmpty()) << failure_.toStdString();
  ASSERT_EQ(controller_.now()->scans.size(), 2U);
  EXPECT_EQ(controller_.now()->scans[1].station().position, 3);
  EXPECT_EQ(controller_.now()->scans[1].status, ScanStatus::In);
  recorded.files = {path("nothing.ply").toStdString()};
  controller_.addScans(recorded);
  EXPECT_TRUE(failure_.contains("nothing.ply"));
  EXPECT_TRUE(controller_.scanFailure().isEmpty()) << "no device failed";
}

TEST_F(ImportTest, ANewSessionIsAskedForWithItsFilesAndPositions) {
  ImportDialog dialog(controller_, ImportDialog::Into::NewSession);
  ImportChoice suggested;
  suggested.scanner = choice().scanner;
  suggested.folder = choice().folder;
  dialog.suggest(suggested);
  auto* bringIn = dialog.findChild<QPushButton*>("bringIn");
  EXPECT_FALSE(bringIn->isEnabled());
  dialog.addFiles(files_);
  EXPECT_TRUE(bringIn->isEnabled()) << bringIn->toolTip().toStdString();
  dialog.findChild<QComboBox*>("importScanner")->setCurrentIndex(1);
  auto* table = dialog.findChild<QTableWidget*>("scanFiles");
  for (int row = 0; row < 3; ++row)
    qobject_cast<QSpinBox*>(table->cellWidget(row, 1))->setValue(kPositions[static_cast<std::size_t>(row)]);
  bringIn->click();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  ASSERT_TRUE(controller_.now()) << failure_.toStdString();
  EXPECT_EQ(controller_.now()->scans[2].station().position, 6);
}

TEST_F(ImportTest, WhatIsWrongIsSaidAndNothingThatWasChosenIsLost) {
  ImportDialog dialog(controller_, ImportDialog::Into::NewSession);
  dialog.suggest(choice());
  dialog.addFiles({files_[0], path("nothing.ply")});
  dialog.findChild<QPushButton*>("bringIn")->click();
  EXPECT_TRUE(dialog.findChild<QLabel*>("importComplaint")->text().contains("nothing.ply"));
  EXPECT_EQ(dialog.findChild<QTableWidget*>("scanFiles")->rowCount(), 2);
  EXPECT_FALSE(controller_.hasSession());
}

// Esc while it works: what is under way is stopped, the dialog and what was chosen stay, and a second Esc leaves.
TEST_F(ImportTest, EscStopsTheImportBeforeItLeaves) {
  ThreadedJobRunner jobs(1);
  SessionController controller(jobs, "");
  ImportDialog dialog(controller, ImportDialog::Into::NewSession);
  dialog.suggest(choice());
  dialog.addFiles(files_);
  dialog.show();
  dialog.findChild<QPushButton*>("bringIn")->click();
  ASSERT_FALSE(controller.idle());
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_TRUE(dialog.isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller.idle(); }, 60'000));
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_FALSE(controller.hasSession());
  EXPECT_FALSE(QFile::exists(path("out/imported/session.vantage")));
  EXPECT_EQ(dialog.findChild<QTableWidget*>("scanFiles")->rowCount(), 3);
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_FALSE(dialog.isVisible());
}

TEST_F(ImportTest, RowsAndColumnsAreTakenOnlyWhereTheyAreSome) {
  ImportDialog dialog(controller_, ImportDialog::Into::NewSession);
  dialog.suggest(choice());
  dialog.addFiles(files_);
  auto* bringIn = dialog.findChild<QPushButton*>("bringIn");
  auto* grid = dialog.findChild<QLineEdit*>("importGrid");
  for (const char* wrong : {"480", "x", "1x5", "480x", "axb"}) {
    grid->setText(wrong);
    EXPECT_FALSE(bringIn->isEnabled()) << wrong;
  }
  for (const char* right : {"480x640", " 2 x 3 ", ""}) {
    grid->setText(right);
    EXPECT_TRUE(bringIn->isEnabled()) << right;
  }
  dialog.findChild<QLineEdit*>("importNoSample")->setText("nought");
  EXPECT_FALSE(bringIn->isEnabled());
}

TEST_F(ImportTest, OfSeveralFilesForAnOpenSessionEachIsAskedForItsPosition) {
  beginSession();
  ImportDialog dialog(controller_, ImportDialog::Into::OpenSession);
  dialog.addFiles({files_[1], files_[2]});
  auto* bringIn = dialog.findChild<QPushButton*>("bringIn");
  EXPECT_FALSE(bringIn->isEnabled());
  EXPECT_TRUE(bringIn->toolTip().contains("position")) << bringIn->toolTip().toStdString();
  auto* table = dialog.findChild<QTableWidget*>("scanFiles");
  EXPECT_EQ(qobject_cast<QSpinBox*>(table->cellWidget(0, 1))->value(), controller_.present().nextPosition().value());
  qobject_cast<QSpinBox*>(table->cellWidget(0, 1))->setValue(3);
  qobject_cast<QSpinBox*>(table->cellWidget(1, 1))->setValue(6);
  bringIn->click();
  EXPECT_TRUE(failure_.isEmpty()) << failure_.toStdString();
  EXPECT_EQ(controller_.now()->scans.size(), 3U);
}

TEST_F(ImportTest, TheListTakesFoldersOnceAndInTheOrderThatIsWanted) {
  ScanList list;
  list.setPositions(24);
  list.addFiles({folder_.path()});
  list.addFiles({files_[0]});
  std::vector<std::string> expected;
  for (const char* name : {"object.ply", "scan_0.ply", "scan_3.ply", "scan_6.ply"})
    expected.push_back(path(name).toStdString());
  EXPECT_EQ(list.files(), expected);
  list.findChild<QTableWidget*>()->setCurrentCell(0, 0);
  list.findChild<QPushButton*>("removeFiles")->click();
  list.findChild<QTableWidget*>()->setCurrentCell(2, 0);
  list.findChild<QPushButton*>("moveUp")->click();
  EXPECT_EQ(list.files(), (std::vector{expected[1], expected[3], expected[2]}));
  EXPECT_EQ(list.positions(), (std::vector<std::optional<int>>(3)));
}

}  // namespace
}  // namespace vantage
