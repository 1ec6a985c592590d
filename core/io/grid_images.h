#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/turn_grid.h"
#include "scanner/range_image.h"

namespace vantage {

// Range images of grids whose samples are in millimetres. The samples are reproduced but for single precision of the
// range; the rays of empty cells lie where the grid would have them.

/// Of a scanner that looks about along `sight` (see reconstructRays).
/// @param standoff how far before the nearest sample the rays begin [mm].
[[nodiscard]] RangeImage imageAlong(const SampleGrid& grid, const Vec3& sight, double standoff);

/// Of a scanner at the origin that turns about z.
[[nodiscard]] RangeImage imageFromOrigin(const SampleGrid& grid, const TurnSight& turn);

/// Of a scanner that looked at an axis from all around: as views of an eighth more than a quarter of the turn on either
/// side, so that every view sees its surface from outside and neighbours overlap.
[[nodiscard]] std::vector<RangeImage> imagesOfTurn(const SampleGrid& grid, const TurnSight& turn, double standoff);

/// Why samples do not lie on rays.
struct OffRays {
  std::size_t cell = 0;
  double aside = 0.0;  ///< [mm]
};

/// Taken with known rays, of as many rows and columns: samples may lie 1 mm or a hundredth of their range beside them.
/// @param off what is said when they do not; the image then has no rays.
[[nodiscard]] RangeImage imageOnRays(const SampleGrid& grid, const std::shared_ptr<const RayGrid>& rays, OffRays& off);

}  // namespace vantage
