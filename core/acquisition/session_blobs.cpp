#include "acquisition/session_blobs.h"

#include <zstd.h>

#include <array>
#include <cstdint>

#include "acquisition/blob.h"
#include "base/errors.h"

namespace vantage {
namespace {

constexpr int kCompressionLevel = 1;
// No column of a session grows larger than this when it is unpacked.
constexpr unsigned long long kMaxUnpacked = 4ULL << 30;

std::vector<std::byte> compressed(const std::vector<std::byte>& bytes) {
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kCompressionLevel);
  if (ZSTD_isError(size) != 0) throw Error(std::string("compressing failed: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

std::vector<std::byte> decompressed(std::span<const std::byte> packed, const std::string& what) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > kMaxUnpacked)
    throw InvalidInput(what + " is damaged: it is not a compressed block");
  std::vector<std::byte> bytes(size);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) != 0 || got != size) throw InvalidInput(what + " is damaged: it cannot be decompressed");
  return bytes;
}

std::vector<std::array<double, 3>> packed(const std::vector<Vec3>& points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(points.size());
  for (const Vec3& p : points) result.push_back({p.x(), p.y(), p.z()});
  return result;
}

std::vector<Vec3> unpacked(const std::vector<std::array<double, 3>>& points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const auto& p : points) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

}  // namespace

std::vector<std::byte> poseBlob(const Pose& pose) {
  BlobWriter writer;
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) writer.value(pose.matrix()(r, c));
  return writer.bytes();
}

Pose poseFromBlob(std::span<const std::byte> blob, const std::string& what) {
  BlobReader reader(blob, what);
  Pose pose = Pose::Identity();
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) pose.matrix()(r, c) = reader.value<double>();
  reader.finish();
  const Eigen::Matrix3d rotation = pose.linear();
  if (!pose.matrix().allFinite() || !(rotation * rotation.transpose()).isIdentity(1e-6))
    throw InvalidInput(what + " is damaged: it is not a rigid motion");
  return pose;
}

std::vector<std::byte> rangeBlob(const std::vector<float>& range) {
  BlobWriter writer;
  writer.list(range);
  return compressed(writer.bytes());
}

std::vector<float> rangeFromBlob(std::span<const std::byte> blob, const std::string& what) {
  const auto bytes = decompressed(blob, what);
  BlobReader reader(bytes, what);
  auto range = reader.list<float>();
  reader.finish();
  return range;
}

std::vector<std::byte> raysBlob(const RayGrid& rays) {
  std::vector<Vec3> origins;
  std::vector<Vec3> directions;
  std::vector<Vec3> receivers;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    origins.push_back(rays.ray(i).origin);
    directions.push_back(rays.ray(i).direction);
    for (const Vec3& r : rays.receivers(i)) receivers.push_back(r);
  }
  BlobWriter writer;
  for (const auto* list : {&origins, &directions, &receivers}) writer.list(packed(*list));
  return compressed(writer.bytes());
}

RayGrid raysFromBlob(int rows, int columns, int receiversPerRay, std::span<const std::byte> blob,
                     const std::string& what) {
  const auto bytes = decompressed(blob, what);
  BlobReader reader(bytes, what);
  const auto origins = unpacked(reader.list<std::array<double, 3>>());
  const auto directions = unpacked(reader.list<std::array<double, 3>>());
  auto receivers = unpacked(reader.list<std::array<double, 3>>());
  reader.finish();
  if (origins.size() != directions.size()) throw InvalidInput(what + " is damaged: rays without directions");
  std::vector<RangingRay> rays;
  rays.reserve(origins.size());
  for (std::size_t i = 0; i < origins.size(); ++i) rays.push_back({origins[i], directions[i]});
  return {rows, columns, std::move(rays), std::move(receivers), receiversPerRay};
}

std::vector<std::byte> modelBlob(const Model& model) {
  BlobWriter writer;
  writer.list(packed(model.mesh.vertices));
  writer.list(model.mesh.triangles);
  writer.list(model.confidence);
  writer.list(model.vertexView);
  writer.list(model.vertexSample);
  writer.list(model.triangleView);
  return compressed(writer.bytes());
}

Model modelFromBlob(std::span<const std::byte> blob, const std::string& what) {
  const auto bytes = decompressed(blob, what);
  BlobReader reader(bytes, what);
  Model model;
  model.mesh.vertices = unpacked(reader.list<std::array<double, 3>>());
  model.mesh.triangles = reader.list<Triangle>();
  model.confidence = reader.list<float>();
  model.vertexView = reader.list<std::uint32_t>();
  model.vertexSample = reader.list<std::uint32_t>();
  model.triangleView = reader.list<std::uint32_t>();
  reader.finish();
  const std::size_t vertices = model.mesh.vertices.size();
  bool whole = model.confidence.size() == vertices && model.vertexView.size() == vertices &&
               model.vertexSample.size() == vertices && model.triangleView.size() == model.mesh.triangles.size();
  for (const Triangle& t : model.mesh.triangles)
    for (const std::uint32_t v : t) whole = whole && v < vertices;
  for (const Vec3& v : model.mesh.vertices) whole = whole && v.allFinite();
  if (!whole) throw InvalidInput(what + " is damaged: its parts do not fit together");
  return model;
}

}  // namespace vantage
