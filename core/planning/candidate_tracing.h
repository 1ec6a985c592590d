#pragma once

#include <span>
#include <vector>

#include "planning/plan.h"
#include "planning/planning_scene.h"
#include "planning/planning_surface.h"

namespace vantage {

/// Follows the scanner's own rays from the position of the score to every patch, and to the expected surface where the
/// scene has one: fills in the traced void area and the patches it would see.
/// @throws InvalidInput for a position that the workspace does not have
void traceVoid(PositionScore& score, const PlanningScene& scene);

/// The surface elements that a position would sample again.
struct Overlap {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<double> areas;  ///< times the cosine of the view [mm^2]
};
/// @throws InvalidInput for a position that the workspace does not have
[[nodiscard]] Overlap traceOverlap(const PlanningScene& scene, int position, std::span<const SurfaceElement> elements);

/// Predicts how well the overlap of the score's position would fix its pose: fills in the error and its direction.
/// @param elements of the scene's surface
/// @throws InvalidInput for a position that the workspace does not have
void predictRegistration(PositionScore& score, const PlanningScene& scene, std::span<const SurfaceElement> elements);

}  // namespace vantage
