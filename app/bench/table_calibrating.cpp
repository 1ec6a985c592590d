#include "bench/table_calibrating.h"

#include <filesystem>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "calibration/calibration_scans.h"
#include "devices/real_rig.h"
#include "scanner/calibration_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// Under the first name that nothing has yet: "calibration.json", "calibration-2.json", ...
std::string writeNew(const fs::path& folder, const std::string& text) {
  for (int i = 1;; ++i) {
    const fs::path path =
        folder / (i == 1 ? std::string("calibration.json") : std::string("calibration-") + std::to_string(i) + ".json");
    if (fs::exists(fs::symlink_status(path))) continue;
    AtomicFile file(path.string());
    file.write(text);
    if (file.commitNew()) return path.string();
  }
}

}  // namespace

TableCalibrating::TableCalibrating(Undertaking& work, std::shared_ptr<RigKeeper> devices, QObject* parent)
    : QObject(parent), work_(work), devices_(std::move(devices)) {}

void TableCalibrating::setSetUp(const SharedSetUp& setUp) {
  const bool same = setUp && setUp_ && setUp->choice.rig.table == setUp_->choice.rig.table &&
                    setUp->choice.rig.sensor == setUp_->choice.rig.sensor &&
                    setUp->choice.scanner == setUp_->choice.scanner;
  setUp_ = setUp;
  if (same || !setUp) return;
  result_.reset();
  failure_.clear();
  emit changed();
}

QString TableCalibrating::whyNot() const {
  if (!work_.idle()) return tr("Something else is under way.");
  if (!setUp_ || !setUp_->devices) return tr("Scanner and object are not read yet.");
  if (!std::holds_alternative<RealDevices>(*setUp_->devices)) return tr("A simulated table needs no calibration.");
  if (turnsByItself(setUp_->choice.rig.table)) return {};
  return tr("Only a table that turns by itself has an angle that can be calibrated.");
}

void TableCalibrating::calibrate(int scans) {
  if (!whyNot().isEmpty()) return;
  work_.begin<CalibrationResult>(
      Activity::Testing, tr("Calibrating the table"),
      [setUp = setUp_, devices = devices_, scans](const Progress& progress) {
        RigKeeper::Use use = devices->open(setUp, 0, {}, progress.part(0.0, 0.05));
        const Rig& rig = use.rig();
        try {
          const auto taken =
              takeCalibrationScans(*rig.sensor, *rig.table, calibrationAngles(scans), progress.part(0.05, 0.6, "scan"),
                                   startsByItself(setUp->choice.rig.sensor));
          return calibrateTable(taken, *setUp->profile, {}, progress.part(0.6, 1.0, "calibrate"));
        } catch (const DeviceError&) {
          use.drop();
          throw;
        }
      },
      [this](CalibrationResult found) {
        result_ = std::move(found);
        failure_.clear();
        emit changed();
      },
      [this](const QString& why) {
        result_.reset();
        failure_ = why;
        emit changed();
      });
}

bool TableCalibrating::usable() const {
  return result_ && result_->calibration.verdict != CalibrationVerdict::Failed;
}

void TableCalibrating::keep(const QString& folder) {
  if (!usable()) return;
  work_.begin<QString>(
      Activity::Writing, tr("Writing the calibration"),
      [folder = folder.toStdString(), calibration = result_->calibration, source = setUp_->source](const Progress&) {
        // A scanner that does not fit its table is refused before anything is written.
        static_cast<void>(parseProfile(withCalibration(source, calibration)));
        std::error_code error;
        fs::create_directories(folder, error);
        if (error) throw IoError(folder, "cannot be made a folder: " + error.message());
        return QString::fromStdString(writeNew(folder, calibrationText(calibration)));
      },
      [this](const QString& path) { emit kept(path); });
}

}  // namespace vantage
