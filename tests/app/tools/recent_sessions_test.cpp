#include "recent/recent_sessions.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "recent/recent_list.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

class RecentSessionsTest : public ::testing::Test {
 protected:
  RecentSessionsTest() { QSettings().remove("recentSessions"); }
  ~RecentSessionsTest() override { QSettings().remove("recentSessions"); }

  QString make(const QString& name) {
    QDir(folder_.path()).mkpath(name);
    const QString path = folder_.filePath(name + "/session.vantage");
    static_cast<void>(testing::importSmallScans(path.toStdString()));
    return path;
  }
  [[nodiscard]] std::string cache() const { return folder_.filePath("cache").toStdString(); }
  [[nodiscard]] QStringList kept() const { return QDir(folder_.filePath("cache/recent")).entryList(QDir::Files); }
  [[nodiscard]] QStringList names() const {
    QStringList names;
    for (const RecentSession& session : recent_.sessions()) names << sessionName(session.path);
    return names;
  }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  SessionController controller_{jobs_, ""};
  RecentSessions recent_{controller_, jobs_, cache()};
};

TEST_F(RecentSessionsTest, TheLastOneIsTheFirst) {
  const QString mug = make("mug");
  const QString lamp = make("lamp");
  EXPECT_TRUE(recent_.sessions().isEmpty());
  controller_.open(mug);
  controller_.open(lamp);
  EXPECT_EQ(names(), (QStringList{"lamp", "mug"}));
  controller_.open(mug);
  EXPECT_EQ(names(), (QStringList{"mug", "lamp"}));
  EXPECT_EQ(recentText(recent_.sessions()[0]), "open now");
  controller_.close();
  // The next window has the same list.
  const RecentSessions again(controller_, jobs_, cache());
  ASSERT_EQ(again.sessions().size(), 2);
  EXPECT_EQ(again.sessions()[0].path, mug);
}

TEST_F(RecentSessionsTest, AreReadWithPictureAndState) {
  const QString mug = make("mug");
  controller_.open(mug);
  controller_.close();
  const RecentSession& session = recent_.sessions()[0];
  ASSERT_TRUE(session.digest) << session.unreadable.toStdString();
  EXPECT_EQ(session.digest->scans, 3);
  EXPECT_EQ(session.digest->termination, Termination::Imported);
  EXPECT_EQ(session.digest->changed, changeOf(mug));
  ASSERT_FALSE(session.digest->picture.isNull());
  // The surface stands before the background.
  const QImage& picture = session.digest->picture;
  EXPECT_NE(picture.pixel(picture.width() / 2, picture.height() / 2), picture.pixel(2, picture.height() / 2));
  const QString when = QLocale().toString(changeOf(mug), QLocale::ShortFormat);
  EXPECT_EQ(recentText(session), "imported, 3 scans\nchanged " + when);
}

TEST_F(RecentSessionsTest, WhatWasReadIsKeptUntilTheSessionChanges) {
  const QString mug = make("mug");
  const SessionDigest first = digestOf(mug, cache());
  ASSERT_EQ(kept().size(), 1);
  // What is kept is what is found: it is told by a mark.
  const QString file = folder_.filePath("cache/recent/" + kept().front());
  QImage marked(file);
  marked.setText("scans", "77");
  ASSERT_TRUE(marked.save(file));
  EXPECT_EQ(digestOf(mug, cache()).scans, 77);
  EXPECT_EQ(digestOf(mug, "").scans, 3) << "nothing is kept without a folder";
  {
    QFile session(mug);
    ASSERT_TRUE(session.open(QIODevice::ReadWrite));
    ASSERT_TRUE(session.setFileTime(first.changed.addSecs(60), QFileDevice::FileModificationTime));
  }
  const SessionDigest after = digestOf(mug, cache());
  EXPECT_EQ(after.scans, 3);
  EXPECT_EQ(after.changed, first.changed.addSecs(60));
}

