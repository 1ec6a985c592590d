#include "planning/plan_images.h"

#include "planning/objective.h"
#include "planning/planning_surface.h"

namespace vantage {

PlanImages computePlanImages(const PlanningScene& scene, const ScannerImages& images, const Progress& progress) {
  const Mesh overlapping = withoutBorder(scene.surface(), scene.options().borderRings);
  PlanImages result;
  result.voids = voidImage(scene, images, progress.part(0.0, 0.5));
  result.seen = overlapImage(scene, surfaceElements(overlapping, scene.options().planningTriangles), images,
                             progress.part(0.5, 1.0));
  return result;
}

}  // namespace vantage
