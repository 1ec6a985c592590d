#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// The report of an acquisition as the command line contract describes it, of what is known of the object: stands that
/// are not aligned have no part in its views and its model. Areas in mm^2, times in s. Only the members
/// "seconds" and "peak_memory_mb" depend on the machine.
[[nodiscard]] nlohmann::ordered_json makeReport(const AcquisitionState& state, const std::string& version);

/// A registration result: verdict, figures, and the weak direction.
[[nodiscard]] nlohmann::ordered_json registrationJson(const RegistrationResult& registration);

/// Void patches by edge class.
[[nodiscard]] nlohmann::ordered_json voidCountsJson(const VoidSurface& voids);

/// The same for a plan, and how many are answered.
[[nodiscard]] nlohmann::ordered_json voidJson(const Plan& plan);

/// What the forecasts of a plan are worth and, at the end, how much surface is believed to be left.
[[nodiscard]] nlohmann::ordered_json forecastJson(const PlanForecast& forecast);

/// Boundary that is left, by reason.
[[nodiscard]] nlohmann::ordered_json remainingJson(const Plan& plan);

/// What one position promises, with the constraint that bound it.
[[nodiscard]] nlohmann::ordered_json scoreJson(const PositionScore& score);

/// Counts of a model's mesh.
[[nodiscard]] nlohmann::ordered_json modelJson(const Mesh& mesh);

/// Largest memory that the process has held so far [MB].
[[nodiscard]] double peakMemory();

}  // namespace vantage
