#include "session/session_blobs.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>

#include "base/blob.h"
#include "base/errors.h"

namespace vantage {
namespace {

// What somebody waits for while it is packed is packed quickly, other things tightly; scans are small either way.
constexpr int kTight = 1;
constexpr int kQuick = -3;
// No column of a session grows larger than this when it is unpacked.
constexpr unsigned long long kMaxUnpacked = 1ULL << 30;
// What claims to be larger than this many times its bytes lies: coordinates and indices are never that regular. Ranges
// may be (a wall, or nothing seen), but of them it is known how many there are.
constexpr unsigned long long kMaxRatio = 500;
constexpr std::size_t kCountBytes = sizeof(std::uint64_t);

// With a checksum, so that no flipped bit goes unnoticed.
std::vector<std::byte> compressed(const std::vector<std::byte>& bytes, int level) {
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::vector<std::byte> packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress2(context.get(), packed.data(), packed.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) throw Error(std::string("compressing failed: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

unsigned long long unpackedSize(std::span<const std::byte> packed, const std::string& what) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
    throw InvalidInput(what + " is damaged: it is not a compressed block");
  return size;
}

std::vector<std::byte> decompressed(std::span<const std::byte> packed, unsigned long long size,
                                    const std::string& what) {
  std::vector<std::byte> bytes(size);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) != 0 || got != size) throw InvalidInput(what + " is damaged: it cannot be decompressed");
  return bytes;
}

std::vector<std::byte> decompressed(std::span<const std::byte> packed, const std::string& what) {
  const unsigned long long size = unpackedSize(packed, what);
  if (size > kMaxUnpacked || size > kMaxRatio * (packed.size() + 1))
    throw InvalidInput(what + " is damaged: it claims to unpack to " + std::to_string(size) + " bytes");
  return decompressed(packed, size, what);
}

void mustUnpackTo(unsigned long long expected, std::span<const std::byte> packed, const std::string& what) {
  const unsigned long long size = unpackedSize(packed, what);
  if (size != expected)
    throw InvalidInput(what + " is damaged: it unpacks to " + std::to_string(size) + " bytes, expected " +
                       std::to_string(expected));
}

std::vector<Vec3> unpacked(const std::vector<std::array<double, 3>>& points) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const auto& p : points) result.emplace_back(p[0], p[1], p[2]);
  return result;
}

bool indicesFit(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.vertices.size()) return false;
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vec3& v) { return v.allFinite(); });
}

// A void patch as it lies in the file.
struct PackedPatch {
  std::array<std::uint32_t, 3> edge;
  std::uint32_t view;
  std::array<double, 18> points;  // centre, normal, corners
  std::array<double, 4> sizes;    // width, depth, weight, angle
  std::uint8_t edgeClass;
  std::uint8_t bridged;
  std::array<std::uint8_t, 6> unused;
};
static_assert(sizeof(PackedPatch) == 200);

PackedPatch packed(const VoidPatch& p) {
  PackedPatch result{{p.from, p.to, p.triangle}, p.view, {}, {p.width, p.depth, p.weight, p.angle}, 0, 0, {}};
  const std::array<Vec3, 6> points{p.centre, p.normal, p.corners[0], p.corners[1], p.corners[2], p.corners[3]};
  for (std::size_t i = 0; i < result.points.size(); ++i) result.points[i] = points[i / 3][static_cast<int>(i % 3)];
  result.edgeClass = static_cast<std::uint8_t>(p.edgeClass);
  result.bridged = p.bridged ? 1 : 0;
  return result;
}

VoidPatch unpacked(const PackedPatch& p) {
  VoidPatch result;
  result.from = p.edge[0];
  result.to = p.edge[1];
  result.triangle = p.edge[2];
  result.view = p.view;
  const auto point = [&](std::size_t i) { return Vec3(p.points[3 * i], p.points[3 * i + 1], p.points[3 * i + 2]); };
  result.centre = point(0);
  result.normal = point(1);
  for (std::size_t i = 0; i < 4; ++i) result.corners[i] = point(2 + i);
  result.width = p.sizes[0];
  result.depth = p.sizes[1];
  result.weight = p.sizes[2];
  result.angle = p.sizes[3];
  result.edgeClass = static_cast<EdgeClass>(p.edgeClass);
  result.bridged = p.bridged != 0;
  return result;
}

std::shared_ptr<const VoidSurface> voidsFrom(const std::vector<PackedPatch>& patches, const std::string& what) {
  auto voids = std::make_shared<VoidSurface>();
  for (const PackedPatch& p : patches) {
    const bool finite = std::all_of(p.points.begin(), p.points.end(), [](double v) { return std::isfinite(v); });
    if (p.edgeClass >= kEdgeClasses || !finite) throw InvalidInput(what + " is damaged: a void patch is none");
    voids->patches.push_back(unpacked(p));
    ++voids->counts[p.edgeClass];
    if (p.bridged != 0) ++voids->bridged;
  }
  return voids;
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
  return compressed(writer.bytes(), kTight);
}

