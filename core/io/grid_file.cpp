#include "io/grid_file.h"

#include <utility>

#include "base/errors.h"
#include "io/depth_png.h"
#include "io/file_kind.h"
#include "io/pcd_reader.h"
#include "io/ply_grid.h"
#include "io/ptx_reader.h"
#include "io/text_points.h"

namespace vantage {
namespace {

GridFile readKind(const std::string& path, bool anyPoints, const std::optional<GridSize>& size,
                  const Progress& progress) {
  const std::string expected = "expected a range file (PLY, PCD, PTX, 16-bit depth PNG, or XYZ as text)";
  switch (detectFileKind(path)) {
    case FileKind::Ply:
      return readPlyGrid(FileBytes(path), anyPoints, progress);
    case FileKind::Pcd:
      return readPcd(FileBytes(path), anyPoints, progress);
    case FileKind::Ptx:
      return readPtx(FileBytes(path), progress);
    case FileKind::DepthPng:
      return readDepthPng(path);
    case FileKind::TextPoints:
      return readTextPoints(FileBytes(path), size, progress);
    case FileKind::Session:
      throw InvalidInput(path + ": is a session, " + expected);
    case FileKind::Profile:
    case FileKind::ScanPoses:
      throw InvalidInput(path + ": holds no samples, " + expected);
    default:
      break;
  }
  throw InvalidInput(path + ": is a mesh, " + expected + " with rows and columns of samples");
}

GridFile readNotEmpty(const std::string& path, bool anyPoints, const std::optional<GridSize>& size,
                      const Progress& progress) {
  GridFile file = readKind(path, anyPoints, size, progress);
  keepUsedPoints(file.samples);
  if (file.samples.points.empty())
    throw InvalidInput(path + ": has no samples, expected at least one cell of its grid with a point");
  return file;
}

}  // namespace

void keepUsedPoints(SampleGrid& grid) {
  std::vector<Vec3> used;
  std::vector<Colour> colours;
  for (std::uint32_t& index : grid.cell) {
    if (index == kNoIndex) continue;
    used.push_back(grid.points[index]);
    if (!grid.colours.empty()) colours.push_back(grid.colours[index]);
    index = static_cast<std::uint32_t>(used.size() - 1);
  }
  grid.points = std::move(used);
  grid.colours = std::move(colours);
}

SampleGrid gridOf(std::size_t rows, std::size_t columns, std::vector<Vec3> points, const std::string& path) {
  if (rows < 2 || columns < 2 || rows > kMaxGridCells / columns)
    throw InvalidInput(path + ": has a grid of " + std::to_string(rows) + " x " + std::to_string(columns) +
                       " cells, expected 2 x 2 up to " + std::to_string(kMaxGridCells) + " in all");
  if (points.size() != rows * columns)
    throw InvalidInput(path + ": has " + std::to_string(points.size()) + " points for a grid of " +
                       std::to_string(rows) + " x " + std::to_string(columns) + " cells");
  SampleGrid grid{static_cast<int>(rows), static_cast<int>(columns), std::move(points), {}};
  grid.cell.resize(grid.points.size());
  for (std::size_t i = 0; i < grid.cell.size(); ++i)
    grid.cell[i] = grid.points[i].allFinite() ? static_cast<std::uint32_t>(i) : kNoIndex;
  return grid;
}

SampleGrid scatteredPoints(std::vector<Vec3> points, std::vector<Colour> colours) {
  SampleGrid grid{1, static_cast<int>(points.size()), std::move(points), {}, std::move(colours)};
  grid.cell.resize(grid.points.size());
  for (std::size_t i = 0; i < grid.cell.size(); ++i)
    grid.cell[i] = grid.points[i].allFinite() ? static_cast<std::uint32_t>(i) : kNoIndex;
  return grid;
}

GridFile readGridFile(const std::string& path, const Progress& progress, std::optional<GridSize> size) {
  GridFile file = readNotEmpty(path, false, size, progress);
  if (!file.organised)
    throw InvalidInput(path +
                       ": is a point cloud as text (XYZ) whose rows and columns of samples are not known: say "
                       "--grid ROWSxCOLUMNS if it has a line for every cell, or name the profile of its scanner");
  return file;
}

GridFile readSamples(const std::string& path, const Progress& progress, std::optional<GridSize> size) {
  return readNotEmpty(path, true, size, progress);
}

}  // namespace vantage
