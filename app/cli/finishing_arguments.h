#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "finishing/finished_model.h"
#include "scanner/length_unit.h"

namespace vantage {

/// What the command line says about how a model is handed over: --close-holes, --pieces, --max-triangles, --error,
/// --printable, --align and --units.
class FinishingArguments {
 public:
  /// Adds the options. This must outlive the command.
  void addTo(CLI::App& command);

  /// @throws InvalidInput when they contradict each other
  [[nodiscard]] FinishingOptions options() const;
  [[nodiscard]] LengthUnit unit() const;
  [[nodiscard]] bool printable() const { return printable_; }
  /// T_out_object; nothing when the object's own axes stay. @throws InvalidInput for points on one line
  [[nodiscard]] std::optional<Pose> frame() const;

 private:
  std::string close_;
  std::string leaveOut_;
  std::optional<std::size_t> maxTriangles_;
  std::optional<double> maxError_;
  bool printable_ = false;
  std::vector<std::string> align_;
  std::string unit_ = "mm";
};

/// @throws InvalidInput that says what keeps a model from being printed, and what may help
void requirePrintable(const FinishedModel& finished);

/// What was done to a model, as JSON.
[[nodiscard]] nlohmann::ordered_json finishingJson(const FinishedModel& finished);

/// Lines that say what was done to it.
[[nodiscard]] std::string finishingLines(const FinishedModel& finished);

}  // namespace vantage
