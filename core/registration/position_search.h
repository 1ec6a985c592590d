#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "registration/icp.h"

namespace vantage {

/// Where a view was found among many poses.
struct FittingPose {
  std::size_t candidate = 0;  ///< the nearest to where it was found
  RegistrationResult registration;
  double rivalDistance = 0.0;     ///< how far off another of the poses that were tried is good as well [mm]; 0: none
  std::vector<Pose> rivals = {};  ///< T_object_scanner of each of those
};

/// The pose among many that a view fits: those where the most of the model meets the view are registered, and the first
/// that is good, or would be with more overlap, or is held by the prior where the surface lets go of a motion, tells
/// where the view is. Nothing where none is.
/// @param candidates T_object_scanner each
/// @param tried so many of the best candidates are registered
/// @throws InvalidInput as registerView, Cancelled
[[nodiscard]] std::optional<FittingPose> poseThatFits(const ViewSurface& surface, std::span<const Pose> candidates,
                                                      const RegistrationTarget& model, const IcpOptions& options,
                                                      const Progress& progress = {}, std::size_t tried = 4);

}  // namespace vantage
