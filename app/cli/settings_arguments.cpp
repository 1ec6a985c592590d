#include "cli/settings_arguments.h"

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_json.h"
#include "base/errors.h"

namespace vantage {
namespace {

// What speaks against a value; empty when nothing does.
std::string objection(const SettingField& field, const std::string& text) {
  try {
    AcquisitionSettings scratch;
    setText(field, scratch, text);
    return {};
  } catch (const InvalidInput& e) {
    return e.what();
  }
}

void assign(AcquisitionSettings& settings, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw InvalidInput("--set " + assignment + ": expected key=value, see vantage-cli options");
  setText(settingField(assignment.substr(0, equals)), settings, assignment.substr(equals + 1));
}

}  // namespace

void SettingsArguments::addTo(CLI::App& command) {
  command.add_option("--options", file_, "Settings from a file (JSON), see vantage-cli options")
      ->type_name("FILE.json");
  command.add_option("--set", assignments_, "A setting by its key, see vantage-cli options; may be repeated")
      ->type_name("key=value")
      ->allow_extra_args(false);
}

void SettingsArguments::addShorthand(CLI::App& command, const std::string& flag, std::string_view key) {
  const SettingField& field = settingField(key);
  const std::string name(key);
  const std::string help(field.help);
  if (field.kind == SettingField::Kind::Switch) {
    command.add_flag_callback(
        flag, [this, name] { shorthands_.emplace_back(name, "true"); }, help);
    return;
  }
  command
      .add_option_function<std::string>(
          flag, [this, name](const std::string& text) { shorthands_.emplace_back(name, text); },
          help + " [" + expectationOf(field) + "]")
      ->type_name("VALUE")
      ->default_str(textOf(field, {}))
      ->check([&field](const std::string& text) { return objection(field, text); });
}

AcquisitionSettings SettingsArguments::applied(AcquisitionSettings settings) const {
  try {
    if (!file_.empty()) settings = readOptions(file_, std::move(settings));
    for (const auto& [key, value] : shorthands_) setText(settingField(key), settings, value);
    for (const std::string& assignment : assignments_) assign(settings, assignment);
    checkSettings(settings);
  } catch (const InvalidInput& e) {
    throw CLI::ValidationError(e.what());
  }
  return settings;
}

AcquisitionSettings SettingsArguments::appliedToSession(const AcquisitionSettings& settings) const {
  AcquisitionSettings changed = applied(settings);
  try {
    checkChange(settings, changed);
  } catch (const InvalidInput& e) {
    throw CLI::ValidationError(e.what());
  }
  return changed;
}

}  // namespace vantage
