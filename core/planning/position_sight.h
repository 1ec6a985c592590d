#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "integration/model.h"
#include "planning/visibility.h"
#include "void_space/void_patch.h"

namespace vantage {

inline constexpr std::size_t kVisibilities = 5;

/// What one position makes of one void patch.
struct PatchSight {
  Visibility visibility = Visibility::OutOfReach;
  double cosine = 0.0;               ///< between the patch's normal and the direction to the light source
  std::uint32_t blocker = kNoIndex;  ///< triangle of the model that blocks the light or the (first) receiver
};

/// What one position makes of all void patches: the reasons behind its o_v.
struct PositionSight {
  std::vector<PatchSight> patches;                  ///< one per void patch, in order
  std::array<std::size_t, kVisibilities> counts{};  ///< patches by Visibility
  std::array<double, kVisibilities> areas{};        ///< sum of their weights [mm^2]

  [[nodiscard]] std::size_t count(Visibility v) const { return counts[static_cast<std::size_t>(v)]; }
  [[nodiscard]] double area(Visibility v) const { return areas[static_cast<std::size_t>(v)]; }
};

/// Looks at every patch from one pose with the scanner's own rays, as the planner does when it traces a position.
/// @param spacing mean sample spacing of the views; the lines of sight keep a share of it away from the surface [mm].
/// @throws InvalidInput when the spacing is not positive; Cancelled
[[nodiscard]] PositionSight lookFrom(const Pose& T_object_scanner, std::span<const VoidPatch> patches,
                                     const Model& model, const ScannerProfile& profile, double spacing,
                                     const Progress& progress);

}  // namespace vantage
