#pragma once

#include <cstdint>

#include "base/content_hash.h"
#include "geometry/mesh.h"

namespace vantage {

/// The three coordinates as one run of bytes.
void addPoint(ContentHash& hash, const Vec3& point);

/// The first three rows of the matrix, one number after the other.
void addPose(ContentHash& hash, const Pose& pose);

/// Of positions and triangles.
[[nodiscard]] std::uint64_t contentHash(const Mesh& mesh);

}  // namespace vantage
