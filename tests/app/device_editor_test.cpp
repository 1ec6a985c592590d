#include "wizard/device_editor.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>

namespace vantage {
namespace {

TEST(DeviceEditor, BeginsWithTheSimulation) {
  const DeviceEditor editor;
  EXPECT_TRUE(editor.simulated());
  EXPECT_EQ(editor.rig(), RigDescription());
  EXPECT_TRUE(editor.whyNot().isEmpty());
}

TEST(DeviceEditor, SaysWhatIsMissingOfARealScanner) {
  DeviceEditor editor;
  auto* sensor = editor.findChild<QComboBox*>(QStringLiteral("sensor"));
  sensor->setCurrentIndex(sensor->findText(QStringLiteral("Files in a folder")));
  EXPECT_FALSE(editor.simulated());
  EXPECT_TRUE(editor.whyNot().contains(QStringLiteral("folder")));
  editor.findChild<QLineEdit*>(QStringLiteral("sensorPath"))->setText(QStringLiteral("/tmp/scans"));
  EXPECT_TRUE(editor.whyNot().contains(QStringLiteral("port")));
  editor.findChild<QComboBox*>(QStringLiteral("port"))->setEditText(QStringLiteral("/tmp/table"));
  EXPECT_TRUE(editor.whyNot().isEmpty());
  EXPECT_EQ(editor.rig(), (RigDescription{FolderDevice{"/tmp/scans"}, SerialTableDevice{"/tmp/table", {}}, {}, {}}));
}

TEST(DeviceEditor, ShowsWhatASessionWasScannedWith) {
  const RigDescription rigs[] = {{FolderDevice{"/a"}, HandTableDevice{}, {}, "c.json"},
                                 {OpenNi2Device{"uri"}, SerialTableDevice{"/dev/x", "grbl"}, {}, {}},
                                 {ReplayDevice{"s.vantage"}, NoTableDevice{}, {}, {}},
                                 {ProgramDevice{{"scan", "{file}"}}, ProgramDevice{{"turn", "{angle}"}}, {}, {}}};
  for (const RigDescription& rig : rigs) {
    DeviceEditor editor;
    editor.setRig(rig);
    EXPECT_EQ(editor.rig(), rig);
  }
}

}  // namespace
}  // namespace vantage
