#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/progress.h"
#include "integration/model.h"
#include "scanner/view.h"
#include "void_space/void_patch.h"

namespace vantage {

/// What a void patch counts for.
enum class PatchWeight : std::uint8_t {
  SpacingTimesLength,  ///< edge length x local sample spacing: does not depend on how the model is cut into triangles
  TriangleArea,        ///< area of the edge's triangle, as in the paper (5.2)
};
/// "spacing", "triangle".
[[nodiscard]] std::string_view name(PatchWeight weight);

struct VoidOptions {
  double breakdownAngle = radians(60.0);  ///< theta_b of the scanner [rad]
  /// How much deeper or nearer than the edge, in units of spacing * tan(theta_b), the surface beside it counts as a
  /// jump.
  double jumpFactor = 1.5;
  int shadowReach = 4;  ///< how many spacings beside an edge a shadow may begin that explains why nothing was sampled
  PatchWeight weight = PatchWeight::SpacingTimesLength;
  /// The frame of an edge uses the mean normal of the triangles within this many rings of its ends: the normal of a
  /// single triangle on a jagged border is mostly noise. 0 is the paper's: the edge's own triangle.
  int normalRings = 2;
};

/// The void patches of a partial model (Pito 1999, 4.3): one for each boundary edge e that has a length.
///
/// The map of free space about e begins with the verdict of r_1, the ray that sampled an endpoint of e (of two views
/// that of e's triangle, else the more confident one). The rays of the other views that see an endpoint follow in order
/// of their angle about e, then of their view, and are merged until one approaches e through space that is not known to
/// be free; a ray whose view measured e itself needs no such proof. The patch lies at theta_v, as wide as e and as deep
/// as the local sample spacing.
///
/// @param views in the order that model.vertexView counts in, at their registered poses.
/// @throws InvalidInput when the model's tables do not fit its mesh or the views, a view has no image or the
///         breakdown angle is not between 0 and 90 degrees; Cancelled
[[nodiscard]] VoidSurface buildVoidPatches(const Model& model, std::span<const View> views,
                                           const VoidOptions& options = {}, const Progress& progress = {});

}  // namespace vantage
