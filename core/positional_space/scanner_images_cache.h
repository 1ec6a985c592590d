#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/progress.h"
#include "positional_space/scanner_images.h"

namespace vantage {

/// A number for everything that the images of a profile depend on: rays, receivers, poses, ranges, viewing volume and
/// positional space. Equal for equal contents, however the file is named or formatted.
[[nodiscard]] std::uint64_t contentHash(const ScannerProfile& profile);

/// Writes images to a file in one move: a reader sees the whole file or none.
/// @throws IoError
void writeScannerImages(const ScannerImages& images, std::uint64_t hash, const std::string& path);

/// @return nothing when the file does not exist, was made by another version or for another profile, or is damaged.
[[nodiscard]] std::optional<ScannerImages> readScannerImages(const std::string& path, std::uint64_t hash);

/// The images of a profile: read from `cacheDirectory` when they are there, otherwise computed and left there. A
/// directory that cannot be written to is no error. An empty name means no cache.
/// @throws Cancelled
[[nodiscard]] ScannerImages loadScannerImages(const ScannerProfile& profile, const std::string& cacheDirectory,
                                              const Progress& progress = {});

}  // namespace vantage
