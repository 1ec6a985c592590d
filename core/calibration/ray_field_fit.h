#pragma once

#include <span>

#include "calibration/grid_samples.h"

namespace vantage {

/// Rays that change smoothly over the grid and lie on the samples best: across `sight` they are where
/// a(row, column) + depth * b(row, column) is, with polynomials of the third degree. Cells far from any with samples
/// are extrapolated.
/// @param sight unit, about where the scanner looks
/// @param standoff how far before the nearest sample the rays begin [mm]
/// @throws InvalidInput when there are fewer than 100 samples
[[nodiscard]] RayGrid fitRayField(std::span<const GridSample> samples, int rows, int columns, const Vec3& sight,
                                  double standoff);

}  // namespace vantage
