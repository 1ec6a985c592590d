#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/scan_reader.h"
#include "scanner/profile.h"
#include "scanner/range_sensor.h"

namespace vantage {

class Session;

/// Takes the scans of a session, or the range files of a folder, again. For a position it gives the next scan of that
/// position that it has not given yet. Files belong to the position that their name has behind "position" or "pos"
/// ("mug_pos12.ply"); files without one, and scans of no position, are given in their order wherever the scanner
/// stands. Nothing is written.
class ReplaySensor final : public RangeSensor {
 public:
  /// @param source a session or a folder
  ReplaySensor(std::string source, std::shared_ptr<const ScannerProfile> profile, ScanReadingOptions reading = {});
  ~ReplaySensor() override;

  [[nodiscard]] std::string identity() const override { return "replay of " + source_; }
  /// @throws DeviceError when there is no such session or folder, or it has no scans; Cancelled
  void open(const Progress& progress) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<std::string> notReady() const override;

  /// @throws DeviceError when no scan of the position is left, it cannot be read or is another scanner's; Cancelled
  [[nodiscard]] RangeImage capture(const Progress& progress) override;
  void standAt(const ReachedPose& pose) override { pose_ = pose; }

 private:
  // A recorded scan.
  struct Recorded {
    std::optional<int> position;
    std::int64_t number = 0;  // of a session
    std::string file;         // of a folder
    bool given = false;
  };
  void listSession(const Progress& progress);
  void listFolder();
  [[nodiscard]] Recorded& next();
  [[nodiscard]] RangeImage read(const Recorded& recorded, const Progress& progress) const;

  std::string source_;
  std::shared_ptr<const ScannerProfile> profile_;
  ScanReadingOptions reading_;
  std::unique_ptr<Session> session_;
  std::vector<Recorded> recorded_;
  std::optional<ReachedPose> pose_;
};

}  // namespace vantage
