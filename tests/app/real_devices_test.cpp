// The whole job in the window with devices: those of a laboratory that is no part of the project. Needs a display.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QScrollArea>
#include <QTemporaryDir>

#include "app/devices/laboratory.h"
#include "app/operator.h"
#include "geometry/measures.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using testing::Operator;
using testing::waitFor;
using testing::Watchdog;

constexpr int kLongestBlock = 100;   // [ms], see wizard_test.cpp
constexpr int kLongestCancel = 500;  // [ms]

class RealDevices : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto laboratory = testing::laboratoryFolder();
    if (!laboratory || !fs::exists(*laboratory / "lab_vendor"))
      GTEST_SKIP() << "no laboratory: set VANTAGE_LAB to its build folder";
    laboratory_ = QString::fromStdString(laboratory->string());
    QDir(folder_.path()).mkdir("scans");
    ASSERT_NO_FATAL_FAILURE(startTable());
    vendor_.start(laboratory_ + "/lab_vendor",
                  {"--mesh", resource("objects/mug.ply"), "--profile", resource("scanners/rotating_stripe.json"),
                   "--state", path("state.json"), "--out", path("scans"), "--binary"});
    ASSERT_TRUE(vendor_.waitForStarted());
  }
  void TearDown() override {
    for (QProcess* process : {&vendor_, &table_}) {
      process->kill();
      process->waitForFinished();
    }
  }
  void startTable() {
    table_.start(laboratory_ + "/lab_table",
                 {"--protocol", "grbl", "--link", path("table"), "--state", path("state.json")});
    ASSERT_TRUE(table_.waitForStarted());
    ASSERT_TRUE(waitFor([&] { return QFile::exists(path("table")); }));
  }
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
  static QString resource(const QString& name) { return QStringLiteral(VANTAGE_RESOURCES) + "/" + name; }

  // Chooses the folder and the table.
  void choose(Operator& me) const {
    auto* sensor = me.window().findChild<QComboBox*>("sensor");
    sensor->setCurrentIndex(sensor->findText("Files in a folder"));
    me.window().findChild<QLineEdit*>("sensorPath")->setText(path("scans"));
    me.window().findChild<QComboBox*>("port")->setEditText(path("table"));
    me.window().findChild<QLineEdit*>("folder")->setText(path("session"));
  }
  // For who looks at it: into the folder that VANTAGE_SCREENSHOTS names.
  // @param below scrolled to
  void keepPicture(Operator& me, const QString& name, const char* below = nullptr) const {
    const QString folder = qEnvironmentVariable("VANTAGE_SCREENSHOTS");
    if (folder.isEmpty()) return;
    QTest::qWait(300);
    QDir().mkpath(folder);
    if (below != nullptr)
      for (auto* area : me.window().findChildren<QScrollArea*>())
        if (auto* widget = area->findChild<QWidget*>(below)) area->ensureWidgetVisible(widget);
    me.window().grab().save(folder + "/" + name + ".png");
  }
  static QString text(Operator& me, const char* name) { return me.window().findChild<QLabel*>(name)->text(); }

  QString laboratory_;
  QTemporaryDir folder_;
  QProcess table_;
  QProcess vendor_;
};

