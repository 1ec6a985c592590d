#include "io/range_files.h"

#include <cmath>
#include <utility>

#include "base/errors.h"
#include "io/grid_file.h"
#include "io/grid_images.h"
#include "io/grid_sight.h"
#include "io/no_sample.h"
#include "io/scan_evidence.h"
#include "io/scan_unit.h"

namespace vantage {
namespace {

double scaleOf(const GridFile& file, const RangeFileOptions& options, const std::string& path) {
  if (options.scale) {
    if (!(*options.scale > 0.0 && std::isfinite(*options.scale)))
      throw InvalidInput(path + ": the scale " + std::to_string(*options.scale) + " mm per unit is not above 0");
    return *options.scale;
  }
  if (file.unit) return *file.unit;
  const UnitEvidence evidence{sizeOf(file.samples), medianPitch(file.samples), {}, file.inMetres};
  return millimetresIn(guessUnit(evidence).unit);
}

}  // namespace

RangeGrid readRangeGrid(const std::string& path, const RangeFileOptions& options, const Progress& progress) {
  GridFile file = readGridFile(path, progress);
  RangeGrid grid;
  const NoSamples none = dropNoSamples(file.samples, {});
  if (file.samples.points.empty())
    throw InvalidInput(path + ": has no samples but " + std::to_string(none.dropped) +
                       " cells that say that nothing was measured");
  grid.scale = scaleOf(file, options, path);
  grid.samples = std::move(file.samples);
  grid.bytesLeftOver = file.bytesLeftOver;
  for (Vec3& p : grid.samples.points) p *= grid.scale;
  grid.looksAlongZ = !file.ofProfile;
  return grid;
}

RangeImage readRangeFile(const std::string& path, const RangeFileOptions& options, const Progress& progress) {
  const RangeGrid grid = readRangeGrid(path, options, progress);
  if (!grid.looksAlongZ) throw InvalidInput(path + ": was not taken along z: it needs the profile of its scanner");
  return imageAlong(grid.samples, -Vec3::UnitZ(), options.standoff);
}

RangeImage readRangeFile(const std::string& path, const std::shared_ptr<const RayGrid>& rays,
                         const RangeFileOptions& options, const Progress& progress) {
  const SampleGrid grid = readRangeGrid(path, options, progress).samples;
  if (grid.rows != rays->rows() || grid.columns != rays->columns())
    throw InvalidInput(path + ": has " + std::to_string(grid.rows) + " x " + std::to_string(grid.columns) +
                       " samples, expected the scanner's " + std::to_string(rays->rows()) + " x " +
                       std::to_string(rays->columns()));
  OffRays off;
  RangeImage image = imageOnRays(grid, rays, off);
  if (!image.rays)
    throw InvalidInput(path + ": the sample in row " +
                       std::to_string(off.cell / static_cast<std::size_t>(grid.columns)) + ", column " +
                       std::to_string(off.cell % static_cast<std::size_t>(grid.columns)) + " lies " +
                       std::to_string(off.aside) +
                       " mm beside its ranging ray, at most 1 mm or 1 % of the range is allowed: this is another "
                       "scanner's file");
  return image;
}

}  // namespace vantage
