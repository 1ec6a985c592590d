#include "devices/serial/table_profile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "io/file_bytes.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxProfileBytes = 1U << 18;
constexpr double kMostUnits = 1e7;  // per turn

std::string textOr(JsonObjectReader& reader, const std::string& key, const std::string& fallback = {}) {
  if (!reader.has(key)) return fallback;
  const nlohmann::json& value = reader.required(key, "a text");
  if (!value.is_string()) reader.fail(key, "a text");
  return value.get<std::string>();
}

bool flagOr(JsonObjectReader& reader, const std::string& key, bool fallback) {
  if (!reader.has(key)) return fallback;
  const nlohmann::json& value = reader.required(key, "true or false");
  if (!value.is_boolean()) reader.fail(key, "true or false");
  return value.get<bool>();
}

std::chrono::milliseconds secondsOr(JsonObjectReader& reader, const std::string& key, double fallback) {
  return std::chrono::milliseconds(std::llround(1000.0 * reader.number(key, 0.0, 60.0, false, fallback)));
}

std::string characterOr(JsonObjectReader& reader, const std::string& key) {
  const std::string text = textOr(reader, key);
  if (text.size() > 1) reader.fail(key, "one character");
  return text;
}

MessagePattern pattern(JsonObjectReader& reader, const std::string& key, const std::string& axis) {
  std::string expression = reader.string(key);
  if (const std::size_t at = expression.find("{axis}"); at != std::string::npos) expression.replace(at, 6, axis);
  try {
    return MessagePattern(expression);
  } catch (const std::regex_error&) {
    reader.fail(key, "a regular expression");
  }
}

std::optional<MessagePattern> patternIf(JsonObjectReader& reader, const std::string& key, const std::string& axis) {
  if (!reader.has(key)) return std::nullopt;
  return pattern(reader, key, axis);
}

std::map<std::string, TableState> readStates(JsonObjectReader& reader) {
  std::map<std::string, TableState> states;
  if (!reader.has("states")) return states;
  const nlohmann::json& value = reader.required("states", "an object");
  JsonObjectReader words = reader.object("states");
  for (const auto& [word, meaning] : value.items()) {
    const auto state = tableStateOf(words.string(word));
    if (!state) words.fail(word, "one of idle, moving, homing, held, door, alarm, check, sleep, unknown");
    states.emplace(word, *state);
  }
  return states;
}

StatusProfile readStatus(JsonObjectReader reader, const std::string& axis) {
  StatusProfile status{.ask = reader.string("ask"),
                       .immediate = flagOr(reader, "immediate", false),
                       .report = pattern(reader, "report", axis),
                       .state = patternIf(reader, "state", axis),
                       .machine = pattern(reader, "machine", axis),
                       .work = patternIf(reader, "work", axis),
                       .offset = patternIf(reader, "offset", axis),
                       .count = patternIf(reader, "count", axis),
                       .states = readStates(reader),
                       .wait = textOr(reader, "wait")};
  reader.finish();
  return status;
}

BoardSettings readSettings(JsonObjectReader reader) {
  BoardSettings settings{.ask = reader.string("ask"),
                         .pattern = pattern(reader, "pattern", {}),
                         .inches = textOr(reader, "inches"),
                         .homing = textOr(reader, "homing")};
  reader.finish();
  return settings;
}

MoveProfile readMove(JsonObjectReader reader) {
  MoveProfile move;
  move.send = reader.string("send");
  move.relative = flagOr(reader, "relative", false);
  move.decimals = reader.integer("decimals", 0, 6);
  if (const std::string per = textOr(reader, "feed_per", "min"); per != "min" && per != "s")
    reader.fail("feed_per", "min or s");
  else
    move.feedSeconds = per == "s" ? 1.0 : 60.0;
  reader.finish();
  return move;
}

