#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "io/grid_file.h"
#include "io/scan_poses.h"
#include "scanner/profile.h"
#include "scanner/range_image.h"
#include "scanner/scan_reading.h"

namespace vantage {

/// What an operator says about the axes of range files.
enum class FrameChoice : std::uint8_t {
  LooksXUp,
  LooksXDown,
  LooksYUp,
  LooksYDown,
  LooksZUp,
  LooksZDown,
  World,
  Turn,
  Profile
};

/// "auto" is nothing; "x+", "x-", ... "z-": the scanner looks along that axis; "camera" is z+, "gl" or "opengl" is z-;
/// "world": the points are in the object's coordinates; "cylinder": columns go around an axis; "profile": points are in
/// the coordinates of the scanner's profile.
/// @throws InvalidInput for anything else
[[nodiscard]] std::optional<FrameChoice> parseFrame(std::string_view text);

/// What an operator says about range files; what is not said is found, or taken as usual.
struct ScanReadingOptions {
  std::optional<double> unit;  ///< millimetres per unit
  std::optional<FrameChoice> frame;
  std::optional<double> noSample;  ///< see dropNoSamples
  std::optional<Axis> up;          ///< of the world; nothing: z
  std::optional<GridSize> grid;    ///< rows and columns of points as text, where the file does not say them
  double standoff = 100.0;         ///< how far before the nearest sample reconstructed rays begin [mm]
};

/// A scan of a file, with its pose where a list or the file has one, and as what it was read.
struct ReadScan {
  std::size_t file = 0;  ///< index into the list of files
  RangeImage image;
  ScanReading reading;
};

/// Reads the range files of one scanner together: what no file says is found from all of them and their poses. Most
/// files are one scan; a grid that goes around an axis is several.
/// @param list of poses, with a scale of 1; null without one. Files then have the poses that they carry themselves.
/// @param profile null: rays are reconstructed from the grids.
/// @throws IoError when a file cannot be read
/// @throws InvalidInput when options name a frame that a profile does not have; naming file, place and expectation;
/// where the numbers do not tell unit or viewing direction,
///         naming the option that does; Cancelled
[[nodiscard]] std::vector<ReadScan> readScans(const std::vector<std::string>& files, const std::vector<ScanPose>* list,
                                              const ScannerProfile* profile, const ScanReadingOptions& options,
                                              const Progress& progress = {});

/// One file that a scanner with a profile took from a position of its workspace.
/// @throws as readScans
[[nodiscard]] ReadScan readScanAt(const std::string& file, const ScannerProfile& profile, int position,
                                  const ScanReadingOptions& options, const Progress& progress = {});

}  // namespace vantage
