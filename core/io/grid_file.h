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
  std::size_t bytesLeftOver = 0;        ///< of the file, behind what it says that it holds
  std::optional<double> unit;           ///< millimetres per unit, where the file says so
  bool inMetres = false;                ///< files of this format are in metres, as a rule
  bool alongZ = false;                  ///< the file says that its scanner looks down along z
  bool ofProfile = false;               ///< the file says that only its scanner's profile has the rays
  bool fromOrigin = false;              ///< samples of this format are measured from the origin, in all directions
  std::optional<Pose> T_world_scanner;  ///< in the unit of the file
};

/// Reads a range file: PLY with `obj_info num_cols C`, `num_rows R` and an element range_grid of R * C lists with 0 or
/// 1 vertex index (Stanford 3D Scanning Repository), or with one vertex for each of the R * C cells; PCD with a HEIGHT
/// above 1 (ascii, binary, binary_compressed); PTX with one scan. Cell k is row k / C, column k % C.
/// @throws IoError when it cannot be read
/// @throws InvalidInput naming file, place and expectation; also for files that have points but no rows and columns
/// @throws Cancelled
[[nodiscard]] GridFile readGridFile(const std::string& path, const Progress& progress = {});

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

/// A grid of `rows` x `columns` cells with a point each; points that are not finite are left out.
/// @throws InvalidInput when the numbers do not agree or are too large
[[nodiscard]] SampleGrid gridOf(std::size_t rows, std::size_t columns, std::vector<Vec3> points,
                                const std::string& path);

}  // namespace vantage
