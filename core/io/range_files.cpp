#include "io/range_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "geometry/measures.h"
#include "io/ply_document.h"
#include "io/range_grid_rays.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kMaxCells = 16'000'000;
// A bounding box below this many units is in metres: no scanner of objects has a working volume of ten metres, and no
// object is smaller than ten millimetres in all directions.
constexpr double kMetresBelow = 10.0;
constexpr double kMetre = 1000.0;

constexpr std::array<PlySelection, 5> kWanted{{{"vertex", "x"},
                                               {"vertex", "y"},
                                               {"vertex", "z"},
                                               {"range_grid", "vertex_indices"},
                                               {"range_grid", "vertex_index"}}};

int gridSize(const PlyHeader& header, std::string_view key, const std::string& path) {
  const auto text = header.info(key);
  const auto value = text ? parseInteger(*text) : std::nullopt;
  if (!value || *value < 2 || *value > 1'000'000)
    throw InvalidInput(path + ": PLY header: 'obj_info " + std::string(key) + "' is " +
                       (text ? inQuotes(*text) : "missing") + ", expected a whole number of at least 2");
  return static_cast<int>(*value);
}

std::vector<Vec3> readPoints(const PlyDocument& document, const std::string& path) {
  std::array<const PlyColumn*, 3> columns{};
  for (std::size_t k = 0; k < 3; ++k) {
    columns[k] = document.find("vertex", std::string_view("xyz").substr(k, 1));
    if (columns[k] == nullptr || !columns[k]->start.empty())
      throw InvalidInput(path + ": PLY header: expected an element 'vertex' with the properties x, y and z");
  }
  std::vector<Vec3> points(columns[0]->values.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = Vec3(columns[0]->values[i], columns[1]->values[i], columns[2]->values[i]);
  return points;
}

std::vector<std::uint32_t> readCells(const PlyDocument& document, std::size_t cells, const std::vector<Vec3>& points,
                                     const std::string& path) {
  const PlyColumn* grid = document.find("range_grid", "vertex_indices");
  if (grid == nullptr) grid = document.find("range_grid", "vertex_index");
  if (grid == nullptr || grid->start.empty())
    throw InvalidInput(path +
                       ": PLY header: has no element 'range_grid' with a list 'vertex_indices': a range image has rows "
                       "and columns of samples");
  if (grid->start.size() != cells + 1)
    throw InvalidInput(path + ": PLY header: range_grid has " + std::to_string(grid->start.size() - 1) +
                       " entries, expected num_rows x num_cols = " + std::to_string(cells));
  std::vector<std::uint32_t> cell(cells, kNoIndex);
  for (std::size_t k = 0; k < cells; ++k) {
    const std::size_t count = grid->start[k + 1] - grid->start[k];
    const double index = count == 1 ? grid->values[grid->start[k]] : 0.0;
    if (count > 1 || !(index >= 0.0 && (count == 0 || index < static_cast<double>(points.size()))))
      throw InvalidInput(path + ": entry " + std::to_string(k) + " of range_grid should name none or one of the " +
                         std::to_string(points.size()) + " vertices");
    if (count == 1 && points[static_cast<std::size_t>(index)].allFinite()) cell[k] = static_cast<std::uint32_t>(index);
  }
  return cell;
}

double scaleOf(const PlyHeader& header, const std::vector<Vec3>& points, const RangeFileOptions& options,
               const std::string& path) {
  if (options.scale) {
    if (!(*options.scale > 0.0 && std::isfinite(*options.scale)))
      throw InvalidInput(path + ": the scale " + std::to_string(*options.scale) + " mm per unit is not above 0");
    return *options.scale;
  }
  if (const auto unit = header.info("unit_mm")) {
    const auto value = parseNumber(*unit);
    if (!value || !(*value > 0.0 && std::isfinite(*value)))
      throw InvalidInput(path + ": PLY header: 'obj_info unit_mm' is " + inQuotes(*unit) +
                         ", expected a number above 0");
    return *value;
  }
  BoundingBox box{points.front(), points.front()};
  for (const Vec3& p : points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box.size().maxCoeff() < kMetresBelow ? kMetre : 1.0;
}

// Only points that a cell names, in order of the cells.
void keepUsedPoints(SampleGrid& grid) {
  std::vector<Vec3> used;
  for (std::uint32_t& index : grid.cell) {
    if (index == kNoIndex) continue;
    used.push_back(grid.points[index]);
    index = static_cast<std::uint32_t>(used.size() - 1);
  }
  grid.points = std::move(used);
}

RangeImage reconstructImage(const SampleGrid& samples, double standoff) {
  double top = samples.points.front().z();
  for (const Vec3& p : samples.points) top = std::max(top, p.z());
  std::vector<RangingRay> rays = reconstructRays(samples, top + standoff);
  RangeImage image;
  image.range.assign(rays.size(), kNoSample);
  for (std::size_t k = 0; k < rays.size(); ++k)
    if (samples.cell[k] != kNoIndex)
      image.range[k] = static_cast<float>((samples.points[samples.cell[k]] - rays[k].origin).norm());
  image.rays = std::make_shared<const RayGrid>(samples.rows, samples.columns, std::move(rays), std::vector<Vec3>{}, 0);
  return image;
}

}  // namespace

RangeGrid readRangeGrid(const std::string& path, const RangeFileOptions& options, const Progress& progress) {
  const PlyDocument document = readPlyDocument(FileBytes(path), kWanted, progress);
  if (document.header().find("range_grid") == nullptr)
    throw InvalidInput(
        path + ": PLY header: has no element 'range_grid', expected a range file with rows and columns of samples");
  RangeGrid grid;
  SampleGrid& samples = grid.samples;
  samples.columns = gridSize(document.header(), "num_cols", path);
  samples.rows = gridSize(document.header(), "num_rows", path);
  const std::size_t cells = static_cast<std::size_t>(samples.rows) * static_cast<std::size_t>(samples.columns);
  if (cells > kMaxCells)
    throw InvalidInput(path + ": has a grid of " + std::to_string(cells) + " cells, at most " +
                       std::to_string(kMaxCells) + " are supported");
  samples.points = readPoints(document, path);
  samples.cell = readCells(document, cells, samples.points, path);
  keepUsedPoints(samples);
  if (samples.points.empty())
    throw InvalidInput(path + ": has no samples, expected at least one cell of range_grid with a point");
  grid.scale = scaleOf(document.header(), samples.points, options, path);
  for (Vec3& p : samples.points) p *= grid.scale;
  grid.looksAlongZ = document.header().info("rays").value_or("along_z") == "along_z";
  return grid;
}

RangeImage readRangeFile(const std::string& path, const RangeFileOptions& options, const Progress& progress) {
  const RangeGrid grid = readRangeGrid(path, options, progress);
  if (!grid.looksAlongZ) throw InvalidInput(path + ": was not taken along z: it needs the profile of its scanner");
  return reconstructImage(grid.samples, options.standoff);
}

RangeImage readRangeFile(const std::string& path, std::shared_ptr<const RayGrid> rays, const RangeFileOptions& options,
                         const Progress& progress) {
  const SampleGrid grid = readRangeGrid(path, options, progress).samples;
  if (grid.rows != rays->rows() || grid.columns != rays->columns())
    throw InvalidInput(path + ": has " + std::to_string(grid.rows) + " x " + std::to_string(grid.columns) +
                       " samples, expected the scanner's " + std::to_string(rays->rows()) + " x " +
                       std::to_string(rays->columns()));
  RangeImage image;
  image.range.assign(rays->size(), kNoSample);
  for (std::size_t k = 0; k < rays->size(); ++k) {
    if (grid.cell[k] == kNoIndex) continue;
    const Vec3 offset = grid.points[grid.cell[k]] - rays->ray(k).origin;
    const double range = offset.dot(rays->ray(k).direction);
    const double aside = (offset - range * rays->ray(k).direction).norm();
    if (range < 0.0 || aside > std::max(1.0, 0.01 * range))
      throw InvalidInput(
          path + ": the sample in row " + std::to_string(k / static_cast<std::size_t>(grid.columns)) + ", column " +
          std::to_string(k % static_cast<std::size_t>(grid.columns)) + " lies " + std::to_string(aside) +
          " mm beside its ranging ray, at most 1 mm or 1 % of the range is allowed: this is another scanner's file");
    image.range[k] = static_cast<float>(range);
  }
  image.rays = std::move(rays);
  return image;
}

}  // namespace vantage
