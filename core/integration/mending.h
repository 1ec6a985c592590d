#pragma once

#include <cstddef>
#include <span>

#include "base/progress.h"
#include "integration/model.h"
#include "integration/zipper_options.h"
#include "scanner/view.h"

namespace vantage {

struct MendedModel {
  Model model;
  std::size_t crumbTriangles = 0;  ///< removed: see removeCrumbs
  std::size_t holesClosed = 0;     ///< see closeMeasuredHoles
};

/// A model that all its views are in, tidied up: crumbs go, and openings between views are closed where the views have
/// measured surface. Holes that no view sees stay. What is left is manifold and oriented as before; vertices are
/// samples, and stay where they are.
/// @param views by the model's provenance.
/// @pre no bow ties
/// @throws InvalidInput when a view lacks its pieces; Cancelled
[[nodiscard]] MendedModel mend(const Model& model, std::span<const View> views, const ZipperOptions& options,
                               const Progress& progress = {});

}  // namespace vantage
