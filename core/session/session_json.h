#pragma once

#include <string>
#include <string_view>

#include "acquisition/history.h"

namespace vantage {

/// The columns of a session file that are JSON text, so that they can be read with any tool. Numbers come back to the
/// last bit; what is infinite is null. Readers take nothing on trust: @throws InvalidInput naming `what`.
[[nodiscard]] std::string settingsText(const AcquisitionSettings& settings);
[[nodiscard]] AcquisitionSettings settingsFromText(const std::string& text, const std::string& what);

/// The stands as a list of poses T_object_table (12 numbers; null: not known) with what came of their alignments, and
/// the models that are set aside.
[[nodiscard]] std::string standsText(const std::vector<Stand>& stands, const std::vector<OutlinedModel>& aside = {});
[[nodiscard]] std::vector<Stand> standsFromText(const std::string& text, const std::string& what);
[[nodiscard]] std::vector<OutlinedModel> asideFromText(const std::string& text, const std::string& what);

/// What a scan brought, without its plan, with its number and where it was taken.
[[nodiscard]] std::string recordText(const OutlinedScan& scan);
[[nodiscard]] ScanRecord recordFromText(const std::string& text, const std::string& what);

/// A plan's decision and the scores of all positions; what is per patch is in planBlob.
[[nodiscard]] std::string planText(const Plan& plan);
[[nodiscard]] Plan planFromText(const std::string& text, const std::string& what);

/// Enumerators by their names.
[[nodiscard]] Termination terminationFromName(std::string_view text, const std::string& what);
[[nodiscard]] Mode modeFromName(std::string_view text, const std::string& what);
[[nodiscard]] ScanStatus scanStatusFromName(std::string_view text, const std::string& what);
[[nodiscard]] PoseSource poseSourceFromName(std::string_view text, const std::string& what);

}  // namespace vantage