std::vector<int> readBaud(JsonObjectReader& reader) {
  std::vector<int> rates;
  for (const double rate : reader.numbers("baud", 1, 8)) {
    if (rate != std::floor(rate) || rate < 50 || rate > 4e6) reader.fail("baud", "whole numbers from 50 to 4000000");
    rates.push_back(static_cast<int>(rate));
  }
  return rates;
}

std::vector<std::string> readBegin(JsonObjectReader& reader) {
  std::vector<std::string> commands;
  if (!reader.has("begin")) return commands;
  const nlohmann::json& value = reader.required("begin", "a list of commands");
  if (!value.is_array() || value.size() > 100) reader.fail("begin", "a list of commands");
  for (const auto& command : value) {
    if (!command.is_string()) reader.fail("begin", "a list of commands");
    commands.push_back(command.get<std::string>());
  }
  return commands;
}

std::map<std::string, std::string> readMeanings(JsonObjectReader& reader) {
  std::map<std::string, std::string> meanings;
  if (!reader.has("meanings")) return meanings;
  const nlohmann::json& value = reader.required("meanings", "an object of texts");
  JsonObjectReader texts = reader.object("meanings");
  for (const auto& [code, meaning] : value.items()) meanings.emplace(code, texts.string(code));
  return meanings;
}

int readSense(JsonObjectReader& reader) {
  const int sense = reader.integer("sense", -1, 1);
  if (sense == 0) reader.fail("sense", "1 or -1");
  return sense;
}

// Parts of the file that a profile holds beside each other.
void readWire(JsonObjectReader& reader, TableProfile& profile) {
  JsonObjectReader send = reader.object("send");
  profile.lineEnd = textOr(send, "end");
  send.finish();
  JsonObjectReader receive = reader.object("receive");
  profile.messageEnds = receive.string("ends");
  profile.prompt = characterOr(receive, "prompt");
  profile.heartbeat = characterOr(receive, "heartbeat");
  profile.echo = flagOr(receive, "echo", false);
  receive.finish();
}

void readAnswers(JsonObjectReader reader, TableProfile& profile) {
  profile.ok = patternIf(reader, "ok", profile.axis);
  profile.error = patternIf(reader, "error", profile.axis);
  profile.alarm = patternIf(reader, "alarm", profile.axis);
  profile.done = patternIf(reader, "done", profile.axis);
  reader.finish();
}

void readStop(JsonObjectReader reader, TableProfile& profile) {
  profile.stopHold = characterOr(reader, "hold");
  profile.stopReset = characterOr(reader, "reset");
  profile.stopCommand = textOr(reader, "command");
  reader.finish();
}

void readGreeting(JsonObjectReader reader, TableProfile& profile) {
  profile.greeting = patternIf(reader, "pattern", profile.axis);
  profile.greetingWait = secondsOr(reader, "wait_s", 3.0);
  reader.finish();
}

std::string readAxis(JsonObjectReader& reader) {
  const std::string axis = characterOr(reader, "axis");
  if (!axis.empty() && (axis[0] < 'A' || axis[0] > 'Z')) reader.fail("axis", "a capital letter");
  return axis;
}

