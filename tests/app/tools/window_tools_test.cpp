// The tool bar in the whole window, without a display.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include "app/desk.h"
#include "app/window_checks.h"
#include "window/tool_bar.h"

namespace vantage {
namespace {

using testing::Desk;

const QStringList kAllPages{"choose", "check", "calibrate", "acquire", "turn_over", "review", "finish"};

QToolButton* tool(Desk& desk, const QString& icon) {
  return desk.window().findChild<QToolButton*>("tool_" + icon);
}

void expectRunControls(Desk& desk, const std::string& when) {
  Desk::settle();
  for (const char* icon : {"run", "scan", "pause", "stop"}) {
    const QToolButton* button = tool(desk, icon);
    ASSERT_NE(button, nullptr) << icon;
    EXPECT_TRUE(button->isVisible()) << icon << ", " << when;
    const QRect place(button->mapTo(&desk.window(), QPoint()), button->size());
    EXPECT_TRUE(desk.window().rect().contains(place)) << icon << ", " << when;
  }
}

TEST(WindowTools, RunIsControlledFromEveryPageAndInEveryStateOfTheDocks) {
  Desk desk({1000, 700}, false);
  desk.next();
  desk.next();
  for (const QString& page : kAllPages) {
    desk.window().wizard().goTo(page);
    expectRunControls(desk, page.toStdString());
  }
  for (auto* dock : desk.window().findChildren<QDockWidget*>()) dock->hide();
  expectRunControls(desk, "without docks");
  for (auto* dock : desk.window().findChildren<QDockWidget*>()) {
    dock->setFloating(true);
    dock->show();
  }
  expectRunControls(desk, "with floating docks");
}

// A layout that was kept before there were tools has none.
TEST(WindowTools, AreThereWithALayoutOfBefore) {
  QByteArray before;
  {
    QMainWindow old;
    for (const char* name : {"wizardDock", "objectiveDock", "timeLineDock"}) {
      auto* dock = new QDockWidget;
      dock->setObjectName(name);
      old.addDockWidget(Qt::LeftDockWidgetArea, dock);
    }
    before = old.saveState(1);
  }
  Desk desk({1280, 800}, false);
  QSettings().setValue("window/layout", before);
  desk.window().restoreLayout();
  expectRunControls(desk, "after restoring");
  QSettings().remove("window/layout");
}

TEST(WindowTools, SayWhatTheyDoAndWhyTheyCannot) {
  Desk desk({1280, 800}, false);
  EXPECT_EQ(tool(desk, "run")->toolTip().toStdString(), "Run or go on (F5)\nScanner and object are not read yet.");
  EXPECT_EQ(tool(desk, "undo")->toolTip().section('\n', 0, 0).toStdString(), "Undo (Ctrl+Z)");
  EXPECT_EQ(tool(desk, "export")->toolTip().section('\n', 0, 0).toStdString(), "Export the model (Ctrl+E)");
  desk.next();
  EXPECT_TRUE(tool(desk, "run")->isEnabled());
  EXPECT_EQ(testing::unexplained(desk.window()).join(" | ").toStdString(), "");
  EXPECT_EQ(testing::nameless(desk.window()).join(" | ").toStdString(), "");
}

TEST(WindowTools, OneScanUndoRedoAndANewSession) {
  Desk desk({1280, 800}, false);
  desk.next();
  tool(desk, "scan")->click();
  ASSERT_TRUE(desk.controller().now());
  EXPECT_EQ(countScans(*desk.controller().now(), ScanStatus::In), 1U);
  tool(desk, "undo")->click();
  EXPECT_EQ(countScans(*desk.controller().now(), ScanStatus::In), 0U);
  tool(desk, "redo")->click();
  EXPECT_EQ(countScans(*desk.controller().now(), ScanStatus::In), 1U);
  desk.picture("tools_light");
  tool(desk, "report")->click();
  EXPECT_TRUE(QFileInfo::exists(Desk::folder() + "/report.html"));
  tool(desk, "new")->click();
  EXPECT_FALSE(desk.controller().hasSession());
  EXPECT_EQ(desk.window().wizard().page().key(), "choose");
  EXPECT_TRUE(QFileInfo::exists(Desk::folder() + "/session.vantage"));
}

TEST(WindowTools, AreSeenInTheDark) {
  Desk desk({1280, 800}, true);
  desk.next();
  desk.next();
  desk.controller().step();
  EXPECT_TRUE(testing::isNotBlank(desk.picture("tools_dark")));
}

}  // namespace
}  // namespace vantage
