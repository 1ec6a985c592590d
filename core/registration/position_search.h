#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "registration/icp.h"

namespace vantage {

/// The pose among many that a view fits: those where the most of the model meets the view are registered, and the first
/// that is good, or would be with more overlap, tells where the view is; the candidate nearest to that counts. Nothing
/// where none is.
/// @param candidates T_object_scanner each
/// @throws InvalidInput as registerView, Cancelled
[[nodiscard]] std::optional<std::size_t> poseThatFits(const ViewSurface& surface, std::span<const Pose> candidates,
                                                      const RegistrationTarget& model, const IcpOptions& options,
                                                      const Progress& progress = {});

}  // namespace vantage
