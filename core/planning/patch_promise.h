#pragma once

#include <cstddef>

#include "planning/planning_scene.h"
#include "scanner/sight.h"
#include "void_space/void_patch.h"

namespace vantage {

/// The largest angle between a patch's normal and a view that sees through it [rad]. The patch of a regular edge
/// continues the surface, and the breakdown angle holds for it. Where a jump in range tore the surface, or the border
/// of what the scanner samples, the patch is an opening into the unseen: what stands behind it may face anywhere, so
/// only views along the patch see nothing of it. Without look-ahead it is the breakdown angle for every patch: the
/// objective of the paper.
[[nodiscard]] double widestAngle(const PlanningScene& scene, const VoidPatch& patch);

/// What a scanner at a pose makes of one of the scene's patches, up to its `widestAngle`.
[[nodiscard]] Sight sightOf(const PlanningScene& scene, const Pose& T_table_scanner, std::size_t patch);

/// How much unseen surface stands behind a void patch, seen from one direction.
///
/// A patch is the front of an unseen region. If the surface curves away from the viewer beyond the edge, a view that
/// leans beyond it by the angle phi sees (theta_b + phi) of arc, one that looks back at it only (theta_b - phi); the
/// factor is that share of theta_b. 1 for a view along the patch's normal, which gives the objective of the paper.
[[nodiscard]] double lookAhead(const VoidPatch& patch, const Vec3& direction, double breakdownAngle);

/// What the weight of a patch counts for: all of it, or a share beside the expected surface, corrected by the run's
/// ledger.
[[nodiscard]] double patchShare(const PlanningScene& scene);

/// What a sight of a patch promises: weight times cosine times `lookAhead`, times `patchShare`, 0 when the patch is not
/// seen or does not attract a view like that [mm^2].
[[nodiscard]] double patchPromise(const PlanningScene& scene, std::size_t patch, const Sight& sight);

}  // namespace vantage
