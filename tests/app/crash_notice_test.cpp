#include "crash_notice.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace vantage {
namespace {

class CrashNoticeTest : public ::testing::Test {
 protected:
  [[nodiscard]] QString session() const { return folder_.filePath("mug.vantage"); }
  void SetUp() override {
    QFile file(session());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  }
  [[nodiscard]] CrashTrace crash(const QString& session) const {
    return {"/state/crashes/vantage-1.new", session.toStdString(), "signal: SIGSEGV\nstack:\n"};
  }

  QTemporaryDir folder_;
};

TEST_F(CrashNoticeTest, OffersTheTraceAndTheSession) {
  auto* notice = new CrashNotice(crash(session()));
  EXPECT_TRUE(notice->informativeText().contains("vantage-1.txt"));
  EXPECT_TRUE(notice->informativeText().contains(session()));
  const QSignalSpy wanted(notice, &CrashNotice::sessionWanted);
  notice->open();
  notice->findChild<QPushButton*>("copyTrace")->click();
  EXPECT_EQ(QGuiApplication::clipboard()->text(), "signal: SIGSEGV\nstack:\n");
  EXPECT_TRUE(notice->isVisible()) << "copying leaves the notice where it is";
  EXPECT_EQ(wanted.count(), 0);
  notice->findChild<QPushButton*>("openSession")->click();
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted.front().front().toString(), session());
}

TEST_F(CrashNoticeTest, OffersNoSessionThatIsNotThere) {
  for (const QString& path : {QString(), folder_.filePath("gone.vantage")}) {
    CrashNotice notice(crash(path));
    EXPECT_EQ(notice.findChild<QPushButton*>("openSession"), nullptr);
    EXPECT_FALSE(notice.informativeText().contains("was open"));
    notice.setAttribute(Qt::WA_DeleteOnClose, false);
  }
}

}  // namespace
}  // namespace vantage
