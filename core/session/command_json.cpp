#include "session/command_json.h"

#include <limits>
#include <type_traits>

#include "acquisition/settings_json.h"
#include "session/json_fields.h"
#include "session/reading_json.h"
#include "session/region_json.h"
#include "session/stand_json.h"
#include "session/value_json.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

// Writes the fields of a command.
class FieldWriter {
 public:
  explicit FieldWriter(Json& json) : json_(json) {}

  void operator()(const char* /*key*/, const AcquisitionSettings& settings) { json_ = settingsJson(settings); }
  void operator()(const char* key, const std::optional<PositionScore>& score) {
    if (score) json_[key] = predictionJson(*score);
  }
  // -1 is no position, as in the files of all versions.
  void operator()(const char* key, std::optional<int> position) { json_[key] = position.value_or(-1); }
  void operator()(const char* key, const std::optional<Pose>& pose) { json_[key] = standPoseJson(pose); }
  void operator()(const char* key, const Pose& pose) { json_[key] = poseJson(pose); }
  void operator()(const char* key, const std::optional<Vec3>& vector) {
    if (vector) json_[key] = numberList(*vector, 3);
  }
  void operator()(const char* key, const Region& region) { json_[key] = regionJson(region); }
  void operator()(const char* key, const PickedPairs& picks) {
    if (!picks.empty()) json_[key] = picksJson(picks);
  }
  void operator()(const char* key, const std::vector<ScanReading>& readings) {
    if (!readings.empty()) json_[key] = readingsJson(readings);
  }
  template <typename Value>
  void operator()(const char* key, const Value& value) {
    if constexpr (std::is_enum_v<Value>)
      json_[key] = name(value);
    else
      json_[key] = value;
  }

 private:
  Json& json_;
};

constexpr Termination lastOf(Termination /*of*/) {
  return kLastTermination;
}
constexpr Mode lastOf(Mode /*of*/) {
  return kLastMode;
}

// Reads them back.
class FieldReader {
 public:
  FieldReader(const Json& json, const JsonFields& fields) : json_(json), fields_(fields) {}

  void operator()(const char* /*key*/, AcquisitionSettings& settings) {
    settings = settingsFromJson(json_, fields_.what());
  }
  void operator()(const char* key, std::optional<PositionScore>& score) {
    if (fields_.has(key)) score = predictionFrom(fields_.object(key));
  }
  void operator()(const char* key, std::optional<int>& position) {
    const int number = fields_.integer(key);
    if (number >= 0) position = number;
  }
  void operator()(const char* key, std::optional<Pose>& pose) { pose = standPoseFrom(fields_, json_, key); }
  void operator()(const char* key, Pose& pose) {
    const auto read = standPoseFrom(fields_, json_, key);
    if (!read) fields_.fail(key);
    pose = *read;
  }
  void operator()(const char* key, std::int64_t& number) {
    number = fields_.integer(key, 0, std::numeric_limits<std::int64_t>::max());
  }
  void operator()(const char* key, int& number) { number = fields_.integer(key); }
  void operator()(const char* key, double& number) { number = fields_.number(key); }
  void operator()(const char* key, bool& flag) { flag = fields_.flag(key); }
  void operator()(const char* key, std::optional<Vec3>& vector) {
    if (!fields_.has(key)) return;
    vector = Vec3::Zero();
    fields_.numbers(key, vector->data(), 3);
    if (!vector->allFinite()) fields_.fail(key);
  }
  void operator()(const char* key, Region& region) { region = regionFrom(fields_.object(key)); }
  void operator()(const char* key, PickedPairs& picks) {
    if (fields_.has(key)) picks = picksFrom(fields_.list(key), fields_.what());
  }
  void operator()(const char* key, std::vector<ScanReading>& readings) {
    if (fields_.has(key)) readings = readingsFrom(fields_.list(key), fields_.what());
  }
  void operator()(const char* key, std::vector<std::int64_t>& numbers) {
    for (const Json& number : fields_.list(key)) {
      if (!number.is_number_unsigned()) fields_.fail(key);
      numbers.push_back(number.get<std::int64_t>());
    }
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* key, Enum& value) { value = fields_.named(key, lastOf(value)); }

 private:
  const Json& json_;
  const JsonFields& fields_;
};

template <typename Kind>
Json fieldsOf(const Kind& command) {
  Json json = Json::object();
  Kind::fields(command, FieldWriter(json));
  return json;
}

// The command of a kind, tried one after the other; nothing when none has that name.
template <std::size_t I = 0>
std::optional<Command> commandOf(std::string_view kind, const Json& json, const JsonFields& fields) {
  if constexpr (I < std::variant_size_v<Command>) {
    using Kind = std::variant_alternative_t<I, Command>;
    if (kind != Kind::kKind) return commandOf<I + 1>(kind, json, fields);
    Kind command;
    Kind::fields(command, FieldReader(json, fields));
    return command;
  } else {
    return std::nullopt;
  }
}

}  // namespace

std::string commandText(const Command& command) {
  return std::visit([](const auto& c) { return fieldsOf(c).dump(-1, ' ', false, Json::error_handler_t::replace); },
                    command);
}

Command commandFromText(std::string_view kind, const std::string& text, const std::string& what) {
  const Json json = jsonObject(text, what);
  if (auto command = commandOf(kind, json, JsonFields(json, what))) return *std::move(command);
  throw InvalidInput(what + " is damaged: its kind of command is not known");
}

}  // namespace vantage
