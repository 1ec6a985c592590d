#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "devices/rig_set_up.h"

namespace vantage {

/// What scans and what turns, on the command line: --sensor, --table, --scanner, --calibration, or --rig for all four.
class RigArguments {
 public:
  /// This must outlive the command.
  void addTo(CLI::App& command);
  /// The same for a session that has its scanner.
  void addDevicesTo(CLI::App& command);

  /// Whether anything was said.
  [[nodiscard]] bool given() const { return !(rig_.empty() && sensor_.empty() && table_.empty()); }

  /// What was described: of --rig, with what the others say instead. @throws InvalidInput, IoError
  [[nodiscard]] RigFile described() const;

 private:
  std::string rig_;
  std::string sensor_;
  std::string table_;
  std::string scanner_;
  std::string calibration_;
};

}  // namespace vantage
