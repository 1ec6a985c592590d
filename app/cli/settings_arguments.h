#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "acquisition/settings.h"

namespace vantage {

/// Settings on the command line: --options FILE.json, then shorthands of single settings, then --set key=value.
class SettingsArguments {
 public:
  /// Adds --options and --set. This must outlive the command.
  void addTo(CLI::App& command);

  /// Adds a flag for one setting, with help, bounds and default of the table: `--max-views N`, or `--ideal`.
  void addShorthand(CLI::App& command, const std::string& flag, std::string_view key);

  /// Whether nothing was said.
  [[nodiscard]] bool empty() const { return file_.empty() && shorthands_.empty() && assignments_.empty(); }

  /// The settings with what was said. @throws CLI::ValidationError for a setting that does not exist, cannot have that
  /// value or contradicts another; IoError when the file cannot be read.
  [[nodiscard]] AcquisitionSettings applied(AcquisitionSettings settings) const;

  /// The same for a session that has begun. @throws CLI::ValidationError also for a setting that it keeps.
  [[nodiscard]] AcquisitionSettings appliedToSession(const AcquisitionSettings& settings) const;

 private:
  std::string file_;
  std::vector<std::pair<std::string, std::string>> shorthands_;  // key, value
  std::vector<std::string> assignments_;                         // key=value
};

}  // namespace vantage