TableProfile readProfile(const nlohmann::json& document, const std::string& path) {
  JsonObjectReader reader(document, path, "");
  const std::string axis = readAxis(reader);
  JsonObjectReader identify = reader.object("identify");
  TableProfile profile;
  profile.identity = pattern(identify, "pattern", axis);
  profile.move = readMove(reader.object("move"));
  profile.name = fs::path(path).stem().string();
  profile.title = reader.string("title");
  profile.identify = identify.string("send");
  profile.identifyImmediate = flagOr(identify, "immediate", false);
  identify.finish();
  profile.axis = axis;
  profile.axes = textOr(reader, "axes");
  profile.baud = readBaud(reader);
  profile.unitsPerTurn = reader.number("units_per_turn", 0.0, kMostUnits, true);
  profile.sense = readSense(reader);
  profile.speed = reader.number("speed_deg_s", 0.0, 3600.0, true);
  profile.slowest = reader.number("slowest_deg_s", 0.0, 3600.0, true);
  profile.fastest = reader.number("fastest_deg_s", 0.0, 1e6, true, 1e5);
  profile.tolerance = reader.number("tolerance_deg", 0.0, 10.0, true);
  if (reader.has("longest_move_deg")) profile.longestMove = reader.number("longest_move_deg", 0.0, 3600.0, true);
  profile.settle = secondsOr(reader, "settle_s", 0.5);
  readWire(reader, profile);
  readGreeting(reader.object("greeting"), profile);
  profile.begin = readBegin(reader);
  readAnswers(reader.object("answers"), profile);
  if (reader.has("status")) profile.status = readStatus(reader.object("status"), axis);
  if (reader.has("settings")) profile.settings = readSettings(reader.object("settings"));
  if (reader.has("stop")) readStop(reader.object("stop"), profile);
  profile.unlock = textOr(reader, "unlock");
  profile.index = textOr(reader, "index");
  profile.motorOff = textOr(reader, "motor_off");
  profile.meanings = readMeanings(reader);
  if (!profile.status && !profile.done)
    throw InvalidInput(path + ": /status is missing, expected it, or /answers/done: one must tell that a move is over");
  reader.finish();
  return profile;
}

nlohmann::json readDocument(const std::string& path) {
  const FileBytes bytes(path, kMaxProfileBytes);
  return parseJson(std::string(bytes.text()), path);
}

std::vector<std::string> profileFiles(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  if (failed) throw IoError(folder, "cannot be listed: " + failed.message());
  std::sort(files.begin(), files.end());
  return files;
}

// "grbl:axis=A:units_per_turn=40" cut at every colon that a key and an equals sign follow.
std::vector<std::string> partsOf(const std::string& protocol) {
  static const std::regex kNext(":(?=[a-z_]+=)");
  return {std::sregex_token_iterator(protocol.begin(), protocol.end(), kNext, -1), std::sregex_token_iterator()};
}

void override(nlohmann::json& document, const std::string& part, const std::string& protocol) {
  const std::size_t equals = part.find('=');
  const std::string key = part.substr(0, equals);
  const std::string text = part.substr(equals + 1);
  if (!document.contains(key) || document[key].is_structured())
    throw InvalidInput(
        "the protocol " + shownText(protocol) + " sets " + shownText(key) +
        ", expected a number or text of the profile, such as units_per_turn, axis, sense or speed_deg_s");
  const nlohmann::json number = nlohmann::json::parse(text, nullptr, false);
  document[key] = document[key].is_number() && number.is_number() ? number : nlohmann::json(text);
}

std::string fileOf(const std::string& name, const std::string& folder) {
  if (name.find('/') != std::string::npos || name.ends_with(".json")) return name;
  const std::string path = folder + "/" + name + ".json";
  if (fs::exists(path)) return path;
  std::string known;
  for (const std::string& file : profileFiles(folder))
    known += (known.empty() ? "" : ", ") + fs::path(file).stem().string();
  throw InvalidInput("the protocol of the turntable is " + shownText(name) + ", expected one of " + known +
                     ", or a file that ends in .json");
}

}  // namespace

TableProfile readTableProfile(const std::string& path) {
  return readProfile(readDocument(path), path);
}

std::vector<TableProfile> readTableProfiles(const std::string& folder) {
  std::vector<TableProfile> profiles;
  for (const std::string& file : profileFiles(folder)) profiles.push_back(readTableProfile(file));
  if (profiles.empty()) throw IoError(folder, "holds no profile of a turntable (*.json)");
  return profiles;
}

std::vector<TableProfile> tableProfilesFor(const std::string& protocol, const std::string& folder) {
  if (protocol.empty()) return readTableProfiles(folder);
  const std::vector<std::string> parts = partsOf(protocol);
  const std::string path = fileOf(parts.front(), folder);
  nlohmann::json document = readDocument(path);
  for (std::size_t i = 1; i < parts.size(); ++i) override(document, parts[i], protocol);
  return {readProfile(document, path)};
}

}  // namespace vantage
