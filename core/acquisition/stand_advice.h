#pragma once

#include <vector>

#include "acquisition/acquisition_state.h"
#include "base/progress.h"

namespace vantage {

/// A side that the object may be put on next, and what that would show.
struct StandAdvice {
  Vec3 down = -Vec3::UnitZ();              ///< unit, object coordinates: it points down then
  Pose T_object_table = Pose::Identity();  ///< about as it would stand, its centroid above the axis
  double gain = 0.0;    ///< void patches that the workspace shows then, weighted as those of a plan [mm^2]
  double share = 0.0;   ///< of all void patches, 0..1
  double margin = 0.0;  ///< least tilt that makes it fall over [rad]
  bool isNew = true;    ///< it has not stood, nor been put on about this side yet
};

/// What the void next to the model of the object comes to when it is turned over.
struct StandOutlook {
  std::vector<StandAdvice> sides;  ///< as adviseStands gives them
  double left = 0.0;               ///< void patches in all, weighted as those of a plan [mm^2]
  double hidden = 0.0;             ///< of them, what the workspace shows on no side [mm^2]
};
/// @throws Cancelled
[[nodiscard]] StandOutlook lookAtStands(const AcquisitionState& state, const Progress& progress = {});

/// The sides that the object can rest on, by the convex hull of what is known of it, ranked by what of the void next to
/// its model the workspace would show. Those that it stood on already come last. Nothing while the object has no model,
/// or one that spans no volume. Deterministic for any thread count.
/// @throws Cancelled
[[nodiscard]] std::vector<StandAdvice> adviseStands(const AcquisitionState& state, const Progress& progress = {});

}  // namespace vantage
