#include "devices/rig_description.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "io/file_bytes.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

constexpr std::uintmax_t kMaxRigBytes = 1U << 20;
constexpr double kLongestTimeout = 3600.0;  // [s]

// What follows a word and a colon; nothing when the text does not begin so.
std::optional<std::string> after(const std::string& text, const std::string& word) {
  if (!text.starts_with(word + ":")) return std::nullopt;
  return text.substr(word.size() + 1);
}

ProgramDevice readProgram(JsonObjectReader reader) {
  if (reader.string("kind") != "command") reader.fail("kind", "command");
  ProgramDevice program;
  const nlohmann::json& run = reader.required("run", "a list of texts: the program and its arguments");
  if (!run.is_array() || run.empty() || run.size() > 1000) reader.fail("run", "a list of texts, the program first");
  for (const auto& argument : run) {
    if (!argument.is_string()) reader.fail("run", "a list of texts, the program first");
    program.run.push_back(argument.get<std::string>());
  }
  if (reader.has("timeout_s"))
    program.timeout = std::chrono::milliseconds(
        static_cast<std::int64_t>(std::round(1000.0 * reader.number("timeout_s", 0.0, kLongestTimeout, true))));
  reader.finish();
  return program;
}

template <typename DeviceKind, typename Parser>
DeviceKind readDevice(JsonObjectReader& reader, const std::string& key, const Parser& parse) {
  const nlohmann::json& value = reader.required(key, "a device");
  if (value.is_object()) return readProgram(reader.object(key));
  return parse(reader.string(key));
}

// Paths of a file are relative to it.
std::string beside(const std::string& path, const std::string& name) {
  if (name.empty()) return name;
  return (std::filesystem::path(path).parent_path() / name).lexically_normal().string();
}

struct Sensors {
  std::string operator()(const SimulatedSensorDevice&) const { return "simulated"; }
  std::string operator()(const FolderDevice& d) const { return "folder:" + d.folder; }
  std::string operator()(const OpenNi2Device& d) const { return d.uri.empty() ? "openni2" : "openni2:" + d.uri; }
  std::string operator()(const ReplayDevice& d) const { return "replay:" + d.session; }
  std::string operator()(const ProgramDevice& d) const { return "command " + d.run.front(); }
};

struct Tables {
  std::string operator()(const SimulatedTableDevice&) const { return "simulated"; }
  std::string operator()(const NoTableDevice&) const { return "none"; }
  std::string operator()(const HandTableDevice&) const { return "hand"; }
  std::string operator()(const SerialTableDevice& d) const {
    return "serial:" + d.port + (d.protocol.empty() ? "" : "," + d.protocol);
  }
  std::string operator()(const ProgramDevice& d) const { return "command " + d.run.front(); }
};

template <typename DeviceKind>
nlohmann::ordered_json jsonOf(const DeviceKind& device) {
  const auto* program = std::get_if<ProgramDevice>(&device);
  if (program == nullptr) return describe(device);
  return {{"kind", "command"},
          {"run", program->run},
          {"timeout_s", std::chrono::duration<double>(program->timeout).count()}};
}

}  // namespace

SensorDevice parseSensor(const std::string& text) {
  if (text == "simulated") return SimulatedSensorDevice{};
  if (text == "openni2") return OpenNi2Device{};
  if (const auto uri = after(text, "openni2")) return OpenNi2Device{*uri};
  if (const auto folder = after(text, "folder"); folder && !folder->empty()) return FolderDevice{*folder};
  if (const auto session = after(text, "replay"); session && !session->empty()) return ReplayDevice{*session};
  throw InvalidInput("the sensor is " + shownText(text) +
                     ", expected simulated, folder:DIR, openni2, openni2:URI or replay:SESSION");
}

TableDevice parseTable(const std::string& text) {
  if (text == "simulated") return SimulatedTableDevice{};
  if (text == "none") return NoTableDevice{};
  if (text == "hand") return HandTableDevice{};
  if (const auto port = after(text, "serial"); port && !port->empty()) {
    const std::size_t comma = port->rfind(',');
    if (comma == std::string::npos) return SerialTableDevice{*port, {}};
    return SerialTableDevice{port->substr(0, comma), port->substr(comma + 1)};
  }
  throw InvalidInput("the table is " + shownText(text) + ", expected simulated, none, hand or serial:PORT[,PROTOCOL]");
}

std::string describe(const SensorDevice& sensor) {
  return std::visit(Sensors{}, sensor);
}

bool turnsByItself(const TableDevice& table) {
  return std::holds_alternative<SerialTableDevice>(table) || std::holds_alternative<ProgramDevice>(table);
}

std::string describe(const TableDevice& table) {
  return std::visit(Tables{}, table);
}

RigFile readRigFile(const std::string& path) {
  const FileBytes bytes(path, kMaxRigBytes);
  return parseRigFile(std::string(bytes.text()), path);
}

RigFile parseRigFile(const std::string& text, const std::string& path) {
  const nlohmann::json document = parseJson(text, path);
  JsonObjectReader reader(document, path, "");
  RigFile file;
  file.rig.sensor = readDevice<SensorDevice>(reader, "sensor", parseSensor);
  file.rig.table = readDevice<TableDevice>(reader, "table", parseTable);
  if (auto* folder = std::get_if<FolderDevice>(&file.rig.sensor)) folder->folder = beside(path, folder->folder);
  if (auto* replay = std::get_if<ReplayDevice>(&file.rig.sensor)) replay->session = beside(path, replay->session);
  if (reader.has("scanner")) file.rig.scanner = beside(path, reader.fileName("scanner"));
  if (reader.has("calibration")) file.rig.calibration = beside(path, reader.fileName("calibration"));
  if (reader.has("cut")) {
    const nlohmann::json& cut = reader.required("cut", "an object of settings");
    if (!cut.is_object()) reader.fail("cut", "an object of settings");
    for (const auto& [key, value] : cut.items())
      file.settings.emplace_back("cut." + key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  reader.finish();
  return file;
}

std::string rigFileText(const RigFile& file) {
  nlohmann::ordered_json json{{"sensor", jsonOf(file.rig.sensor)}, {"table", jsonOf(file.rig.table)}};
  if (!file.rig.scanner.empty()) json["scanner"] = file.rig.scanner;
  if (!file.rig.calibration.empty()) json["calibration"] = file.rig.calibration;
  for (const auto& [key, value] : file.settings) json["cut"][key.substr(key.find('.') + 1)] = value;
  return json.dump(2) + "\n";
}

}  // namespace vantage
