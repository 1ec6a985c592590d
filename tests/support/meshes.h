#pragma once

#include "geometry/mesh.h"

namespace vantage::testing {

/// A flat rectangle in the plane z = 0 with its normal along +z, corner at the origin, of columns x rows squares.
[[nodiscard]] Mesh makeGrid(int columns, int rows, double spacing);

/// A closed sphere about `centre`: `rings` x 2*rings quads cut into triangles, outward oriented.
[[nodiscard]] Mesh makeSphere(double radius, int rings, const Vec3& centre = Vec3::Zero());

/// A closed axis-aligned box, each side cut into cells x cells squares, outward oriented, vertices shared.
[[nodiscard]] Mesh makeBox(const Vec3& min, const Vec3& max, int cells = 1);

/// Both meshes in one.
[[nodiscard]] Mesh joined(const Mesh& a, const Mesh& b);

}  // namespace vantage::testing
