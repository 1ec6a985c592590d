#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vantage {

/// A program that is run for every scan or every move, without a shell. In its arguments {file}, {position}, {angle}
/// and {tilt} are filled in.
struct ProgramDevice {
  std::vector<std::string> run;               ///< the program and its arguments
  std::chrono::milliseconds timeout{60'000};  ///< after which it is ended

  bool operator==(const ProgramDevice&) const = default;
};

/// A range scanner that is a mesh.
struct SimulatedSensorDevice {
  bool operator==(const SimulatedSensorDevice&) const = default;
};
/// A folder that a vendor's program writes range files to.
struct FolderDevice {
  std::string folder;
  bool operator==(const FolderDevice&) const = default;
};
/// A depth camera. @param uri empty for the first that answers
struct OpenNi2Device {
  std::string uri;
  bool operator==(const OpenNi2Device&) const = default;
};
/// The scans of a session again.
struct ReplayDevice {
  std::string session;
  bool operator==(const ReplayDevice&) const = default;
};
using SensorDevice = std::variant<SimulatedSensorDevice, FolderDevice, OpenNi2Device, ReplayDevice, ProgramDevice>;

struct SimulatedTableDevice {
  bool operator==(const SimulatedTableDevice&) const = default;
};
/// The scanner stays where it is, at position 0.
struct NoTableDevice {
  bool operator==(const NoTableDevice&) const = default;
};
/// A person turns the table.
struct HandTableDevice {
  bool operator==(const HandTableDevice&) const = default;
};
/// A turntable on a serial line.
struct SerialTableDevice {
  std::string port;      ///< a device file, or the name of a port
  std::string protocol;  ///< of resources/turntables; empty: found by asking
  bool operator==(const SerialTableDevice&) const = default;
};
using TableDevice =
    std::variant<SimulatedTableDevice, NoTableDevice, HandTableDevice, SerialTableDevice, ProgramDevice>;

/// What scans and what turns, as an operator chose it. See docs of RIG.json in resources/manual.
struct RigDescription {
  SensorDevice sensor;
  TableDevice table;
  std::string scanner;      ///< profile file; empty where it is given elsewhere
  std::string calibration;  ///< file; empty for none: the table is where the profile says

  bool operator==(const RigDescription&) const = default;
};

/// Whether that is a real table with a drive.
[[nodiscard]] bool turnsByItself(const TableDevice& table);

/// "simulated", "folder:DIR", "openni2[:URI]", "replay:S.vantage". @throws InvalidInput for anything else
[[nodiscard]] SensorDevice parseSensor(const std::string& text);
/// "simulated", "none", "hand", "serial:PORT[,PROTOCOL]". @throws InvalidInput for anything else
[[nodiscard]] TableDevice parseTable(const std::string& text);
/// The inverse of both. A program is told by its name.
[[nodiscard]] std::string describe(const SensorDevice& sensor);
[[nodiscard]] std::string describe(const TableDevice& table);

/// Reads RIG.json: { "sensor": TEXT or {"kind": "command", "run": [...], "timeout_s": 60}, "table": likewise,
/// "scanner": FILE, "calibration": FILE, "cut": {...} }. Files are relative to it. What it holds beyond the description
/// is the settings of what is cut away, as key and value of `vantage-cli options`.
struct RigFile {
  RigDescription rig;
  std::vector<std::pair<std::string, std::string>> settings;  ///< "cut.<key>" = value
};
/// @throws IoError, InvalidInput that names file, JSON pointer and what was expected
[[nodiscard]] RigFile readRigFile(const std::string& path);
/// The same of its text. @param path of the file that its paths are relative to
[[nodiscard]] RigFile parseRigFile(const std::string& text, const std::string& path);
/// The text of such a file.
[[nodiscard]] std::string rigFileText(const RigFile& file);

}  // namespace vantage
