#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/progress.h"
#include "io/range_grid_rays.h"
#include "scanner/range_image.h"

namespace vantage {

/// What a range file holds.
struct RangeGrid {
  SampleGrid samples;             ///< [mm]
  double scale = 1.0;             ///< millimetres per unit of the file
  std::size_t bytesLeftOver = 0;  ///< of the file, behind what it says that it holds
  bool looksAlongZ = true;        ///< the scanner looks down along z; false for files written by us from other rays
};

struct RangeFileOptions {
  /// Millimetres per unit of the file. Unset: as the file says (`obj_info unit_mm`), else the likelier of metres and
  /// millimetres (see guessUnit).
  std::optional<double> scale;
  /// How far above the highest sample the reconstructed rays begin [mm].
  double standoff = 100.0;
};

/// Reads the grid of a range file (see readGridFile) without the cells that say that nothing was measured.
/// @throws as readGridFile
[[nodiscard]] RangeGrid readRangeGrid(const std::string& path, const RangeFileOptions& options = {},
                                      const Progress& progress = {});

/// A range file as a range image. The file does not say how its rays lie; they are reconstructed (see reconstructRays):
/// about along -z, through the samples, and for empty cells where the grid would have them. The samples are reproduced
/// but for single precision of the range.
/// @throws as readRangeGrid; InvalidInput also for a file of other rays
[[nodiscard]] RangeImage readRangeFile(const std::string& path, const RangeFileOptions& options = {},
                                       const Progress& progress = {});

/// A range file taken with known ranging rays.
/// @throws as readRangeGrid; InvalidInput also when the grid has another size, or a sample lies farther from its ray
/// than 1 mm
///         or a hundredth of its range
[[nodiscard]] RangeImage readRangeFile(const std::string& path, const std::shared_ptr<const RayGrid>& rays,
                                       const RangeFileOptions& options = {}, const Progress& progress = {});

/// Writes a range image as binary PLY range file in millimetres and scanner coordinates, with its colours. Pose and
/// position are not written.
/// @throws InvalidInput for a range image that is not one; IoError, Cancelled as exportMesh
void writeRangeFile(const RangeImage& image, const std::string& path, const Progress& progress = {});

}  // namespace vantage
