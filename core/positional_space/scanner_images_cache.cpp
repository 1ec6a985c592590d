#include "positional_space/scanner_images_cache.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>

#include "base/atomic_file.h"
#include "base/blob.h"
#include "base/errors.h"
#include "geometry/geometry_hash.h"

namespace vantage {
namespace {

constexpr std::array<char, 8> kMagic = {'V', 'N', 'T', 'G', 'P', 'S', 'C', 'I'};
// Raise it whenever what is computed or how it is laid out changes.
constexpr std::uint32_t kVersion = 3;
// Written as a number: a file from a machine of the other byte order does not match.
constexpr std::uint32_t kByteOrder = 0x01020304U;

// No profile that can be read has images as large as this.
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{4} << 30;

std::vector<std::byte> encode(const ScannerImages::Data& data) {
  BlobWriter out;
  out.value(static_cast<std::int32_t>(data.shape.surface == PositionalSpaceSurface::Sphere));
  for (const int v : {data.shape.rows, data.shape.columns, data.shape.directions, data.positions, data.steps,
                      data.periods, data.receivers})
    out.value(static_cast<std::int32_t>(v));
  for (const double v : {data.shape.radius, data.shape.bottom, data.shape.top, data.shape.firstColumn,
                         data.shape.angularError, data.minRange, data.maxRange})
    out.value(v);
  out.list(data.surfaceStart);
  out.list(data.cells);
  out.list(data.direction);
  out.list(data.receiverPositions);
  out.list(data.imageStart);
  out.list(data.imageCells);
  return out.bytes();
}

// @throws InvalidInput when the body is not what encode makes.
ScannerImages decode(std::span<const std::byte> body) {
  BlobReader in(body, "scanner images");
  ScannerImages::Data data;
  data.shape.surface =
      in.value<std::int32_t>() != 0 ? PositionalSpaceSurface::Sphere : PositionalSpaceSurface::Cylinder;
  for (int* v : {&data.shape.rows, &data.shape.columns, &data.shape.directions, &data.positions, &data.steps,
                 &data.periods, &data.receivers})
    *v = in.value<std::int32_t>();
  for (double* v : {&data.shape.radius, &data.shape.bottom, &data.shape.top, &data.shape.firstColumn,
                    &data.shape.angularError, &data.minRange, &data.maxRange})
    *v = in.value<double>();
  data.surfaceStart = in.list<std::uint32_t>();
  data.cells = in.list<OccupiedCell>();
  data.direction = in.list<std::array<std::int16_t, 2>>();
  data.receiverPositions = in.list<Vec3>();
  data.imageStart = in.list<std::uint32_t>();
  data.imageCells = in.list<std::uint32_t>();
  in.finish();
  return ScannerImages(std::move(data));
}

// Of one version and one profile only.
std::uint64_t checksum(std::uint64_t profile, std::span<const std::byte> body) {
  ContentHash hash;
  hash.add(kVersion);
  hash.add(profile);
  hash.add(body);
  return hash.value();
}

}  // namespace

std::uint64_t contentHash(const ScannerProfile& profile) {
  ContentHash hash;
  hash.add(kVersion);
  const RayGrid& rays = *profile.rays;
  hash.add(rays.rows());
  hash.add(rays.columns());
  hash.add(static_cast<std::uint64_t>(rays.receivers(0).size()));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    addPoint(hash, rays.ray(i).origin);
    addPoint(hash, rays.ray(i).direction);
    for (const Vec3& r : rays.receivers(i)) addPoint(hash, r);
  }
  hash.add(profile.workspace.steps);
  hash.add(static_cast<std::uint64_t>(profile.workspace.size()));
  for (const Pose& pose : profile.workspace.poses) addPose(hash, pose);
  for (const double v :
       {profile.minRange, profile.maxRange, profile.viewingVolume.radius, profile.viewingVolume.height})
    hash.add(v);
  hash.add(static_cast<int>(profile.positionalSpace.surface == PositionalSpaceSurface::Sphere));
  hash.add(profile.positionalSpace.rows);
  hash.add(profile.positionalSpace.columns);
  return hash.value();
}

void writeScannerImages(const ScannerImages& images, std::uint64_t hash, const std::string& path) {
  const auto body = encode(images.data());
  BlobWriter header;
  header.value(kMagic);
  header.value(kVersion);
  header.value(kByteOrder);
  header.value(hash);
  header.value(checksum(hash, body));
  AtomicFile file(path);
  for (const auto* part : {&header.bytes(), &body})
    file.write({reinterpret_cast<const char*>(part->data()), part->size()});
  file.commit();
}

std::optional<ScannerImages> readScannerImages(const std::string& path, std::uint64_t hash) {
  constexpr std::size_t kHeader = sizeof kMagic + 2 * sizeof kVersion + 2 * sizeof hash;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size < kHeader || size > kMaxBytes) return std::nullopt;
  std::vector<std::byte> content(size);
  std::ifstream in(path, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(size))) return std::nullopt;
  const auto bytes = std::span<const std::byte>(content);
  BlobReader header(bytes.first(kHeader), "scanner images");
  const auto body = bytes.subspan(kHeader);
  const bool ours = header.value<std::array<char, 8>>() == kMagic && header.value<std::uint32_t>() == kVersion &&
                    header.value<std::uint32_t>() == kByteOrder && header.value<std::uint64_t>() == hash &&
                    header.value<std::uint64_t>() == checksum(hash, body);
  if (!ours) return std::nullopt;
  try {
    return decode(body);
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

ScannerImages loadScannerImages(const ScannerProfile& profile, const std::string& cacheDirectory,
                                const Progress& progress) {
  if (cacheDirectory.empty()) return computeScannerImages(profile, progress);
  const std::uint64_t hash = contentHash(profile);
  const std::string path = (std::filesystem::path(cacheDirectory) / (hashText(hash) + ".images")).string();
  if (auto cached = readScannerImages(path, hash)) return *std::move(cached);
  ScannerImages images = computeScannerImages(profile, progress);
  try {
    std::error_code error;
    std::filesystem::create_directories(cacheDirectory, error);
    writeScannerImages(images, hash, path);
  } catch (const IoError&) {
    // A cache that cannot be written to costs time at the next start, nothing else.
  }
  return images;
}

}  // namespace vantage
