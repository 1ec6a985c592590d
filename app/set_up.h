#pragma once

#include <memory>
#include <optional>
#include <string>

#include "acquisition/acquisition_state.h"
#include "base/phrase.h"
#include "base/progress.h"
#include "devices/device_factory.h"
#include "devices/rig_set_up.h"
#include "geometry/mesh.h"
#include "positional_space/scanner_images.h"
#include "scanner/profile.h"

namespace vantage {

/// What an operator chooses before the first scan.
struct SetUpChoice {
  RigDescription rig;            ///< what scans and what turns
  std::string scanner;           ///< profile file
  std::string folder;            ///< where session, models and report go
  AcquisitionSettings settings;  ///< names the object
};
[[nodiscard]] bool operator==(const SetUpChoice& a, const SetUpChoice& b);

/// What stands before the simulated sensor.
struct ObjectOnTable {
  std::shared_ptr<const Mesh> mesh;  ///< in table coordinates
  double radius = 0.0;               ///< about the table's axis [mm]
  double height = 0.0;               ///< of its highest point above the table; 0 when there is none [mm]
  double lowest = 0.0;               ///< of its lowest point [mm]
  bool insideVolume = true;          ///< it keeps to the viewing volume
};
[[nodiscard]] ObjectOnTable measured(std::shared_ptr<const Mesh> mesh, const ViewingVolume& volume);

/// A set-up as it was read. Immutable, shared.
struct SetUp {
  SetUpChoice choice;
  ProfileSource source;
  std::shared_ptr<const ScannerProfile> profile;
  std::optional<DeviceSetUp> devices;   ///< what scans are taken with; nothing where none can be taken
  std::optional<ObjectOnTable> object;  ///< of the simulated scanner; nothing where the scanner needs none
  std::shared_ptr<const ScannerImages> images;
  std::string notes;  ///< what was done to the object while reading it, or why it could not be read; empty for nothing
};
/// Puts the devices that were chosen before a set-up whose profile is known; a person who turns the table has done so
/// before they ask for a scan.
void connectDevices(SetUp& setUp);
/// Whether a person turns the table.
[[nodiscard]] bool turnedByHand(const SetUp& setUp);

/// How much memory the scanner of a choice is going to take, by what its profile says; nothing where that is little.
/// @throws IoError, InvalidInput as prepareSetUp does for the profile
[[nodiscard]] std::optional<Phrase> memoryNoteOf(const SetUpChoice& choice);

using SharedSetUp = std::shared_ptr<const SetUp>;

/// Puts a mesh before the simulated scanner of a set-up whose profile and settings are known.
void placeObject(SetUp& setUp, std::shared_ptr<const Mesh> mesh);

/// Reads profile and object, puts the object on the table and gets the scanner's images.
/// @param cacheFolder where images are kept between runs; empty for nowhere.
/// @throws IoError, InvalidInput naming the file; Cancelled
[[nodiscard]] SharedSetUp prepareSetUp(const SetUpChoice& choice, const std::string& cacheFolder,
                                       const Progress& progress);

}  // namespace vantage
