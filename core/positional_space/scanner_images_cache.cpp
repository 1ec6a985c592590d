#include "positional_space/scanner_images_cache.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>
#include <utility>

#include "base/blob.h"
#include "base/errors.h"
#include "geometry/geometry_hash.h"

namespace vantage {
namespace {

constexpr std::array<char, 8> kMagic = {'V', 'N', 'T', 'G', 'P', 'S', 'C', 'I'};
// Raise it whenever what is computed or how it is laid out changes.
constexpr std::uint32_t kVersion = 2;
// Written as a number: a file from a machine of the other byte order does not match.
constexpr std::uint32_t kByteOrder = 0x01020304U;

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

std::uint64_t checksum(std::span<const std::byte> body) {
  ContentHash hash;
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
  header.value(checksum(body));
  const std::string unfinished = path + ".part";
  {
    std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
    for (const auto* part : {&header.bytes(), &body})
      out.write(reinterpret_cast<const char*>(part->data()), static_cast<std::streamsize>(part->size()));
    out.close();
    if (!out) {
      std::remove(unfinished.c_str());
      throw IoError(path, "cannot be written");
    }
  }
  std::error_code error;
  std::filesystem::rename(unfinished, path, error);
  if (error) {
    std::remove(unfinished.c_str());
    throw IoError(path, "cannot be written: " + error.message());
  }
}

std::optional<ScannerImages> readScannerImages(const std::string& path, std::uint64_t hash) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string content = std::move(text).str();
  const auto bytes = std::as_bytes(std::span(content));
  constexpr std::size_t kHeader = sizeof kMagic + 2 * sizeof kVersion + 2 * sizeof hash;
  if (!in || bytes.size() < kHeader) return std::nullopt;
  BlobReader header(bytes.first(kHeader), "scanner images");
  const auto body = bytes.subspan(kHeader);
  const bool ours = header.value<std::array<char, 8>>() == kMagic && header.value<std::uint32_t>() == kVersion &&
                    header.value<std::uint32_t>() == kByteOrder && header.value<std::uint64_t>() == hash &&
                    header.value<std::uint64_t>() == checksum(body);
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
