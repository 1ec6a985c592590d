#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "acquisition/test_turn.h"
#include "rig_keeper.h"
#include "undertaking.h"

namespace vantage {

/// A scan that is only looked at, and what is cut of it.
struct TestScan {
  std::shared_ptr<const RangeImage> image;
  CutOptions cut;
  CutCounts counts{};
  QImage picture;  ///< see cutPicture
};

/// Scans that tell whether a set-up is right; none is kept. Lives on the UI thread; every call returns at once.
class TestScans final : public QObject {
  Q_OBJECT

 public:
  TestScans(Undertaking& work, JobRunner& jobs, std::shared_ptr<RigKeeper> devices, QObject* parent = nullptr);

  /// The set-up that scans. One that differs by what is cut shows the last scan cut that way; any other forgets all.
  void setSetUp(const SharedSetUp& setUp);

  /// Scans from the first position and from one that is a twelfth of a turn on, and compares the turn with the profile.
  void turn();
  [[nodiscard]] const std::optional<TestTurn>& turnResult() const { return turn_; }

  /// Scans from the first position.
  void scan();
  [[nodiscard]] const std::optional<TestScan>& scanResult() const { return scan_; }

 signals:
  void turnChanged();
  void scanChanged();

 private:
  void cutAnew();

  Undertaking& work_;
  JobRunner& jobs_;
  std::shared_ptr<RigKeeper> devices_;
  SharedSetUp setUp_;
  std::optional<TestTurn> turn_;
  std::optional<TestScan> scan_;
  bool cutting_ = false;
};

}  // namespace vantage
