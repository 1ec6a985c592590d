#pragma once

#include <span>

#include "composites/composite_model.h"

namespace vantage {

/// A point that a person picked on both composites, each in its own coordinates [mm].
struct PickedPair {
  Vec3 reference = Vec3::Zero();
  Vec3 moved = Vec3::Zero();
};

/// The pose that brings three or more picked points together best (least squares), each snapped to its composite's
/// surface first.
/// @throws InvalidInput for fewer than three pairs, for points that are not finite, and for points on a line, which
/// leave a turn open.
[[nodiscard]] Pose poseOfPairs(const CompositeModel& reference, const CompositeModel& moved,
                               std::span<const PickedPair> pairs);

}  // namespace vantage
