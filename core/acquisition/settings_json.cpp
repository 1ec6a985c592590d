#include "acquisition/settings_json.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_table.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "io/file_bytes.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

// A profile of options is a few kilobytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 20;

// Names of session files of schema 1 and 2.
struct EarlierName {
  std::string_view earlier;
  std::string_view key;
};
constexpr std::array<EarlierName, 5> kEarlierNames{{{"object", "simulation.object"},
                                                    {"placement", "simulation.placement"},
                                                    {"seed", "simulation.seed"},
                                                    {"ideal", "simulation.ideal"},
                                                    {"tolerance", "planner.tolerance"}}};

// What every version has written: settings that do not name it are damaged.
constexpr std::array<std::string_view, 8> kAlwaysNamed{
    "first_view",           "max_views",       "strategy",         "simulation.object",
    "simulation.placement", "simulation.seed", "simulation.ideal", "planner.tolerance"};

std::string_view keyOf(const std::string& name) {
  const auto* found =
      std::find_if(kEarlierNames.begin(), kEarlierNames.end(), [&](const EarlierName& e) { return e.earlier == name; });
  return found == kEarlierNames.end() ? std::string_view(name) : found->key;
}

Json jsonOf(const SettingField& field, const AcquisitionSettings& settings) {
  const SettingValue value = valueOf(field, settings);
  if (const auto* on = std::get_if<bool>(&value)) return *on;
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) return *whole;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return settingText(value);
}

// "auto" is nothing where a setting may be unset, and a text elsewhere.
void setJson(const SettingField& field, AcquisitionSettings& settings, const Json& json) {
  if (json.is_boolean()) return setValue(field, settings, json.get<bool>());
  if (json.is_number_unsigned()) return setValue(field, settings, json.get<std::uint64_t>());
  if (json.is_number()) return setValue(field, settings, json.get<double>());
  if (!json.is_string()) throw InvalidInput(std::string(field.key) + " is no value, expected " + expectationOf(field));
  const auto& text = json.get_ref<const std::string&>();
  if (field.automatic) return setText(field, settings, text);
  setValue(field, settings, text);
}

void setAll(AcquisitionSettings& settings, const Json& json, const std::string& what) {
  try {
    for (const auto& [name, value] : json.items()) setJson(settingField(keyOf(name)), settings, value);
  } catch (const InvalidInput& e) {
    throw InvalidInput(what + ": " + e.what());
  }
}

void checkComplete(const Json& json, const std::string& what) {
  std::set<std::string_view> named;
  for (const auto& item : json.items()) named.insert(keyOf(item.key()));
  for (const std::string_view key : kAlwaysNamed)
    if (!named.contains(key)) throw InvalidInput(what + " is damaged: it does not say " + std::string(key));
}

// Settings are a flat list.
Json parsedOptions(const std::string& text, const std::string& what) {
  const auto flat = [&](int depth, Json::parse_event_t /*event*/, Json& /*value*/) {
    if (depth > 2) throw InvalidInput(what + ": is nested, expected one JSON object of keys and values");
    return true;
  };
  Json json;
  try {
    json = Json::parse(text, flat);
  } catch (const Json::exception&) {
    throw InvalidInput(what + ": is no JSON, expected one object of keys and values");
  }
  if (!json.is_object()) throw InvalidInput(what + ": is no JSON object, expected one of keys and values");
  return json;
}

}  // namespace

nlohmann::ordered_json settingsJson(const AcquisitionSettings& settings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const SettingField& field : settingFields()) json[std::string(field.key)] = jsonOf(field, settings);
  return json;
}

AcquisitionSettings settingsFromJson(const Json& json, const std::string& what) {
  if (!json.is_object()) throw InvalidInput(what + " is damaged: its settings are no JSON object");
  checkComplete(json, what);
  AcquisitionSettings settings = settingsBefore();
  setAll(settings, json, what);
  return settings;
}

std::string optionsText(const AcquisitionSettings& settings) {
  nlohmann::ordered_json json = settingsJson(settings);
  for (const SettingField& field : settingFields())
    if (field.audience == SettingAudience::Session) json.erase(std::string(field.key));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

AcquisitionSettings withOptions(AcquisitionSettings settings, const std::string& text, const std::string& what) {
  setAll(settings, parsedOptions(text, what), what);
  return settings;
}

AcquisitionSettings readOptions(const std::string& path, AcquisitionSettings settings) {
  const FileBytes file(path, kMostBytes);
  settings = withOptions(std::move(settings), std::string(file.text()), path);
  checkSettings(settings);
  return settings;
}

void writeOptions(const std::string& path, const AcquisitionSettings& settings) {
  AtomicFile file(path);
  file.write(optionsText(settings));
  file.commit();
}

}  // namespace vantage
