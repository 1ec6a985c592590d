#pragma once

#include <memory>
#include <string>

#include "devices/rig_description.h"
#include "devices/serial/serial_turntable.h"

namespace vantage {

/// The turntable of a description, not yet open; its profiles are those of resourceFolder("turntables") and files that
/// the description names. @throws IoError, InvalidInput when a profile cannot be read or is not known
[[nodiscard]] std::shared_ptr<SerialTurntable> serialTurntable(const SerialTableDevice& device);

/// What a port that is listened to and asked says.
struct PortAnswer {
  std::string protocol;  ///< name of the profile that it answers to; empty for none
  std::string title;     ///< of the profile, or why nothing is known, as a sentence
};

/// Opens a port, asks which of the profiles it answers to and closes it again. Opening resets most boards.
/// @param protocol as in SerialTableDevice; empty for all profiles. @throws IoError, InvalidInput as above; Cancelled
[[nodiscard]] PortAnswer askPort(const std::string& port, const std::string& protocol, const Progress& progress);

}  // namespace vantage
