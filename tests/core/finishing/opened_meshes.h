#pragma once

#include <functional>

#include "geometry/mesh.h"

namespace vantage::testing {

/// A mesh without the triangles of which the centre is in a region; vertices keep their numbers.
[[nodiscard]] Mesh without(const Mesh& mesh, const std::function<bool(const Vec3&)>& region);

/// A sphere of 20 mm radius about the origin, its edges about 1 mm long, without its cap above a height.
[[nodiscard]] Mesh openedSphere(double above);

/// A tube about the z axis, open at both ends: 10 mm radius, 30 mm high, edges about 1 mm long.
[[nodiscard]] Mesh tube();

}  // namespace vantage::testing
