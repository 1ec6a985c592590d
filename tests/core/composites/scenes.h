#pragma once

#include <memory>
#include <vector>

#include "composites/composite_model.h"
#include "geometry/mesh.h"
#include "scanner/profile.h"

namespace vantage::testing {

/// A coarse rotating stripe scanner with a turntable of 24 positions: about 2.5 mm between samples.
[[nodiscard]] std::shared_ptr<const ScannerProfile> standProfile();

/// About 80 mm across, with no symmetry: balls of three sizes grown into a block.
[[nodiscard]] Mesh makeOddBody();

/// A straight prism of 64 sides about z, 70 mm high: as good as a cylinder for a coarse scanner.
[[nodiscard]] Mesh makeRoundBar();

/// How a body stands that rests on one of its faces, turned about the vertical, its centroid on the axis.
/// @param face of its resting faces, the likeliest first
[[nodiscard]] Pose standOn(const Mesh& body, std::size_t face, double turn);

/// A stand of a body, scanned from positions evenly spread around it with noise, all poses true; merged.
[[nodiscard]] Composite acquireStand(const Mesh& body, const Pose& T_table_body, int views = 8, unsigned seed = 1);

/// Two stands of the odd body with the true pose of one in the other.
struct TwoStands {
  Pose T_reference_moved = Pose::Identity();
  CompositeModel reference;
  CompositeModel moved;
};
/// Made once.
[[nodiscard]] const TwoStands& oddBodyInTwoStands();

/// How far two poses of a composite are apart, RMS over its points [mm].
[[nodiscard]] double poseError(const CompositeModel& composite, const Pose& a, const Pose& b);

}  // namespace vantage::testing