TEST_F(RecentSessionsTest, ReadingLeavesTheSessionAsItIs) {
  const QString mug = make("mug");
  const auto bytes = [&] {
    QFile file(mug);
    static_cast<void>(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  const QByteArray before = bytes();
  static_cast<void>(digestOf(mug, cache()));
  EXPECT_EQ(bytes(), before);
  EXPECT_EQ(QDir(folder_.filePath("mug")).entryList(QDir::Files).filter("session.vantage").front(), "session.vantage");
}

TEST_F(RecentSessionsTest, OneThatIsGoneIsShownAsGoneAndCanBeTakenOff) {
  const QString mug = make("mug");
  const QString lamp = make("lamp");
  controller_.open(mug);
  controller_.open(lamp);
  controller_.close();
  ASSERT_TRUE(QFile::rename(mug, mug + ".moved"));
  recent_.refresh();
  EXPECT_FALSE(recent_.sessions()[0].gone);
  EXPECT_TRUE(recent_.sessions()[1].gone);
  EXPECT_EQ(recentText(recent_.sessions()[1]), "gone: no such file");
  recent_.remove(mug);
  EXPECT_EQ(names(), QStringList{"lamp"});
  recent_.remove(lamp);
  EXPECT_TRUE(recent_.sessions().isEmpty());
  EXPECT_TRUE(QFileInfo::exists(lamp)) << "only the list forgets";
  EXPECT_TRUE(kept().isEmpty()) << "and what was kept of it";
}

TEST_F(RecentSessionsTest, OneThatCannotBeReadSaysWhy) {
  const QString broken = folder_.filePath("broken.vantage");
  QFile file(broken);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no session");
  file.close();
  QSettings().setValue("recentSessions", QStringList{broken});
  recent_.refresh();
  EXPECT_EQ(recentText(recent_.sessions()[0]), "cannot be read");
  EXPECT_TRUE(recent_.sessions()[0].unreadable.contains("broken.vantage"));
}

TEST_F(RecentSessionsTest, TheOldestOfTooManyLeavesTheList) {
  const QString mug = make("mug");
  QStringList many;
  for (int i = 0; i < RecentSessions::kMost; ++i) many << folder_.filePath(QStringLiteral("s%1.vantage").arg(i));
  QSettings().setValue("recentSessions", many);
  controller_.open(mug);
  ASSERT_EQ(recent_.sessions().size(), RecentSessions::kMost);
  EXPECT_EQ(recent_.sessions().back().path, many[RecentSessions::kMost - 2]);
}

TEST(RecentTexts, SayHowFarASessionIs) {
  const auto text = [](Termination termination, int scans) {
    SessionDigest digest;
    digest.termination = termination;
    digest.scans = scans;
    return progressText(digest).toStdString();
  };
  EXPECT_EQ(text(Termination::Running, 0), "no scan yet");
  EXPECT_EQ(text(Termination::Running, 1), "not ended, 1 scan");
  EXPECT_EQ(text(Termination::Finished, 8), "finished, 8 scans");
  EXPECT_EQ(text(Termination::EndedByOperator, 8), "ended by you, 8 scans");
  EXPECT_EQ(text(Termination::MaxViews, 40), "ended before all was seen, 40 scans");
  EXPECT_EQ(sessionName("/data/mug/session.vantage"), "mug");
  EXPECT_EQ(sessionName("/data/mug/session-2.vantage"), "mug/session-2");
}

class RecentListTest : public RecentSessionsTest {
 protected:
  RecentListTest() : mug_(make("mug")), lamp_(make("lamp")) {
    controller_.open(mug_);
    controller_.open(lamp_);
    controller_.close();
    list_ = std::make_unique<RecentList>(recent_, controller_);
    list_->show();
    rows_ = list_->findChild<QListWidget*>("recentSessions");
  }

  QString mug_;
  QString lamp_;
  std::unique_ptr<RecentList> list_;
  QListWidget* rows_ = nullptr;
};

TEST_F(RecentListTest, AClickOrEnterOpensOne) {
  const QSignalSpy chosen(list_.get(), &RecentList::chosen);
  ASSERT_EQ(rows_->count(), 2);
  EXPECT_FALSE(rows_->item(0)->icon().isNull());
  QTest::mouseClick(rows_->viewport(), Qt::LeftButton, {}, rows_->visualItemRect(rows_->item(1)).center());
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0], mug_);
  rows_->setCurrentRow(0);
  QTest::keyClick(rows_, Qt::Key_Return);
  ASSERT_EQ(chosen.size(), 2);
  EXPECT_EQ(chosen[1][0], lamp_);
}

TEST_F(RecentListTest, DeleteTakesOneOffTheListAndNotFromTheDisk) {
  rows_->setCurrentRow(0);
  QTest::keyClick(rows_, Qt::Key_Delete);
  ASSERT_EQ(rows_->count(), 1);
  EXPECT_TRUE(rows_->item(0)->text().startsWith("mug\n"));
  EXPECT_TRUE(QFileInfo::exists(lamp_));
  QTest::keyClick(rows_, Qt::Key_Delete);
  EXPECT_TRUE(list_->isHidden());
}

TEST_F(RecentListTest, OneThatIsGoneIsOfferedToBeForgotten) {
  const QSignalSpy chosen(list_.get(), &RecentList::chosen);
  ASSERT_TRUE(QFile::remove(lamp_));
  recent_.refresh();
  rows_->setCurrentRow(0);
  QTest::keyClick(rows_, Qt::Key_Return);
  EXPECT_TRUE(chosen.isEmpty());
  auto* box = list_->findChild<QMessageBox*>("sessionGone");
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->text(), "lamp is gone.");
  box->findChild<QPushButton*>("forgetSession")->click();
  EXPECT_EQ(rows_->count(), 1);
}

TEST_F(RecentListTest, IsNotThereWhileASessionIsOpen) {
  EXPECT_FALSE(list_->isHidden());
  controller_.open(mug_);
  EXPECT_TRUE(list_->isHidden());
  controller_.close();
  EXPECT_FALSE(list_->isHidden());
}

TEST_F(RecentListTest, TheMenuHasTheSame) {
  QMenu menu;
  QString chosen;
  fillRecentMenu(menu, recent_, [&](const QString& path) { chosen = path; });
  ASSERT_EQ(menu.actions().size(), 2);
  EXPECT_TRUE(menu.actions()[0]->text().startsWith("&1  lamp: imported, 3 scans, changed "));
  menu.actions()[1]->trigger();
  EXPECT_EQ(chosen, mug_);
  controller_.open(mug_);
  fillRecentMenu(menu, recent_, {});
  EXPECT_FALSE(menu.actions()[0]->isEnabled()) << "it is open already";
  recent_.remove(mug_);
  recent_.remove(lamp_);
  fillRecentMenu(menu, recent_, {});
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_FALSE(menu.actions()[0]->isEnabled());
}

}  // namespace
}  // namespace vantage