TEST_F(RealDevices, AreTriedCalibratedAndScanTheMugByThemselves) {
  Operator me(path("unused"), 4);
  choose(me);
  keepPicture(me, "1_choose");
  Watchdog watchdog;
  me.click("next");
  ASSERT_TRUE(me.waitForPage("check"));
  ASSERT_TRUE(waitFor([&] { return me.controller().bench().connected(); }))
      << me.controller().bench().failure().toStdString();
  ASSERT_TRUE(me.waitUntilIdle());
  EXPECT_TRUE(me.controller().bench().states()[1].ready) << me.controller().bench().states()[1].state.toStdString();
  me.click("jog30");
  ASSERT_TRUE(me.waitUntilIdle());
  EXPECT_TRUE(me.controller().bench().states()[1].state.contains("30.0"))
      << me.controller().bench().states()[1].state.toStdString();
  keepPicture(me, "2_check");
  me.click("testScan");
  ASSERT_TRUE(me.waitUntilIdle());
  ASSERT_TRUE(me.controller().testScans().scanResult());
  const CutCounts& counts = me.controller().testScans().scanResult()->counts;
  EXPECT_GT(counts[static_cast<std::size_t>(CutReason::Kept)], 1000U);
  EXPECT_GT(cutSamples(counts), 0U);
  keepPicture(me, "2_test_scan", "cut.smallest_island");
  me.click("next");
  ASSERT_TRUE(me.waitForPage("calibrate"));
  me.click("calibrateTable");
  ASSERT_TRUE(me.waitUntilIdle());
  ASSERT_TRUE(me.controller().calibrating().usable()) << text(me, "calibrationVerdict").toStdString();
  keepPicture(me, "3_calibrate");
  me.click("useCalibration");
  ASSERT_TRUE(waitFor([&] { return me.controller().idle() && me.controller().setUp(); }));
  EXPECT_TRUE(me.controller().setUp()->profile->calibration);
  me.click("next");
  ASSERT_TRUE(me.waitForPage("acquire"));
  me.click("run");
  ASSERT_TRUE(waitFor([&] { return me.controller().now() != nullptr; }));
  keepPicture(me, "4_acquire");
  ASSERT_TRUE(me.waitForPage("review"));
  keepPicture(me, "5_review");
  const AcquisitionState& now = *me.controller().now();
  EXPECT_EQ(countScans(now, ScanStatus::In), 4U);
  // Where its handle is out of sight, nothing of the mug says how far it is turned.
  for (const KeptScan& scan : now.scans) EXPECT_LT(scan.record.registration.rms, 0.15) << scan.number;
  RecordProperty("longest_block_ms", static_cast<int>(watchdog.longest()));
  EXPECT_LE(watchdog.longest(), kLongestBlock);
}

TEST_F(RealDevices, ATableThatIsUnpluggedPausesTheRunAndItGoesOnWhenItIsBack) {
  Operator me(path("unused"), 3);
  choose(me);
  me.click("next");
  ASSERT_TRUE(waitFor([&] { return me.controller().bench().connected() && me.controller().idle(); }));
  me.click("next");
  me.click("next");
  ASSERT_TRUE(me.waitForPage("acquire"));
  me.click("run");
  ASSERT_TRUE(waitFor([&] { return me.controller().now() && !me.controller().now()->scans.empty(); }));
  table_.kill();
  ASSERT_TRUE(me.waitUntilIdle());
  EXPECT_FALSE(me.controller().scanFailure().isEmpty());
  const std::size_t before = me.controller().now()->scans.size();
  keepPicture(me, "6_unplugged");
  table_.waitForFinished();
  QFile::remove(path("table"));
  startTable();
  me.click("again");
  ASSERT_TRUE(me.waitForPage("review"));
  EXPECT_GT(me.controller().now()->scans.size(), before);
  EXPECT_EQ(countScans(*me.controller().now(), ScanStatus::In), 3U);
}

TEST_F(RealDevices, EveryWaitIsStoppedAtOnce) {
  Operator me(path("unused"), 8);
  choose(me);
  me.click("next");
  ASSERT_TRUE(waitFor([&] { return me.controller().bench().connected() && me.controller().idle(); }));
  me.click("next");
  me.click("next");
  ASSERT_TRUE(me.waitForPage("acquire"));
  for (const int moment : {150, 700, 1500, 2500, 4000}) {
    me.controller().run();
    QTest::qWait(moment);
    const testing::Stopwatch watch;
    me.controller().stop();
    ASSERT_TRUE(me.waitUntilIdle());
    EXPECT_LE(watch.milliseconds(), kLongestCancel) << "stopped after " << moment << " ms";
  }
}

}  // namespace
}  // namespace vantage
