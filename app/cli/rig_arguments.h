#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "acquisition/settings.h"
#include "devices/rig_description.h"
#include "scanner/profile.h"

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

/// Whether scans are taken of a mesh. @throws InvalidInput when sensor and table do not belong together
[[nodiscard]] bool isSimulated(const RigDescription& rig);

/// The profile with its calibration, as the session keeps it. @throws InvalidInput, IoError
[[nodiscard]] ProfileSource profileOf(const RigDescription& rig);

/// What is cut away of scans: with devices that see more than the object all of it, unless something else was said.
[[nodiscard]] AcquisitionSettings withCut(AcquisitionSettings settings, const RigFile& file);

}  // namespace vantage
