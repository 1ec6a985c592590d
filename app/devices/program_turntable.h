#pragma once

#include <optional>
#include <string>

#include "devices/rig_description.h"
#include "scanner/turntable.h"

namespace vantage {

/// A turntable that a program turns: it is run for every move, and the table stands when it has ended. In its arguments
/// are filled in {angle}: where to turn to [deg, may be below 0 and above 360], and {position} of the workspace.
/// When the last line that it writes to stdout is a number, that is the angle reached.
class ProgramTurntable final : public Turntable {
 public:
  /// @throws InvalidInput for arguments with neither, or with another word in braces
  explicit ProgramTurntable(ProgramDevice program);

  [[nodiscard]] std::string identity() const override { return "program " + program_.run.front(); }
  void open(const Progress& progress) override;
  void close() noexcept override { open_ = false; }
  [[nodiscard]] std::optional<std::string> notReady() const override;

  /// @throws DeviceError when the program cannot be started, fails or does not end in time, with the end of what it
  /// said; Cancelled: it was ended. Where the table stands is not known then.
  [[nodiscard]] TableAngle turnTo(double degrees, const Progress& progress) override;
  [[nodiscard]] std::optional<TableAngle> angle() const override { return angle_; }
  /// @throws DeviceError always: a program has no such command
  void home(const Progress& progress) override;
  void headFor(int position) override { position_ = position; }

  /// What the program wrote to its outputs the last time.
  [[nodiscard]] const std::string& output() const { return output_; }

 private:
  ProgramDevice program_;
  bool open_ = false;
  std::optional<int> position_;
  std::optional<TableAngle> angle_;
  std::string output_;
};

}  // namespace vantage
