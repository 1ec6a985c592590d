// The devices of a set-up before the first scan.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/told_devices.h"
#include "bench/cut_picture.h"
#include "bench/device_bench.h"
#include "bench/table_calibrating.h"
#include "bench/test_scans.h"
#include "scanner/calibration_file.h"

namespace vantage {
namespace {

class Bench : public ::testing::Test {
 protected:
  Bench() {
    QObject::connect(&work_, &Undertaking::failed, [this](const QString& what) { failure_ = what; });
    use(testing::realSetUp());
  }
  void use(const SharedSetUp& setUp) {
    setUp_ = setUp;
    bench_.setSetUp(setUp);
    scans_.setSetUp(setUp);
    calibrating_.setSetUp(setUp);
  }
  void cut(const CutOptions& cut) {
    auto setUp = std::make_shared<vantage::SetUp>(*setUp_);
    setUp->choice.settings.cut = cut;
    use(setUp);
  }
  [[nodiscard]] std::size_t count(CutReason reason) const {
    return scans_.scanResult()->counts[static_cast<std::size_t>(reason)];
  }

  testing::ToldDevices devices_;
  SynchronousJobRunner jobs_;
  Undertaking work_{jobs_};
  std::shared_ptr<RigKeeper> keeper_ = std::make_shared<RigKeeper>(devices_.factory());
  DeviceBench bench_{work_, jobs_, keeper_};
  TestScans scans_{work_, jobs_, keeper_};
  TableCalibrating calibrating_{work_, keeper_};
  SharedSetUp setUp_;
  QString failure_;
};

TEST_F(Bench, TellsHowEachDeviceIs) {
  EXPECT_TRUE(bench_.real());
  EXPECT_TRUE(bench_.hasTable());
  EXPECT_FALSE(bench_.connected());
  bench_.connectDevices();
  ASSERT_EQ(bench_.states().size(), 2U);
  EXPECT_EQ(bench_.states()[0].identity, "scanner of a test");
  EXPECT_TRUE(bench_.states()[0].ready);
  EXPECT_EQ(bench_.states()[1].state, "At rest at 0.00°, as it reports.");
}

TEST_F(Bench, TurnsTheTableAndSetsItsReference) {
  bench_.jog(30.0);
  bench_.jog(-5.0);
  EXPECT_NEAR(devices_.table->counted, 25.0, 1e-9);
  EXPECT_EQ(bench_.states()[1].state, "At rest at 25.00°, as it reports.");
  bench_.home();
  EXPECT_EQ(devices_.table->homed, 1);
  EXPECT_EQ(bench_.states()[1].state, "At rest at 0.00°, as it reports.");
}

TEST_F(Bench, SaysWhatWentWrongAndHowTheDevicesAreThen) {
  bench_.connectDevices();
  devices_.table->vanished = true;
  bench_.look();
  EXPECT_FALSE(bench_.states()[1].ready);
  EXPECT_EQ(bench_.states()[1].state, "was unplugged");
  devices_.table->vanished = false;
  bench_.jog(10.0);
  EXPECT_TRUE(bench_.failure().isEmpty()) << "connected anew";
  EXPECT_EQ(devices_.table->opened, 2);
}

TEST_F(Bench, DevicesThatFailedInATestScanAreNotCalledReady) {
  bench_.connectDevices();
  devices_.table->failsNext = "was unplugged";
  scans_.scan();
  EXPECT_TRUE(failure_.contains("was unplugged"));
  bench_.look();
  EXPECT_FALSE(bench_.connected());
  EXPECT_TRUE(bench_.failure().contains("Connect them again"));
}

TEST_F(Bench, ForgetsTheDevicesOfAnotherSetUp) {
  bench_.connectDevices();
  cut(cutForRealScanners());
  EXPECT_TRUE(bench_.connected());
  auto other = testing::realSetUp();
  other->choice.rig.table = HandTableDevice{};
  use(other);
  EXPECT_FALSE(bench_.connected());
  EXPECT_FALSE(bench_.hasTable());
}

TEST_F(Bench, ATestScanShowsWhatIsCutAndIsCutAnew) {
  scans_.scan();
  ASSERT_TRUE(scans_.scanResult()) << failure_.toStdString();
  const std::size_t all = count(CutReason::Kept);
  EXPECT_GT(all, 300U);
  const QImage before = scans_.scanResult()->picture;
  EXPECT_FALSE(before.isNull());
  CutOptions high;
  high.volume = true;
  high.tableMargin = 40.0;
  cut(high);
  EXPECT_LT(count(CutReason::Kept), all);
  EXPECT_EQ(count(CutReason::Kept) + count(CutReason::Table), all);
  EXPECT_NE(scans_.scanResult()->picture, before);
  cut({});
  EXPECT_EQ(count(CutReason::Kept), all);
  EXPECT_EQ(scans_.scanResult()->picture, before);
}

TEST_F(Bench, ATestTurnComparesTheTableWithTheProfile) {
  scans_.turn();
  ASSERT_TRUE(scans_.turnResult()) << failure_.toStdString();
  EXPECT_NEAR(std::abs(scans_.turnResult()->measured), radians(30.0), radians(1.0));
}

TEST_F(Bench, CalibratesTheTableAndKeepsWhatWasFoundInANewFile) {
  const QTemporaryDir folder;
  QFile old(folder.filePath("calibration.json"));
  ASSERT_TRUE(old.open(QIODevice::WriteOnly));
  old.write("mine");
  old.close();
  calibrating_.keep(folder.path());
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
  calibrating_.calibrate(5);
  ASSERT_TRUE(calibrating_.result()) << calibrating_.failure().toStdString();
  ASSERT_TRUE(calibrating_.usable());
  EXPECT_EQ(calibrating_.result()->calibration.sense, 1);
  EXPECT_NEAR(calibrating_.result()->calibration.degreesPerCommandedDegree, 1.0, 0.01);
  QSignalSpy kept(&calibrating_, &TableCalibrating::kept);
  calibrating_.keep(folder.path());
  ASSERT_EQ(kept.count(), 1) << failure_.toStdString();
  const QString path = kept[0][0].toString();
  EXPECT_EQ(path, folder.filePath("calibration-2.json"));
  EXPECT_EQ(loadCalibration(path.toStdString()).sense, 1);
  ASSERT_TRUE(old.open(QIODevice::ReadOnly));
  EXPECT_EQ(old.readAll(), "mine");
}

TEST_F(Bench, SaysWhyATableCannotBeCalibrated) {
  auto byHand = testing::realSetUp();
  byHand->choice.rig.table = HandTableDevice{};
  use(byHand);
  EXPECT_TRUE(calibrating_.whyNot().contains("turns by itself"));
  use({});
  EXPECT_FALSE(calibrating_.whyNot().isEmpty());
}

TEST(CutPicture, ShowsEveryReasonInItsColourAndIsNoLargerThanAsked) {
  const auto profile = testing::smallProfile();
  RangeImage image = scanFrom(testing::simulation(testing::smallObject(), profile, {}), 0, {});
  std::vector<CutReason> reasons(image.range.size());
  std::size_t flying = 0;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    reasons[i] = image.valid(i) ? (i % 2 == 0 ? CutReason::Kept : CutReason::Flying) : CutReason::NoSample;
    flying += reasons[i] == CutReason::Flying ? 1U : 0U;
  }
  const auto pixels = [&](const QImage& picture, QRgb colour) {
    std::size_t count = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == colour ? 1U : 0U;
    return count;
  };
  const QImage whole = cutPicture(image, reasons);
  EXPECT_EQ(pixels(whole, colourOf(CutReason::Flying).rgb()), flying);
  const QImage small = cutPicture(image, reasons, 10);
  EXPECT_LE(std::max(small.width(), small.height()), 10);
  EXPECT_GT(std::min(small.width(), small.height()), 1);
}

}  // namespace
}  // namespace vantage
