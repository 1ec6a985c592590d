#include "diagnostics.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>

#include "diagnostics_dialog.h"
#include "program/version.h"

namespace vantage {
namespace {

std::string without(const char* text, const QStringList& files = {}) {
  return withoutFiles(QString::fromUtf8(text), files).toStdString();
}

TEST(Diagnostics, LeavesOutEveryNameOfAFile) {
  EXPECT_EQ(without("Written: /home/ann/my mug/model.stl", {"/home/ann/my mug/model.stl"}), "Written: <file>");
  EXPECT_EQ(without("sensor: folder:/srv/scans"), "sensor: <file>");
  EXPECT_EQ(without("cannot read scan_12.ply: no such file"), "cannot read <file>: no such file");
  EXPECT_EQ(without("../x/y and ~/z"), "<file> and <file>");
  EXPECT_EQ(without("user ann has it", {"/home/ann", "ann"}), "user <file> has it");
  // A longer name is not cut by a shorter one in it.
  EXPECT_EQ(without("open /a/b/c d.vantage", {"/a/b", "/a/b/c d.vantage"}), "open <file>");
}

TEST(Diagnostics, KeepsFigures) {
  EXPECT_EQ(without("view 3: 31234 samples, +12.5 mm2, 0.083 mm, 98.2 %."),
            "view 3: 31234 samples, +12.5 mm2, 0.083 mm, 98.2 %.");
  EXPECT_EQ(without("version 0.1.0, OpenGL 4.5"), "version 0.1.0, OpenGL 4.5");
}

class DiagnosticsOfAController : public ::testing::Test {
 protected:
  DiagnosticsOfAController() {
    SetUpChoice choice;
    choice.rig.sensor = FolderDevice{"/srv/secret scans"};
    choice.scanner = "/home/ann/scanner.json";
    choice.folder = "/home/ann/mug";
    choice.settings.maxViews = 7;
    controller_.setChoice(choice);
    diagnostics_ = diagnose(controller_, Preferences{},
                            {"10:00:00  Problem: /srv/secret scans/7.ply is empty", "10:00:01  view 1"});
  }

  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  Diagnostics diagnostics_;
};

TEST_F(DiagnosticsOfAController, TellVersionMachineDevicesSettingsAndLog) {
  const QString text = textOf(diagnostics_, true);
  EXPECT_TRUE(text.startsWith(QString::fromStdString(versionText("vantage"))));
  for (const char* part : {"[machine]", "OpenGL: ", "[devices]", "sensor: folder:/srv/secret scans", "[settings]",
                           "max_views: 7", "[log]", "10:00:01  view 1"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << "\n" << text.toStdString();
}

TEST_F(DiagnosticsOfAController, TellNoNamesUnlessAgreed) {
  const QString text = textOf(diagnostics_, false);
  for (const char* name : {"secret", "ann", "7.ply"}) EXPECT_FALSE(text.contains(QString::fromUtf8(name))) << name;
  EXPECT_TRUE(text.contains("max_views: 7"));
  EXPECT_TRUE(text.contains("10:00:00  Problem: <file> is empty") || text.contains("10:00:00  Problem: <file>"));
}

TEST_F(DiagnosticsOfAController, TheDialogCopiesWhatItShows) {
  DiagnosticsDialog dialog(diagnostics_);
  const auto* text = dialog.findChild<QPlainTextEdit*>("diagnostics");
  EXPECT_FALSE(text->toPlainText().contains("secret"));
  dialog.findChild<QPushButton*>("copyDiagnostics")->click();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), text->toPlainText());
  dialog.findChild<QCheckBox*>("withFiles")->setChecked(true);
  EXPECT_TRUE(text->toPlainText().contains("secret"));
  dialog.findChild<QPushButton*>("copyDiagnostics")->click();
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains("secret"));
}

}  // namespace
}  // namespace vantage
