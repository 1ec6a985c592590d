#pragma once

#include <cstdint>
#include <optional>

#include "geometry/mesh.h"

namespace vantage {

/// How an object comes to stand that somebody turns over by hand: on the resting face that is nearest to the side that
/// was meant, turned about z at random, a few millimetres beside the axis. Depends on its arguments only.
/// @param object as it stands in stand 0, which it leaves as it is
/// @param down the side that was meant, the unit vector that points down, object coordinates; nothing: any
/// @return T_table_object
/// @throws InvalidInput for an object without a volume
[[nodiscard]] Pose simulatedStand(const Mesh& object, const std::optional<Vec3>& down, int stand, std::uint64_t seed);

}  // namespace vantage
