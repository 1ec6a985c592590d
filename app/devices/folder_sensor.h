#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "devices/folder_watch.h"
#include "io/scan_reader.h"
#include "scanner/profile.h"
#include "scanner/range_sensor.h"

namespace vantage {

struct FolderSensorOptions {
  std::string folder;
  ScanReadingOptions reading;  ///< what an operator says about the files
  std::optional<std::chrono::milliseconds> deadline =
      {};                                   ///< for a file to come; nothing: it is waited for until it comes
  bool existing = false;                    ///< files that are there already are taken as well
  bool tableAlwaysTurns = false;            ///< before every scan, also to where it stands already
  std::chrono::milliseconds rest{500};      ///< see FolderWatch
  std::chrono::milliseconds interval{100};  ///< between two looks
};

/// A file that was seen and not taken.
struct RefusedFile {
  std::string path;
  std::string reason;  ///< a sentence that names the file
};

/// Scans that a vendor's program writes to a folder, in any format of readScan. Files stay as they are.
class FolderSensor final : public RangeSensor {
 public:
  FolderSensor(FolderSensorOptions options, std::shared_ptr<const ScannerProfile> profile);

  [[nodiscard]] std::string identity() const override;
  /// @throws DeviceError when the folder is not there or cannot be read
  void open(const Progress& progress) override;
  void close() noexcept override { open_ = false; }
  [[nodiscard]] std::optional<std::string> notReady() const override;

  /// Waits for the next file that is finished and can be read, of several the oldest. The step of the progress says
  /// what it waits for, and why the last file was not taken; at last which one was, and which others wait. Those are
  /// refused when a move is announced: they are of the place that the table leaves. What had come when a capture ended
  /// without a scan is for the next one, unless the table has turned since; then it is refused.
  /// @throws DeviceError when the folder goes away, none came in time, or a file needs an answer (see readScan), which
  /// is then taken when the next sensor or capture has it; Cancelled
  [[nodiscard]] RangeImage capture(const Progress& progress) override;
  void announceMove() override;
  /// A file that somebody began to write while the table was still turning is of no position, and not taken.
  void standAt(const ReachedPose& pose) override;

  /// What the operator says about the files from now on.
  void setReading(const ScanReadingOptions& reading) { options_.reading = reading; }

  /// What was seen and not taken, by name; from any thread.
  [[nodiscard]] std::vector<RefusedFile> refused() const;
  /// The file of the last capture; empty before the first. From any thread.
  [[nodiscard]] std::string lastFile() const;

 private:
  [[nodiscard]] RangeImage waitForScan(bool begun, const Progress& progress);
  [[nodiscard]] std::optional<RangeImage> takeOne(const Progress& progress);
  [[nodiscard]] std::optional<RangeImage> take(const WatchedFile& file, const Progress& progress);
  void refuse(const std::string& path, std::string reason);
  void refuseLeftOver();
  void refuseInterrupted();
  [[nodiscard]] std::string takenText(const WatchedFile& file);
  [[nodiscard]] std::string waitingText() const;
  [[noreturn]] void tooLate() const;

  FolderSensorOptions options_;
  std::shared_ptr<const ScannerProfile> profile_;
  FolderWatch watch_;
  bool open_ = false;
  bool begun_ = false;             // files that came since the move began are meant
  bool interrupted_ = false;       // the last capture ended without a scan
  std::vector<std::string> left_;  // what had come for it, when the move was announced
  std::optional<Pose> pose_;
  std::map<std::uint64_t, std::string> taken_;  // by the hash of the content

  mutable std::mutex mutex_;  // of what follows
  std::map<std::string, std::string> refused_;
  std::string lastRefused_;
  std::string lastFile_;
};

}  // namespace vantage
