#pragma once

#include <memory>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/ray_caster.h"
#include "scanner/profile.h"
#include "scanner/view.h"

namespace vantage::testing {

inline constexpr double kSphereRadius = 30.0;  ///< [mm]
[[nodiscard]] Vec3 sphereCentre();

/// A sphere above the table as an ideal camera on a turntable of 24 steps scanned it, and what it measured as one mesh.
struct ScannedSphere {
  std::shared_ptr<const ScannerProfile> profile;
  std::vector<View> views;
  Mesh model;
  double spacing = 0.0;  ///< [mm]

  explicit ScannedSphere(const std::vector<int>& positions);
};

}  // namespace vantage::testing
