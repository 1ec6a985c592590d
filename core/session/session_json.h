#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "acquisition/acquisition_state.h"
#include "acquisition/command.h"

namespace vantage {

/// The columns of a session file that are JSON text, so that they can be read with any tool. Numbers come back to the
/// last bit; what is infinite is null. Readers take nothing on trust: @throws InvalidInput naming `what`.
[[nodiscard]] std::string settingsText(const AcquisitionSettings& settings);
[[nodiscard]] AcquisitionSettings settingsFromText(const std::string& text, const std::string& what);

/// What a command says beyond its kind (see kindOf).
[[nodiscard]] std::string commandText(const Command& command);
[[nodiscard]] Command commandFromText(std::string_view kind, const std::string& text, const std::string& what);

/// A record without its plan.
[[nodiscard]] std::string recordText(const ViewRecord& record);
[[nodiscard]] ViewRecord recordFromText(const std::string& text, const std::string& what);

/// A plan's decision and the scores of all positions; what is per patch is in planBlob.
[[nodiscard]] std::string planText(const Plan& plan);
[[nodiscard]] Plan planFromText(const std::string& text, const std::string& what);

[[nodiscard]] Termination terminationFromName(std::string_view text, const std::string& what);

}  // namespace vantage
