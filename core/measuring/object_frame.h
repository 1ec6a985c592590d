#pragma once

#include <array>

#include "geometry/vectors.h"
#include "measuring/surface_plane.h"

namespace vantage {

// Frames to hand an object over in: poses T_out_object that take points of the object into them.

/// A base plane and a direction (3-2-1): the object stands on the plane z = 0, its front up, x runs from the first
/// point to the second as far as that lies in the plane, and the first point is above the origin.
/// @throws InvalidInput when the points are above each other
[[nodiscard]] Pose frameOnBase(const SurfacePlane& base, const Vec3& origin, const Vec3& along);

/// Three points of a surface: the first is the origin, the second lies on the x axis, the third in the plane z = 0 with
/// y above 0. @throws InvalidInput when they are on one line or not finite
[[nodiscard]] Pose frameFromPicks(const std::array<Vec3, 3>& points);

/// Only the base plane: turned as little as possible so that its front is up, z = 0 on it. What is above the origin
/// stays there as near as it can.
[[nodiscard]] Pose frameOnPlane(const SurfacePlane& base);

}  // namespace vantage
