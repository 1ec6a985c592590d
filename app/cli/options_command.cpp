#include <memory>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_json.h"
#include "acquisition/settings_table.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/settings_arguments.h"
#include "io/output_file.h"

namespace vantage {
namespace {

struct OptionsArguments {
  std::string session;
  std::string write;
  SettingsArguments settings;
};

nlohmann::ordered_json fieldJson(const SettingField& field, const nlohmann::ordered_json& values) {
  const std::string key(field.key);
  nlohmann::ordered_json json{{"key", key},
                              {"value", values[key]},
                              {"default", textOf(field, {})},
                              {"expected", expectationOf(field)},
                              {"unit", field.unit},
                              {"help", field.help},
                              {"group", groupLabel(groupOf(field))},
                              {"expert", field.audience == SettingAudience::Expert}};
  if (field.most > field.least) json.update({{"least", field.least}, {"most", field.most}});
  return json;
}

// A line "key=value" can be given to --set as it is.
std::string fieldText(const SettingField& field, const AcquisitionSettings& settings) {
  const std::string value = textOf(field, settings);
  std::string text =
      std::string(field.key) + "=" + value + "\n    " + std::string(field.help) + " Expected " + expectationOf(field);
  if (const std::string usual = textOf(field, {}); usual != value) text += "; default " + usual;
  return text + ".\n";
}

std::string optionsListing(const AcquisitionSettings& settings) {
  std::string text;
  std::string_view group = "none";
  for (const SettingField& field : settingFields()) {
    if (groupOf(field) != group) {
      group = groupOf(field);
      text.append(text.empty() ? "# " : "\n# ").append(groupLabel(group)).append("\n");
    }
    text += fieldText(field, settings);
  }
  return text;
}

void runOptions(const OptionsArguments& args, CommandContext& context) {
  AcquisitionSettings settings;
  if (!args.session.empty()) settings = readSession(args.session, context)->settings;
  settings = args.settings.applied(std::move(settings));
  nlohmann::ordered_json json{{"options", nlohmann::ordered_json::array()}};
  const nlohmann::ordered_json values = settingsJson(settings);
  for (const SettingField& field : settingFields()) json["options"].push_back(fieldJson(field, values));
  if (args.write.empty()) return context.result(json, optionsListing(settings));
  checkOutput(args.write, OutputKind::Json);
  writeOptions(args.write, settings);
  json["written"] = args.write;
  context.result(json, "written: " + args.write + "\n");
}

}  // namespace

void addOptionsCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<OptionsArguments>();
  CLI::App* command = app.add_subcommand("options", "List all options: keys, values, units, bounds and what they mean");
  command->add_option("session", args->session, "Session file whose options to list; the defaults when not given");
  command->add_option("--write", args->write, "File (JSON) to write the options to, for --options");
  args->settings.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runOptions(*args, context); });
}

}  // namespace vantage