std::vector<float> rangeFromBlob(std::span<const std::byte> blob, std::size_t rays, const std::string& what) {
  const unsigned long long size = kCountBytes + rays * sizeof(float);
  mustUnpackTo(size, blob, what);
  const auto bytes = decompressed(blob, size, what);
  BlobReader reader(bytes, what);
  auto range = reader.list<float>();
  reader.finish();
  return range;
}

std::vector<std::byte> coloursBlob(const std::vector<Colour>& colours) {
  BlobWriter writer;
  writer.list(colours);
  return compressed(writer.bytes(), kTight);
}

std::vector<Colour> coloursFromBlob(std::span<const std::byte> blob, std::size_t rays, const std::string& what) {
  const unsigned long long size = kCountBytes + rays * sizeof(Colour);
  mustUnpackTo(size, blob, what);
  const auto bytes = decompressed(blob, size, what);
  BlobReader reader(bytes, what);
  auto colours = reader.list<Colour>();
  reader.finish();
  return colours;
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
  for (const auto* list : {&origins, &directions, &receivers}) writer.list(*list);
  return compressed(writer.bytes(), kTight);
}

RayGrid raysFromBlob(int rows, int columns, int receiversPerRay, std::span<const std::byte> blob,
                     const std::string& what) {
  const auto count = static_cast<unsigned long long>(rows) * static_cast<unsigned long long>(columns);
  constexpr unsigned long long kPoint = 3 * sizeof(double);
  mustUnpackTo(3 * kCountBytes + count * kPoint * (2 + static_cast<unsigned long long>(receiversPerRay)), blob, what);
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
  writer.list(model.mesh.vertices);
  writer.list(model.mesh.triangles);
  writer.list(model.confidence);
  writer.list(model.vertexView);
  writer.list(model.vertexSample);
  writer.list(model.triangleView);
  return compressed(writer.bytes(), kTight);
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
  whole = whole && indicesFit(model.mesh);
  if (!whole) throw InvalidInput(what + " is damaged: its parts do not fit together");
  return model;
}

std::vector<std::byte> meshBlob(const Mesh& mesh) {
  BlobWriter writer;
  writer.list(mesh.vertices);
  writer.list(mesh.triangles);
  return compressed(writer.bytes(), kQuick);
}

Mesh meshFromBlob(std::span<const std::byte> blob, const std::string& what) {
  const auto bytes = decompressed(blob, what);
  BlobReader reader(bytes, what);
  Mesh mesh;
  mesh.vertices = unpacked(reader.list<std::array<double, 3>>());
  mesh.triangles = reader.list<Triangle>();
  reader.finish();
  if (!indicesFit(mesh)) throw InvalidInput(what + " is damaged: its parts do not fit together");
  return mesh;
}

std::vector<std::byte> planBlob(const Plan& plan) {
  BlobWriter writer;
  std::vector<PackedPatch> patches;
  if (plan.voids)
    for (const VoidPatch& p : plan.voids->patches) patches.push_back(packed(p));
  writer.list(patches);
  std::vector<std::array<std::uint8_t, 3>> outlook;
  for (const PatchOutlook& o : plan.outlook)
    outlook.push_back({o.looks, static_cast<std::uint8_t>(o.answered), static_cast<std::uint8_t>(o.reason)});
  writer.list(outlook);
  std::vector<double> promises;
  for (const PatchOutlook& o : plan.outlook) promises.push_back(o.promise);
  writer.list(promises);
  for (const PositionScore& score : plan.scores) writer.list(score.patches);
  return compressed(writer.bytes(), kQuick);
}

void addFromPlanBlob(Plan& plan, std::span<const std::byte> blob, const std::string& what) {
  const auto bytes = decompressed(blob, what);
  BlobReader reader(bytes, what);
  plan.voids = voidsFrom(reader.list<PackedPatch>(), what);
  for (const auto& o : reader.list<std::array<std::uint8_t, 3>>()) {
    if (o[2] >= kEdgeReasons) throw InvalidInput(what + " is damaged: a patch is left for no known reason");
    plan.outlook.push_back({o[0], o[1] != 0, static_cast<EdgeReason>(o[2]), 0.0});
  }
  const auto promises = reader.list<double>();
  bool whole = plan.outlook.size() == plan.voids->patches.size() && promises.size() == plan.outlook.size();
  for (std::size_t p = 0; whole && p < promises.size(); ++p) plan.outlook[p].promise = promises[p];
  for (PositionScore& score : plan.scores) {
    score.patches = reader.list<std::uint32_t>();
    for (const std::uint32_t patch : score.patches) whole = whole && patch < plan.voids->patches.size();
  }
  reader.finish();
  if (!whole) throw InvalidInput(what + " is damaged: its parts do not fit together");
}

}  // namespace vantage
