#include "bench/test_scans.h"

#include <algorithm>

#include "base/errors.h"
#include "bench/cut_picture.h"

namespace vantage {
namespace {

TestScan cutScan(const std::shared_ptr<const RangeImage>& image, const SetUp& setUp, const Progress& progress) {
  TestScan scan{image, setUp.choice.settings.cut, {}, {}};
  const std::vector<CutReason> reasons = cutOf(*image, {cutSceneOf(*setUp.profile), scan.cut}, progress);
  scan.counts = countsOf(reasons);
  scan.picture = cutPicture(*image, reasons);
  return scan;
}

const Mesh* objectOf(const SetUp& setUp) {
  return setUp.object ? setUp.object->mesh.get() : nullptr;
}

// Devices that failed are opened anew the next time.
template <typename T>
T withRig(const SharedSetUp& setUp, RigKeeper& devices, const Progress& progress,
          const std::function<T(const Rig&, const Progress&)>& work) {
  RigKeeper::Use use = devices.open(setUp, 0, {}, progress.part(0.0, 0.1));
  try {
    return work(use.rig(), progress.part(0.1, 1.0));
  } catch (const DeviceError&) {
    use.drop();
    throw;
  }
}

}  // namespace

TestScans::TestScans(Undertaking& work, JobRunner& jobs, std::shared_ptr<RigKeeper> devices, QObject* parent)
    : QObject(parent), work_(work), jobs_(jobs), devices_(std::move(devices)) {}

void TestScans::setSetUp(const SharedSetUp& setUp) {
  const bool sameScanner = setUp && setUp_ && setUp->profile == setUp_->profile &&
                           objectOf(*setUp) == objectOf(*setUp_) && setUp->choice.rig == setUp_->choice.rig;
  setUp_ = setUp;
  if (sameScanner) return cutAnew();
  turn_.reset();
  scan_.reset();
  emit turnChanged();
  emit scanChanged();
}

void TestScans::turn() {
  if (!setUp_ || !setUp_->devices) return;
  const int first = setUp_->choice.settings.firstView;
  const auto positions = static_cast<int>(setUp_->profile->workspace.size());
  // Far enough to measure, near enough to overlap.
  const int second = (first + std::max(1, setUp_->profile->workspace.steps / 12)) % std::max(1, positions);
  work_.begin<TestTurn>(
      Activity::Testing, tr("Test turn"),
      [setUp = setUp_, devices = devices_, first, second](const Progress& p) {
        return withRig<TestTurn>(setUp, *devices, p, [&](const Rig& rig, const Progress& inner) {
          return testTurn(rig, *setUp->profile, first, second, setUp->choice.settings.cut, inner);
        });
      },
      [this](TestTurn result) {
        turn_ = std::move(result);
        emit turnChanged();
      });
}

void TestScans::scan() {
  if (!setUp_ || !setUp_->devices) return;
  work_.begin<TestScan>(
      Activity::Testing, tr("Test scan"),
      [setUp = setUp_, devices = devices_](const Progress& p) {
        const auto image = withRig<std::shared_ptr<const RangeImage>>(
            setUp, *devices, p.part(0.0, 0.9), [&](const Rig& rig, const Progress& inner) {
              return std::make_shared<const RangeImage>(scanFrom(rig, setUp->choice.settings.firstView, inner));
            });
        return cutScan(image, *setUp, p.part(0.9, 1.0));
      },
      [this](TestScan result) {
        scan_ = std::move(result);
        emit scanChanged();
        cutAnew();
      });
}

// What is cut of the last scan, as it is chosen now; of several changes only the last is waited for.
void TestScans::cutAnew() {
  if (!scan_ || cutting_ || scan_->cut == setUp_->choice.settings.cut) return;
  cutting_ = true;
  jobs_.run<TestScan>(
      {}, [image = scan_->image, setUp = setUp_](const Progress& p) { return cutScan(image, *setUp, p); },
      [this](JobResult<TestScan> result) {
        cutting_ = false;
        if (!result.value || !scan_ || scan_->image != result.value->image) return;
        scan_ = std::move(*result.value);
        emit scanChanged();
        cutAnew();
      });
}

}  // namespace vantage
