#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "planning/planning_scene.h"
#include "scanner/sight.h"

namespace vantage {

inline constexpr std::size_t kVisibilities = 5;

/// What one position makes of one void patch.
struct PatchSight {
  Visibility visibility = Visibility::OutOfReach;
  double cosine = 0.0;               ///< between the patch's normal and the direction to the light source
  std::uint32_t blocker = kNoIndex;  ///< triangle of the scene's surface that blocks the light or the (first) receiver
};

/// What one position makes of all void patches: the reasons behind its o_v.
struct PositionSight {
  std::vector<PatchSight> patches;                  ///< one per void patch, in order
  std::array<std::size_t, kVisibilities> counts{};  ///< patches by Visibility
  std::array<double, kVisibilities> areas{};        ///< sum of their weights [mm^2]

  [[nodiscard]] std::size_t count(Visibility v) const { return counts[static_cast<std::size_t>(v)]; }
  [[nodiscard]] double area(Visibility v) const { return areas[static_cast<std::size_t>(v)]; }
};

/// Looks at every patch of the scene from one position with the scanner's own rays, as the planner does when it traces
/// the position.
/// @throws InvalidInput for a position that the workspace does not have; Cancelled
[[nodiscard]] PositionSight computePositionSight(const PlanningScene& scene, int position, const Progress& progress);

}  // namespace vantage
