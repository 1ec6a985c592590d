#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "io/scan_reader.h"

namespace vantage {

/// What the command line says about range files: --unit, --frame, --up, --grid and --no-sample.
class ReadingArguments {
 public:
  /// Adds the options. This must outlive the command.
  void addTo(CLI::App& command);

  [[nodiscard]] const ScanReadingOptions& options() const { return options_; }

 private:
  ScanReadingOptions options_;
};

/// Millimetres in the unit of that name. @throws CLI::ValidationError when there is none
[[nodiscard]] double unitNamed(const std::string& text);

/// Scans of a scanner with a profile are in the unit that puts them on its rays: one that nobody said is asked for, not
/// guessed. @throws InvalidInput naming the file, the unit and the option
void requireSaidUnit(const std::vector<std::string>& files, const std::vector<ReadScan>& scans);

/// Lines that say as what files were read, one for all that were read alike.
[[nodiscard]] std::string readingLines(const std::vector<std::string>& files, const std::vector<ReadScan>& scans);

}  // namespace vantage
