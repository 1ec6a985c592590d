#include "geometry/geometry_hash.h"

namespace vantage {

void addPoint(ContentHash& hash, const Vec3& point) {
  hash.add(std::as_bytes(std::span(point.data(), 3)));
}

void addPose(ContentHash& hash, const Pose& pose) {
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) hash.add(pose.matrix()(r, c));
}

std::uint64_t contentHash(const Mesh& mesh) {
  ContentHash hash;
  for (const Vec3& v : mesh.vertices) addPoint(hash, v);
  hash.add(mesh.triangles);
  return hash.value();
}

}  // namespace vantage
