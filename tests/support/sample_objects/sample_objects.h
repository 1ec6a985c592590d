#pragma once

#include "geometry/vectors.h"

// The objects that are shipped with the workstation, as distance fields [mm]: negative inside, z up, standing on z = 0,
// about the z axis.
namespace vantage::testing {

/// A mug, 80 mm wide and 95 mm tall, with a handle: a hole to look through, and an inside that only steep views reach.
[[nodiscard]] double mug(const Vec3& p);

/// A telephone handset, 190 mm long, lying on its side, with dished ear and mouth pieces.
[[nodiscard]] double handset(const Vec3& p);

/// A gargoyle with wings and horns that carries a candle cup, 150 mm tall: its parts hide one another from everywhere.
[[nodiscard]] double candleHolder(const Vec3& p);

}  // namespace vantage::testing
