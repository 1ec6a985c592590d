#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scanner/profile.h"

namespace vantage {

class JsonObjectReader;

/// The object of a calibration file, which is also the `calibration` of a profile:
///   { "axis": { "point": [x, y, z], "direction": [x, y, z], "sigma_mm": 0, "sigma_deg": 0 },
///     "table_plane": [nx, ny, nz, d], "sense": 1, "degrees_per_commanded_degree": 1.0, "residual_mm": 0,
///     "verdict": "good" }
/// in scanner coordinates; direction and normal of any length, both away from the table to the side of the object.
[[nodiscard]] nlohmann::ordered_json calibrationJson(const TableCalibration& calibration);

/// @throws InvalidInput that names file, JSON pointer, value and what was expected; also for an axis that does not
/// stand on the table plane
[[nodiscard]] TableCalibration readCalibration(JsonObjectReader reader);

/// Reads a calibration file. @throws IoError when it cannot be read; InvalidInput as readCalibration
[[nodiscard]] TableCalibration loadCalibration(const std::string& path);

/// The text of a calibration file.
[[nodiscard]] std::string calibrationText(const TableCalibration& calibration);

/// The profile with the calibration in the place of the one that it may have: a session that stores the profile stores
/// it with it. Whether scanner and table fit together says parseProfile.
/// @throws InvalidInput when the source is no JSON object
[[nodiscard]] ProfileSource withCalibration(ProfileSource source, const TableCalibration& calibration);

}  // namespace vantage
