#include "wizard/test_scan_box.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTemporaryDir>
#include <fstream>

#include "app/told_devices.h"
#include "session_controller.h"

namespace vantage {
namespace {

TEST(TestScanBox, WarnsOnlyWhileNothingOfTheScanIsUsed) {
  const QTemporaryDir folder;
  std::ofstream(folder.filePath("scanner.json").toStdString()) << testing::smallProfileSource().text;
  testing::ToldDevices devices;
  SynchronousJobRunner jobs;
  SessionController controller{jobs, "", devices.factory()};
  SetUpChoice choice;
  choice.scanner = folder.filePath("scanner.json").toStdString();
  choice.folder = folder.filePath("out").toStdString();
  choice.rig = {FolderDevice{folder.path().toStdString()}, SerialTableDevice{"/dev/nothing", {}}, {}, {}};
  choice.settings.cut.volume = true;
  choice.settings.cut.tableMargin = 900.0;
  controller.setChoice(choice);
  controller.prepare();
  TestScanBox box(controller);
  auto* verdict = box.findChild<QLabel*>("testScanVerdict");
  controller.testScan();
  EXPECT_TRUE(verdict->isVisibleTo(&box));
  EXPECT_EQ(verdict->property("role").toString(), "warning");
  EXPECT_TRUE(verdict->text().startsWith("Nothing of the scan is used"));
  CutOptions less;
  less.volume = true;
  controller.setCut(less);
  EXPECT_FALSE(verdict->isVisibleTo(&box));
  controller.setCut(choice.settings.cut);
  EXPECT_TRUE(verdict->isVisibleTo(&box));
  choice.rig.table = HandTableDevice{};
  controller.setChoice(choice);
  EXPECT_TRUE(verdict->isVisibleTo(&box));
  EXPECT_EQ(verdict->property("role").toString(), "");
  EXPECT_TRUE(verdict->text().startsWith("A test scan shows")) << verdict->text().toStdString();
}

}  // namespace
}  // namespace vantage
