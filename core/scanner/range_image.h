#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanner/mechanics.h"
#include "scanner/ray_grid.h"
#include "scanner/station.h"

namespace vantage {

/// Red, green and blue, 0..255.
using Colour = std::array<std::uint8_t, 3>;

/// One scan: a distance for every ranging ray, and where the scanner stood relative to the table. The table turns with
/// the object: while the object keeps its stand, moving the table moves the scanner about it.
struct RangeImage {
  std::shared_ptr<const RayGrid> rays;  ///< scanner coordinates
  std::vector<float> range;             ///< rays->size() distances along the rays [mm]; NaN where nothing was measured
  Pose T_table_scanner = Pose::Identity();  ///< as it was reached, before any registration
  PoseSource poseKnownBy = PoseSource::Unknown;
  /// How far that may be off; nothing where only the scanner's profile says something.
  std::optional<Mechanics> poseUncertainty;
  Station station;
  std::string takenWith;        ///< the devices, as they name themselves; empty where that is not known
  std::vector<Colour> colours;  ///< of the samples, one per ray; empty where the sensor sees none

  [[nodiscard]] bool valid(std::size_t i) const { return !std::isnan(range[i]); }

  /// The sample in scanner coordinates. @pre valid(i)
  [[nodiscard]] Vec3 point(std::size_t i) const {
    const RangingRay& ray = rays->ray(i);
    return ray.origin + static_cast<double>(range[i]) * ray.direction;
  }

  [[nodiscard]] std::size_t sampleCount() const;
};

inline constexpr float kNoSample = std::numeric_limits<float>::quiet_NaN();

/// @throws InvalidInput when the range image has no rays, the wrong number of distances, an infinite or a negative
/// distance, or a pose that is not a rigid motion.
void validate(const RangeImage& image);

}  // namespace vantage
