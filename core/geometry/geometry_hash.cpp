#include "geometry/geometry_hash.h"

namespace vantage {
namespace {

void addKind(ContentHash& hash, const BelowPlane& region) {
  addPoint(hash, region.point);
  addPoint(hash, region.normal);
}

void addKind(ContentHash& hash, const OrientedBox& region) {
  addPose(hash, region.T_region_box);
  addPoint(hash, region.size);
}

void addKind(ContentHash& hash, const Prism& region) {
  addPose(hash, region.T_region_eye);
  hash.add(region.perspective);
  for (const Vec2& corner : region.corners) {
    hash.add(corner.x());
    hash.add(corner.y());
  }
  hash.add(region.nearest);
  hash.add(region.farthest);
}

void addKind(ContentHash& hash, const NearPoints& region) {
  for (const Vec3& point : region.points) addPoint(hash, point);
  hash.add(region.radius);
}

}  // namespace

void addPoint(ContentHash& hash, const Vec3& point) {
  hash.add(std::as_bytes(std::span(point.data(), 3)));
}

void addPose(ContentHash& hash, const Pose& pose) {
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) hash.add(pose.matrix()(r, c));
}

void addRegion(ContentHash& hash, const Region& region) {
  hash.add(static_cast<std::uint64_t>(region.index()));
  std::visit([&](const auto& r) { addKind(hash, r); }, region);
}

std::uint64_t contentHash(const Mesh& mesh) {
  ContentHash hash;
  for (const Vec3& v : mesh.vertices) addPoint(hash, v);
  hash.add(mesh.triangles);
  return hash.value();
}

}  // namespace vantage
