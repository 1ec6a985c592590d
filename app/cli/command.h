#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "cli/progress_bar.h"
#include "report/warnings.h"

namespace vantage {

/// Something to know about a result.
struct Remark {
  std::string code;
  std::string text;
  std::optional<std::size_t> scan;  ///< that it is about, from 0
  bool serious = false;             ///< the work was done, but not all is well
};

/// What every subcommand shares: its common options, and where progress and results go.
class CommandContext {
 public:
  /// @param arguments that the program was started with, without its name
  explicit CommandContext(std::stop_token stop, std::vector<std::string> arguments = {});

  /// Adds --json and --threads.
  void addCommonOptions(CLI::App& command);

  /// A progress that draws the bar, stops on signals and runs on the threads asked for.
  [[nodiscard]] Progress progress();

  /// Prints the result: as one JSON object with --json, otherwise `text`.
  void result(const nlohmann::ordered_json& json, const std::string& text);
  /// The same of an acquisition. Warnings are said; with a serious one the program ends with the code "done, but".
  void result(nlohmann::ordered_json json, const std::string& text, const std::vector<Warning>& warnings);
  /// The same of other work.
  void result(nlohmann::ordered_json json, const std::string& text, const std::vector<Remark>& remarks);

  /// Whether the work was done, but not all is well.
  [[nodiscard]] bool warned() const { return warned_; }

  /// From now on standard output belongs to events: results are said on stderr.
  void keepForEvents() { events_ = true; }

  /// One line for the operator, on stderr.
  void note(const std::string& line);

  [[nodiscard]] bool json() const { return json_; }
  [[nodiscard]] int threads() const { return threads_; }
  [[nodiscard]] const std::vector<std::string>& arguments() const { return arguments_; }
  [[nodiscard]] std::stop_token stop() const { return stop_; }

 private:
  std::stop_token stop_;
  std::vector<std::string> arguments_;
  ProgressBar bar_;
  bool json_ = false;
  bool events_ = false;
  bool warned_ = false;
  int threads_;
};

/// Each adds its subcommand; the work runs in the callback and throws what goes wrong.
void addAcquireCommand(CLI::App& app, CommandContext& context);
void addResumeCommand(CLI::App& app, CommandContext& context);
void addStepCommand(CLI::App& app, CommandContext& context);
void addTakeCommand(CLI::App& app, CommandContext& context);
void addEraseCommand(CLI::App& app, CommandContext& context);
void addImportCommand(CLI::App& app, CommandContext& context);
void addBatchCommand(CLI::App& app, CommandContext& context);
void addOptionsCommand(CLI::App& app, CommandContext& context);
void addPlanCommand(CLI::App& app, CommandContext& context);
void addExportCommand(CLI::App& app, CommandContext& context);
void addMeasureCommand(CLI::App& app, CommandContext& context);
void addInfoCommand(CLI::App& app, CommandContext& context);
void addDevicesCommand(CLI::App& app, CommandContext& context);
void addEvaluateCommand(CLI::App& app, CommandContext& context);
void addRenderCommand(CLI::App& app, CommandContext& context);
void addReportCommand(CLI::App& app, CommandContext& context);
void addCalibrateCommand(CLI::App& app, CommandContext& context);
void addStandCommand(CLI::App& app, CommandContext& context);
void addAlignCommand(CLI::App& app, CommandContext& context);
void addProfileCommand(CLI::App& app, CommandContext& context);

}  // namespace vantage
