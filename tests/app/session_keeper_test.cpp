#include "session_keeper.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

class SessionKeeperTest : public ::testing::Test {
 protected:
  SessionKeeperTest() {
    QObject::connect(&keeper_, &SessionKeeper::arrived,
                     [this](const OpenedSession& opened, const Present& present, const QString& page, bool imported) {
                       opened_ = opened;
                       scans_ = present.state()->scans.size();
                       page_ = page;
                       imported_ = imported;
                     });
  }
  [[nodiscard]] QString path() const { return folder_.filePath("recorded.vantage"); }

  QTemporaryDir folder_;
  SynchronousJobRunner jobs_;
  Undertaking work_{jobs_};
  SessionKeeper keeper_{work_, jobs_, ""};
  OpenedSession opened_;
  std::size_t scans_ = 0;
  QString page_;
  bool imported_ = false;
};

TEST_F(SessionKeeperTest, WhatArrivesIsKeptOnceItIsAdopted) {
  static_cast<void>(testing::importSmallScans(path().toStdString()));
  keeper_.open(path(), SessionAccess::Write);
  ASSERT_TRUE(opened_.session);
  EXPECT_GT(scans_, 1U);
  EXPECT_EQ(page_, "review") << "where the state of a session leads that no window has had";
  EXPECT_FALSE(imported_);
  EXPECT_EQ(keeper_.session(), nullptr);
  EXPECT_EQ(keeper_.path(), "");
  keeper_.adopt(opened_.session, opened_.access, page_);
  EXPECT_EQ(keeper_.session(), opened_.session);
  EXPECT_EQ(keeper_.path(), path());
  EXPECT_EQ(keeper_.page(), "review");
  keeper_.letGo();
  EXPECT_EQ(keeper_.session(), nullptr);
  EXPECT_EQ(keeper_.page(), "");
}

TEST_F(SessionKeeperTest, ASessionKeepsItsPage) {
  static_cast<void>(testing::importSmallScans(path().toStdString()));
  keeper_.open(path(), SessionAccess::Write);
  keeper_.adopt(opened_.session, opened_.access, page_);
  keeper_.rememberPage("finish");
  keeper_.letGo();
  opened_ = {};
  keeper_.open(path(), SessionAccess::Write);
  EXPECT_EQ(page_, "finish");
}

TEST_F(SessionKeeperTest, WhatCannotBeImportedIsToldAndNothingArrives) {
  const QSignalSpy failed(&keeper_, &SessionKeeper::importFailed);
  ImportChoice choice;
  choice.folder = folder_.path().toStdString();
  choice.recorded.files = {folder_.filePath("none.ply").toStdString()};
  keeper_.importScans(choice);
  EXPECT_EQ(failed.count(), 1);
  EXPECT_FALSE(opened_.session);
}

}  // namespace
}  // namespace vantage
