#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "planning/patch_outlook.h"
#include "planning/plan.h"
#include "planning/visibility.h"

namespace vantage {

/// A piece of the model's surface that a view may re-sample.
struct SurfaceElement {
  Vec3 centre;
  Vec3 normal;  ///< unit
  double area;  ///< [mm^2]
};

/// Follows the scanner's own rays from one position to every patch: fills in the traced void area and the patches it
/// would see.
/// @param breakdownAngle for the look-ahead [rad]; unset: without it.
void traceVoid(PositionScore& score, const Pose& T_object_scanner, std::span<const VoidPatch> patches,
               const PatchHistory& history, const SightTest& sight, std::optional<double> breakdownAngle);

/// The surface elements that a position would sample again.
struct Overlap {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<double> areas;  ///< times the cosine of the view [mm^2]
};
[[nodiscard]] Overlap traceOverlap(const Pose& T_object_scanner, std::span<const SurfaceElement> elements,
                                   const SightTest& sight);

}  // namespace vantage
