#pragma once

#include <cstdint>

#include "base/content_hash.h"
#include "geometry/mesh.h"
#include "geometry/region.h"

namespace vantage {

/// The three coordinates as one run of bytes.
void addPoint(ContentHash& hash, const Vec3& point);

/// The first three rows of the matrix, one number after the other.
void addPose(ContentHash& hash, const Pose& pose);

/// Everything that a region is, with its kind.
void addRegion(ContentHash& hash, const Region& region);

/// Of positions and triangles.
[[nodiscard]] std::uint64_t contentHash(const Mesh& mesh);

}  // namespace vantage
