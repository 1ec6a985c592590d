#pragma once

#include <optional>
#include <span>

#include "calibration/grid_samples.h"
#include "scanner/ray_patterns.h"

namespace vantage {

/// The depth camera whose rays the samples lie on best, z up: from a direct linear transform, refined by least squares
/// of the distances from the rays.
/// @return nothing when the samples tell no camera: too few, in one plane, mirrored, or looking straight up or down
[[nodiscard]] std::optional<Pinhole> fitPinhole(std::span<const GridSample> samples, int rows, int columns);

}  // namespace vantage
