#pragma once

#include <functional>
#include <memory>
#include <string>

#include "integration/model.h"
#include "scanner/profile.h"
#include "scanner/view.h"

namespace vantage::testing {

/// A stripe scanner whose rays run along -x through a 1 mm raster of 61 x 61 places, y in [-30, 30], z in [20, 80],
/// from x = 300, on a turntable of 36 steps. Breakdown angle 60 degrees.
/// @param receiver [right, up, forward] as in a profile, "" for none.
[[nodiscard]] std::shared_ptr<const ScannerProfile> parallelScanner(const std::string& receiver = "");

/// A vertical sheet facing +x, between two values of y and from z = 0 to 100.
[[nodiscard]] Mesh makePlate(double x, double yMin, double yMax);

/// The near plate (x = 20, up to y = 0) of a step in front of the far one (x = -20). Both end between two rays.
[[nodiscard]] Mesh makeStep();

/// An ideal scan from a workspace position at its true pose.
[[nodiscard]] View scanView(const Mesh& object, const std::shared_ptr<const ScannerProfile>& profile, int position = 0);

/// The view without the samples that `lost` (given points in object coordinates) names.
[[nodiscard]] View without(const View& view, const std::function<bool(const Vec3&)>& lost);

/// The partial model that a single view, number 0, makes.
[[nodiscard]] Model modelOf(const View& view);

}  // namespace vantage::testing
