#pragma once

#include <memory>
#include <vector>

#include "planning/planning_scene.h"

namespace vantage::testing {

/// A head at x = 300 looking along -x over a 200 mm square, receiver 60 mm to its right (toward +y); a turntable of 4.
[[nodiscard]] ScannerProfile flatScanner();

/// Mean sample spacing of the scenes below [mm]: lines of sight begin 0.3 mm in front of a surface and do not mind what
/// is nearer than 0.6 mm.
inline constexpr double kSceneSpacing = 1.2;

/// A scene with these patches behind these obstacles.
/// @param taken T_object_scanner of the views so far; without any, there is one that sees nothing
[[nodiscard]] std::unique_ptr<const PlanningScene> sceneOf(const ScannerProfile& profile, const Mesh& obstacles,
                                                           const std::vector<VoidPatch>& patches,
                                                           const std::vector<Pose>& taken = {},
                                                           const PlannerOptions& options = {});

/// Three spheres grown together, nothing about them symmetric, scanned with a little noise from positions of a coarse
/// scanner with a turntable of 24 steps that turns without error.
struct ScannedObject {
  std::shared_ptr<const ScannerProfile> profile;
  std::vector<View> views;
  std::shared_ptr<const Model> model;

  explicit ScannedObject(const std::vector<int>& positions);
  /// With all positions taken, and the scanner at the last of them.
  [[nodiscard]] PlanInput input() const;
};

}  // namespace vantage::testing
