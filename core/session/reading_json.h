#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scanner/scan_reading.h"
#include "session/json_fields.h"

namespace vantage {

/// As what a recorded scan was read, in codes and numbers.
[[nodiscard]] nlohmann::json readingJson(const ScanReading& reading);

/// Takes nothing on trust. @throws InvalidInput
[[nodiscard]] ScanReading readingFrom(const JsonFields& fields);

/// A list of readings, also as text.
[[nodiscard]] nlohmann::json readingsJson(const std::vector<ScanReading>& readings);
[[nodiscard]] std::vector<ScanReading> readingsFrom(const nlohmann::json& list, const std::string& what);

}  // namespace vantage
