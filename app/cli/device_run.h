#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/stand_course.h"
#include "cli/command.h"
#include "devices/rig_description.h"
#include "geometry/mesh.h"
#include "io/scan_reader.h"
#include "session/session.h"

namespace vantage {

/// The devices that a session is run with, as the command line describes them.
struct DeviceRun {
  RigDescription rig;
  std::shared_ptr<const Mesh> object;  ///< what simulated ones look at; null for real ones
  ScanReadingOptions reading;          ///< of files that come as scans
  bool events = false;                 ///< a program is told what goes on
  std::optional<StandCourse> course;   ///< of simulated devices: from stand to stand; nothing: as the session says
  std::vector<int> positions;          ///< scans are taken from these and no others; empty: as is planned
};

/// Runs a session until nothing is left to scan, or until the scans that were asked for are taken, with the person who
/// turns the table, where one does.
/// @param out folder for the results, which exists
/// @throws as SessionRun::run
void runDevices(Session& session, const DeviceRun& with, const std::string& out, CommandContext& context);

}  // namespace vantage
