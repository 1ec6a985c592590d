#include <cstring>

#include "base/errors.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/scratch_file.h"
#include "geometry/geometry_hash.h"
#include "positional_space/scanner_images_cache.h"

// A cache of scanner images, as it stands or, when the input begins with 1, with its checksum put right, so that the
// reader gets to see it.

namespace vantage::testing {
namespace {

constexpr std::uint64_t kProfile = 42;
// Magic, version, byte order, profile, checksum (see scanner_images_cache.cpp).
constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kSumAt = 24;
constexpr std::size_t kHeader = 32;

ScannerProfile smallProfile() {
  return parseProfile({"fuzz.json",
                       R"({ "name": "T", "scanner": { "type": "rotating_stripe", "position": [250, 0, 50],
    "stripe_height_mm": 100, "samples_per_stripe": 30, "stripes": 30, "sweep_deg": 40, "receivers": [[50, 0, 0]],
    "breakdown_angle_deg": 65, "range_mm": [100, 400] }, "workspace": { "type": "turntable", "steps": 5 },
    "viewing_volume": { "radius_mm": 90, "height_mm": 120 }, "positional_space": { "surface": "cylinder", "rows": 4,
    "columns": 16 } })",
                       {}});
}

std::string putRight(std::string bytes) {
  if (bytes.size() < kHeader) return bytes;
  std::uint32_t version = 0;
  std::memcpy(&version, bytes.data() + kVersionAt, sizeof version);
  ContentHash hash;
  hash.add(version);
  hash.add(kProfile);
  hash.add(std::string_view(bytes).substr(kHeader));
  const std::uint64_t sum = hash.value();
  std::memcpy(bytes.data() + kSumAt, &sum, sizeof sum);
  return bytes;
}

void useAll(const ScannerImages& images) {
  for (int position = 0; position < images.positions() && position < 64; ++position)
    static_cast<void>(images.image(position));
  for (std::uint32_t cell = 0; cell < images.cellCount() && cell < 4096; ++cell) {
    static_cast<void>(images.cell(cell));
    static_cast<void>(images.ray(cell));
    static_cast<void>(images.receivers(cell));
    static_cast<void>(images.positionsOf(cell));
  }
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  const ScratchFile file(".images");
  writeScannerImages(computeScannerImages(smallProfile()), kProfile, file.path());
  const std::string good = file.read();
  return {std::string(1, '\0') + good, std::string(1, '\1') + good};
}

}  // namespace vantage::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vantage::testing;
  static const ScratchFile file(".images");
  const std::string input(reinterpret_cast<const char*>(data), size);
  if (input.empty()) return 0;
  file.write(input[0] == 1 ? putRight(input.substr(1)) : input.substr(1));
  try {
    if (const auto images = vantage::readScannerImages(file.path(), kProfile)) useAll(*images);
  } catch (const vantage::Error&) {
    return 0;
  }
  return 0;
}
