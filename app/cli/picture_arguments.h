#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// What `render --surface` can be, in the order of ModelColouring.
[[nodiscard]] const std::vector<std::string>& renderedSurfaces();

/// Arguments of `render`.
struct RenderArguments {
  std::string session;
  std::string view = "model";
  std::optional<int> step;
  std::string out;
  std::string size = "1280x800";
  bool dark = false;
  std::string surface;

  /// Adds the command. It must outlive the parsing.
  CLI::App* addTo(CLI::App& app);
};

/// Arguments of `report`.
struct ReportArguments {
  std::string session;
  std::string out;

  /// Adds the command. It must outlive the parsing.
  CLI::App* addTo(CLI::App& app);
};

}  // namespace vantage
