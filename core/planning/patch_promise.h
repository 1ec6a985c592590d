#pragma once

#include <optional>

#include "planning/patch_outlook.h"
#include "planning/visibility.h"
#include "void_space/void_patch.h"

namespace vantage {

/// How much unseen surface stands behind a void patch, seen from one direction.
///
/// A patch is the front of an unseen region. If the surface curves away from the viewer beyond the edge, a view that
/// leans beyond it by the angle phi sees (theta_b + phi) of arc, one that looks back at it only (theta_b - phi); the
/// factor is that share of theta_b. 1 for a view along the patch's normal, which gives the objective of the paper.
[[nodiscard]] double lookAhead(const VoidPatch& patch, const Vec3& direction, double breakdownAngle);

/// What one look at a patch promises: weight times cosine times `lookAhead`, 0 when the patch is not seen or does not
/// attract a view like that [mm^2].
/// @param breakdownAngle for the look-ahead [rad]; unset: without it.
[[nodiscard]] double patchPromise(const VoidPatch& patch, std::size_t index, const PatchHistory& history,
                                  const Sight& sight, std::optional<double> breakdownAngle);

}  // namespace vantage
