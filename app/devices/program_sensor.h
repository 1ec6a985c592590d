#pragma once

#include <memory>
#include <optional>
#include <string>

#include "devices/rig_description.h"
#include "io/scan_reader.h"
#include "scanner/profile.h"
#include "scanner/range_sensor.h"

namespace vantage {

/// A scanner that a program works: it is run for every scan and writes a range file, in any format of readScan. In its
/// arguments are filled in {file}: where it is to write, in a folder of ours that is emptied afterwards; with
/// "{file}.png" the name ends so, else in .ply, the content tells the format; {position} of the workspace; {angle} and
/// {tilt}: how far the table has turned and the scanner is tilted since position 0 [deg].
class ProgramSensor final : public RangeSensor {
 public:
  /// @throws InvalidInput for arguments without {file}, or with another word in braces
  ProgramSensor(ProgramDevice program, std::shared_ptr<const ScannerProfile> profile, ScanReadingOptions reading = {});
  ~ProgramSensor() override;

  [[nodiscard]] std::string identity() const override { return "program " + program_.run.front(); }
  /// @throws DeviceError when there is no room for its files
  void open(const Progress& progress) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<std::string> notReady() const override;

  /// @throws DeviceError when the program cannot be started, fails, does not end in time, or leaves no file or one that
  /// cannot be read, with the end of what it said; Cancelled: it and all that it started were ended
  [[nodiscard]] RangeImage capture(const Progress& progress) override;
  void standAt(const ReachedPose& pose) override { pose_ = pose; }

  /// What the program wrote to its outputs the last time.
  [[nodiscard]] const std::string& output() const { return output_; }

 private:
  [[nodiscard]] std::string fileOf(const std::string& name) const;
  [[nodiscard]] std::string written(const std::string& file, const std::string& said) const;
  void emptyFolder() const noexcept;

  ProgramDevice program_;
  std::shared_ptr<const ScannerProfile> profile_;
  ScanReadingOptions reading_;
  std::string folder_;
  std::optional<ReachedPose> pose_;
  std::string output_;
};

}  // namespace vantage
