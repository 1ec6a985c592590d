#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "geometry/ray_caster.h"
#include "integration/model.h"
#include "planning/candidate_tracing.h"
#include "planning/patch_outlook.h"
#include "planning/plan.h"
#include "positional_space/positional_image.h"
#include "positional_space/scanner_images.h"

namespace vantage {

struct ObjectiveOptions {
  double breakdownAngle = radians(60.0);  ///< [rad]
  double tolerance = 0.0;                 ///< u: model triangles with less confidence count as void (Appendix); 0: off
  bool lookAhead = true;
  double surfaceOffset = 0.3;  ///< observation rays begin this far in front of what they observe [mm]
};

/// o_v(i) of every position: the confidence-weighted area of the void patches that it would see and that attract views
/// from there, each by its look-ahead factor, and of the triangles of `model` below the tolerance that it would sample
/// with at least the tolerance (Pito 1999, eq. 2, 5 and Appendix) [mm^2].
[[nodiscard]] std::vector<double> voidObjective(std::span<const VoidPatch> patches, const PatchHistory& history,
                                                const Model& model, const RayCaster& obstacles,
                                                const ScannerImages& images, const ObjectiveOptions& options,
                                                const Progress& progress);

/// o_s(i) of every position: the confidence-weighted area of the surface that it would sample again (eq. 3, 5) [mm^2].
[[nodiscard]] std::vector<double> overlapObjective(std::span<const SurfaceElement> seen, const RayCaster& obstacles,
                                                   const ScannerImages& images, const ObjectiveOptions& options,
                                                   const Progress& progress);

/// P_v and P_s, the images that the two objectives are sums over, to be looked at: their intersections with P_c^i are
/// o_v(i), to within the unit of an image per sighting, and o_s(i). The first keeps the sightings of the patches.
[[nodiscard]] PositionalImage voidImage(std::span<const VoidPatch> patches, const PatchHistory& history,
                                        const Model& model, const RayCaster& obstacles, const ScannerImages& images,
                                        const ObjectiveOptions& options, const Progress& progress);
[[nodiscard]] PositionalImage overlapImage(std::span<const SurfaceElement> seen, const RayCaster& obstacles,
                                           const ScannerImages& images, const ObjectiveOptions& options,
                                           const Progress& progress);

}  // namespace vantage
