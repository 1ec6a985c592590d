#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "calibration/table_calibrator.h"
#include "rig_keeper.h"
#include "undertaking.h"

namespace vantage {

/// Calibrates the turntable of a set-up with its scanner. Lives on the UI thread; every call returns at once.
class TableCalibrating final : public QObject {
  Q_OBJECT

 public:
  TableCalibrating(Undertaking& work, std::shared_ptr<RigKeeper> devices, QObject* parent = nullptr);

  /// The set-up whose table it is; another table or scanner forgets what was found.
  void setSetUp(const SharedSetUp& setUp);

  /// Why the table of the set-up cannot be calibrated, as a sentence; empty when it can.
  [[nodiscard]] QString whyNot() const;
  /// Turns the table so often and scans, then finds where it stands and how it turns.
  /// @param scans 3 to 12
  void calibrate(int scans);
  /// What was found last; nothing before.
  [[nodiscard]] const std::optional<CalibrationResult>& result() const { return result_; }
  /// Why nothing was found the last time; empty when something was.
  [[nodiscard]] const QString& failure() const { return failure_; }
  /// Whether what was found can be used at all.
  [[nodiscard]] bool usable() const;

  /// Writes what was found to a new file in a folder, which is made when it is not there.
  void keep(const QString& folder);

 signals:
  void changed();
  void kept(const QString& path);

 private:
  Undertaking& work_;
  std::shared_ptr<RigKeeper> devices_;
  SharedSetUp setUp_;
  std::optional<CalibrationResult> result_;
  QString failure_;
};

}  // namespace vantage
