#pragma once

#include <optional>
#include <string>

#include "scanner/view.h"

namespace vantage {

/// The folder of recorded range images that the libraries compared with were measured on, VANTAGE_PERF_DATA; nothing
/// when it is not set.
[[nodiscard]] std::optional<std::string> recordedViewsFolder();

/// Reads a .rng file, a pinhole scanner's depth image with its true pose, and triangulates it.
/// @throws std::runtime_error when it cannot be read.
[[nodiscard]] View readRecordedView(const std::string& path, double breakdownAngle);

}  // namespace vantage
