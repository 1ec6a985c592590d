#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <variant>

#include "devices/rig_description.h"
#include "io/scan_reader.h"
#include "scanner/hand_table.h"
#include "scanner/simulated_sensor.h"
#include "scanner/table_stand.h"

namespace vantage {

/// The simulated scanner and its table, before a mesh.
struct Simulated {
  std::shared_ptr<const Mesh> object;  ///< as it stands on the table
  std::shared_ptr<const ScannerProfile> profile;
  SimulationOptions options;
  HandTable::AskPerson ask = {};  ///< a person turns the table; empty: it turns by itself
};

/// How well a person who turns a table meets an angle: fifteen degrees are two sigmas.
inline constexpr Mechanics kTurnedByHand{radians(7.5), 3.0};

/// Devices that stand somewhere. @pre the sensor and the table are not simulated
struct RealDevices {
  RigDescription rig;
  std::shared_ptr<const ScannerProfile> profile;
  HandTable::AskPerson ask;         ///< for a table that a person turns
  ScanReadingOptions reading = {};  ///< what is said about files that come as scans
  TableStand stands = {};           ///< where the table stands when it is opened
};

/// What scans are taken with, by kind.
using DeviceSetUp = std::variant<Simulated, RealDevices>;

/// The devices of a set-up, not yet open. @param scansBefore how many scans of the session were taken before.
[[nodiscard]] Rig makeDevices(const DeviceSetUp& setUp, std::int64_t scansBefore);

/// Makes the devices of set-ups, in the one way that window and command line share. All that it hands out are given up
/// when they show no sign of life for too long, and answer a stop soon, whether the device listens or not.
class DeviceFactory {
 public:
  using Maker = std::function<Rig(const DeviceSetUp& setUp, std::int64_t scansBefore)>;

  /// Longer than anything takes that a device does between two signs of life.
  static constexpr std::chrono::minutes kPatience{2};

  explicit DeviceFactory(std::chrono::milliseconds patience = kPatience, Maker make = makeDevices);

  /// The devices of a set-up, open. @throws DeviceError, Cancelled
  [[nodiscard]] Rig open(const DeviceSetUp& setUp, std::int64_t scansBefore, const Progress& progress) const;

 private:
  std::chrono::milliseconds patience_;
  Maker make_;
};

}  // namespace vantage
