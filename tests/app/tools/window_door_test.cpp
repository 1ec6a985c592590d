// How sessions, scans and meshes come into the whole window: from the list of lately, and by being dropped.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDropEvent>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/desk.h"
#include "app/window_checks.h"
#include "io/mesh_writer.h"
#include "support/scenes/small_scene.h"
#include "wizard/import_dialog.h"

namespace vantage {
namespace {

using testing::Desk;

// Two sessions of lately, and one that is gone.
class WindowDoor : public ::testing::Test {
 protected:
  WindowDoor() {
    for (const char* name : {"mug", "handset"}) {
      QDir(folder_.path()).mkpath(name);
      paths_ << folder_.filePath(QString(name) + "/session.vantage");
      static_cast<void>(testing::importSmallScans(paths_.back().toStdString()));
    }
    exportMesh(testing::smallObject(), folder_.filePath("vase.stl").toStdString());
  }
  static void drop(Desk& desk, const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    // Not by the application, which gives it only to what something was dragged over.
    static_cast<QObject&>(desk.window()).event(&event);
    Desk::settle();
  }
  static QString saidByABox(Desk& desk) {
    for (const auto* box : desk.window().findChildren<QMessageBox*>())
      if (box->isVisible()) return box->text();
    return {};
  }

  QTemporaryDir folder_;
  QStringList paths_;
};

TEST_F(WindowDoor, SessionsOfLatelyAreOfferedOnTheFirstPage) {
  for (const bool dark : {false, true}) {
    Desk desk({1280, 800}, dark);
    for (const QString& path : paths_) desk.controller().open(path);
    desk.controller().close();
    QFile::rename(paths_[0], paths_[0] + ".away");
    desk.window().wizard().goTo(0);
    emit desk.window().menuBar()->actions()[0]->menu()->aboutToShow();
    for (auto* menu : desk.window().findChildren<QMenu*>())
      if (menu->title() == "Recentl&y opened") emit menu->aboutToShow();
    Desk::settle();
    desk.picture(dark ? "recent_dark" : "recent_light");
    auto* list = desk.window().findChild<QListWidget*>("recentSessions");
    ASSERT_TRUE(list->isVisible());
    ASSERT_EQ(list->count(), 2);
    EXPECT_TRUE(list->item(0)->text().startsWith("handset\nimported, 3 scans"));
    EXPECT_TRUE(list->item(1)->text().contains("gone")) << list->item(1)->text().toStdString();
    EXPECT_EQ(testing::clipped(desk.window()).join(" | ").toStdString(), "");
    QFile::rename(paths_[0] + ".away", paths_[0]);
    emit list->itemClicked(list->item(0));
    list->setCurrentRow(0);
    emit list->itemClicked(list->item(0));
    Desk::settle();
    EXPECT_EQ(desk.controller().sessionPath(), paths_[1]);
  }
}

TEST_F(WindowDoor, ASessionThatIsDroppedIsOpened) {
  Desk desk({1280, 800}, false);
  drop(desk, {paths_[0]});
  EXPECT_EQ(desk.controller().sessionPath(), paths_[0]);
  drop(desk, {folder_.filePath("handset")});
  EXPECT_EQ(desk.controller().sessionPath(), paths_[1]) << "its folder stands for it";
}

TEST_F(WindowDoor, AMeshThatIsDroppedIsAskedAbout) {
  Desk desk({1280, 800}, false);
  drop(desk, {folder_.filePath("vase.stl")});
  auto* box = desk.window().findChild<QMessageBox*>("droppedMesh");
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->text(), "vase.stl is a mesh.");
  box->findChild<QPushButton*>("scanMesh")->click();
  Desk::settle();
  EXPECT_EQ(desk.window().findChild<QComboBox*>("object")->currentData().toString(), folder_.filePath("vase.stl"));
  desk.controller().open(paths_[0]);
  desk.window().wizard().goTo(QStringLiteral("review"));
  drop(desk, {folder_.filePath("vase.stl")});
  EXPECT_TRUE(saidByABox(desk).startsWith("vase.stl is a mesh. ")) << saidByABox(desk).toStdString();
}

TEST_F(WindowDoor, WhatCannotBeTakenIsNamedWithWhatCan) {
  Desk desk({1280, 800}, false);
  drop(desk, {paths_[0], folder_.filePath("vase.stl")});
  EXPECT_EQ(saidByABox(desk).toStdString(),
            "session.vantage is a session, vase.stl is a mesh: drop one kind at a time.");
  EXPECT_EQ(desk.window().findChild<QMessageBox*>("dropRefused")->informativeText().toStdString(),
            "A session or its folder, scans, or one mesh can be dropped here.");
  EXPECT_FALSE(desk.controller().hasSession());
}

TEST_F(WindowDoor, ScansThatAreDroppedAreImported) {
  Desk desk({1280, 800}, false);
  QFile cloud(folder_.filePath("cloud.xyz"));
  ASSERT_TRUE(cloud.open(QIODevice::WriteOnly));
  cloud.write("1 2 3\n4 5 6\n");
  cloud.close();
  drop(desk, {cloud.fileName()});
  auto* dialog = desk.window().findChild<ImportDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
}

}  // namespace
}  // namespace vantage
