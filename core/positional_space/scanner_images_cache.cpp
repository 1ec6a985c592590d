#include "positional_space/scanner_images_cache.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <type_traits>
#include <utility>

#include "base/errors.h"
#include "geometry/geometry_hash.h"

namespace vantage {
namespace {

constexpr std::array<char, 8> kMagic = {'V', 'N', 'T', 'G', 'P', 'S', 'C', 'I'};
// Raise it whenever what is computed or how it is laid out changes.
constexpr std::uint32_t kVersion = 2;
// Written as a number: a file from a machine of the other byte order does not match.
constexpr std::uint32_t kByteOrder = 0x01020304U;

class Writer {
 public:
  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void value(const T& v) { bytes_.append(reinterpret_cast<const char*>(&v), sizeof v); }
  template <typename T>
  void list(const std::vector<T>& v) {
    value(static_cast<std::uint64_t>(v.size()));
    bytes_.append(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(T));
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Reads what Writer wrote; after a read beyond the end nothing more is read and good() is false.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  T value() {
    T v{};
    take(&v, sizeof v);
    return v;
  }
  template <typename T>
  std::vector<T> list() {
    const auto count = value<std::uint64_t>();
    std::vector<T> v;
    if (!good_ || count > (bytes_.size() - at_) / sizeof(T)) {
      good_ = false;
      return v;
    }
    v.resize(count);
    take(v.data(), count * sizeof(T));
    return v;
  }
  [[nodiscard]] bool finished() const { return good_ && at_ == bytes_.size(); }

 private:
  void take(void* to, std::size_t bytes) {
    good_ = good_ && bytes <= bytes_.size() - at_;
    if (!good_ || bytes == 0) return;
    std::memcpy(to, bytes_.data() + at_, bytes);
    at_ += bytes;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

std::string encode(const ScannerImages::Data& data) {
  Writer out;
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

std::optional<ScannerImages> decode(const std::string& body) {
  Reader in(body);
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
  if (!in.finished()) return std::nullopt;
  try {
    return ScannerImages(std::move(data));
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

std::uint64_t checksum(const std::string& body) {
  ContentHash hash;
  hash.add(std::string_view(body));
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
  const std::string body = encode(images.data());
  Writer header;
  header.value(kMagic);
  header.value(kVersion);
  header.value(kByteOrder);
  header.value(hash);
  header.value(checksum(body));
  const std::string unfinished = path + ".part";
  {
    std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
    out << header.bytes() << body;
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
  const std::string bytes = std::move(text).str();
  constexpr std::size_t kHeader = sizeof kMagic + 2 * sizeof kVersion + 2 * sizeof hash;
  if (!in || bytes.size() < kHeader) return std::nullopt;
  const std::string start = bytes.substr(0, kHeader);
  const std::string body = bytes.substr(kHeader);
  Reader header(start);
  const bool ours = header.value<std::array<char, 8>>() == kMagic && header.value<std::uint32_t>() == kVersion &&
                    header.value<std::uint32_t>() == kByteOrder && header.value<std::uint64_t>() == hash &&
                    header.value<std::uint64_t>() == checksum(body);
  return ours ? decode(body) : std::nullopt;
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
