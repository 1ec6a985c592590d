#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "planning/planning_scene.h"
#include "planning/planning_surface.h"
#include "positional_space/positional_image.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// P_v: the confidence-weighted area of the void patches that attract views from where they are seen, each by its
/// look-ahead factor, and of the model's triangles below the tolerance that would be sampled with at least the
/// tolerance (Pito 1999, eq. 2 and Appendix). Where the scene expects surface, P_v is new surface instead: the area of
/// the faces of the closing surface where they are seen, and of the patches their share, both corrected by the ledger
/// of the run. Every sighting is rounded to the unit of an image. Keeps the sightings of the patches.
[[nodiscard]] PositionalImage voidImage(const PlanningScene& scene, const ScannerImages& images,
                                        const Progress& progress);

/// Where expected surface would be seen: each face of the closing surface is a source, which its sightings go with.
/// @pre the scene expects surface
[[nodiscard]] PositionalImage expectedImage(const PlanningScene& scene, const ScannerImages& images,
                                            const Progress& progress);

/// P_s: the confidence-weighted area of the surface that a view could sample again (eq. 3).
/// @param seen elements of the scene's surface
[[nodiscard]] PositionalImage overlapImage(const PlanningScene& scene, std::span<const SurfaceElement> seen,
                                           const ScannerImages& images, const Progress& progress);

/// o_v(i) of every position, the intersection of P_v with P_c^i (eq. 5) [mm^2].
[[nodiscard]] std::vector<double> voidObjective(const PlanningScene& scene, const ScannerImages& images,
                                                const Progress& progress);

/// o_s(i) of every position, the intersection of P_s with P_c^i (eq. 5) [mm^2].
[[nodiscard]] std::vector<double> overlapObjective(const PlanningScene& scene, std::span<const SurfaceElement> seen,
                                                   const ScannerImages& images, const Progress& progress);

}  // namespace vantage
