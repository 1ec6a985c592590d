#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "acquisition/acquisition_state.h"
#include "base/progress.h"

namespace vantage {

/// The files that an automatic run leaves in a folder: report.json, model.ply and model.stl.
class AcquisitionResults {
 public:
  explicit AcquisitionResults(std::string folder) : folder_(std::move(folder)) {}

  /// @throws InvalidInput when one of them is there already
  void mustBeNew() const;
  /// @throws InvalidInput when one of them is there and may not be replaced (see checkOutput)
  void mustBeReplaceable(const std::vector<std::string>& inputs) const;
  /// The model as PLY in the colours of its scans, where they have some. @throws IoError, Cancelled
  void write(const AcquisitionState& state, const nlohmann::ordered_json& report, const Progress& progress) const;

  [[nodiscard]] std::string file(const char* name) const;

 private:
  std::string folder_;
};

}  // namespace vantage
