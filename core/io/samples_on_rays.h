#pragma once

#include <memory>
#include <vector>

#include "base/progress.h"
#include "scanner/range_image.h"

namespace vantage {

/// Points that were put on the rays of a scanner.
struct SamplesOnRays {
  RangeImage image;         ///< on the scanner's rays
  std::size_t outside = 0;  ///< points that no ray comes near
  std::size_t hidden = 0;   ///< points behind others as the scanner sees them
};

/// Every point goes to the ray that it is nearest to. Of several on one ray those at the front count, and of these the
/// one nearest to the ray. Where points lie beside their rays, the range is that of the surface between them, as far as
/// neighbours tell.
/// @param points in scanner coordinates [mm]
/// @param colours per point, or none
/// @throws Cancelled
[[nodiscard]] SamplesOnRays samplesOnRays(const std::vector<Vec3>& points, const std::vector<Colour>& colours,
                                          const std::shared_ptr<const RayGrid>& rays, const Progress& progress = {});

}  // namespace vantage
