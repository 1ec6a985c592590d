#pragma once

#include <optional>

#include "planning/patch_outlook.h"
#include "planning/visibility.h"
#include "void_space/void_patch.h"

namespace vantage {

/// The largest angle between a patch's normal and a view that looks through it [rad]. The patch of a regular edge
/// continues the surface, and the breakdown angle holds for it. Where a jump in range tore the surface, or the border
/// of what the scanner samples, the patch is an opening into the unseen: what stands behind it may face anywhere, so
/// only views along the patch see nothing of it.
[[nodiscard]] double widestLook(const VoidPatch& patch, double breakdownAngle);

/// Looks at a patch up to `widestLook`.
/// @param breakdownAngle unset: up to the breakdown angle of `sight`, the objective of the paper.
[[nodiscard]] Sight lookAt(const SightTest& sight, const Pose& T_object_scanner, const VoidPatch& patch,
                           std::optional<double> breakdownAngle);

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
