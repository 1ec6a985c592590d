#pragma once

#include <optional>
#include <string>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "io/file_bytes.h"
#include "io/range_grid_rays.h"

namespace vantage {

/// No range file has more cells.
inline constexpr std::size_t kMaxGridCells = 16'000'000;

/// What a range file holds, as it stands there: nothing is known yet of its unit and axes but what it says itself.
struct GridFile {
  SampleGrid samples;                   ///< in the unit of the file; a cell without three finite numbers has no point
  bool organised = true;                ///< false: points in any order, as one row
  std::size_t bytesLeftOver = 0;        ///< of the file, behind what it says that it holds
  std::optional<double> unit;           ///< millimetres per unit, where the file says so
  bool inMetres = false;                ///< files of this format are in metres, as a rule
  bool alongZ = false;                  ///< the file says that its scanner looks down along z
  bool ofProfile = false;               ///< the file says that only its scanner's profile has the rays
  bool ofCamera = false;                ///< points are in the frame of a camera: x right, y down, z forward
  bool fromOrigin = false;              ///< samples of this format are measured from the origin, in all directions
  std::optional<Pose> T_world_scanner;  ///< in the unit of the file
};

/// Rows and columns that somebody says.
struct GridSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// Reads a range file: PLY with `obj_info num_cols C`, `num_rows R` and an element range_grid of R * C lists with 0 or
/// 1 vertex index (Stanford 3D Scanning Repository), or with one vertex for each of the R * C cells; PCD with a HEIGHT
/// above 1 (ascii, binary, binary_compressed); PTX with one scan; depth as PNG of 16 bits with its intrinsics beside it
/// (see readDepthPng); points as text whose rows and columns are said or told by their order (see readTextPoints). Cell
/// k is row k / C, column k % C.
/// @param size of text that does not say it
/// @throws IoError when it cannot be read
/// @throws InvalidInput naming file, place and expectation; also for files that have points but no rows and columns
/// @throws Cancelled
[[nodiscard]] GridFile readGridFile(const std::string& path, const Progress& progress = {},
                                    std::optional<GridSize> size = {});

/// The same for a file of a scanner that is known, whose samples are put on its rays: points without rows and columns
/// will do.
/// @throws as readGridFile
[[nodiscard]] GridFile readSamples(const std::string& path, const Progress& progress = {},
                                   std::optional<GridSize> size = {});

/// Leaves out cells: `isNone(point)`. @return how many.
template <typename Predicate>
std::size_t dropSamples(SampleGrid& grid, const Predicate& isNone) {
  std::size_t dropped = 0;
  for (std::uint32_t& cell : grid.cell) {
    if (cell == kNoIndex || !isNone(grid.points[cell])) continue;
    cell = kNoIndex;
    ++dropped;
  }
  return dropped;
}

/// Keeps only points that a cell names, in order of the cells.
void keepUsedPoints(SampleGrid& grid);

/// Points in any order, as a grid of one row; those that are not finite are left out.
[[nodiscard]] SampleGrid scatteredPoints(std::vector<Vec3> points, std::vector<Colour> colours);

/// A grid of `rows` x `columns` cells with a point each; points that are not finite are left out.
/// @throws InvalidInput when the numbers do not agree or are too large
[[nodiscard]] SampleGrid gridOf(std::size_t rows, std::size_t columns, std::vector<Vec3> points,
                                const std::string& path);

}  // namespace vantage
