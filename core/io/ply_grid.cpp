#include "io/ply_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"
#include "io/ply_colours.h"
#include "io/ply_document.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::array<PlySelection, 8> kWanted{{{"vertex", "x"},
                                               {"vertex", "y"},
                                               {"vertex", "z"},
                                               {"vertex", "red"},
                                               {"vertex", "green"},
                                               {"vertex", "blue"},
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
    throw InvalidInput(path + ": PLY header: the element 'range_grid' has no list 'vertex_indices'");
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

std::optional<double> statedUnit(const PlyHeader& header, const std::string& path) {
  const auto unit = header.info("unit_mm");
  if (!unit) return std::nullopt;
  const auto value = parseNumber(*unit);
  if (!value || !(*value > 0.0 && std::isfinite(*value)))
    throw InvalidInput(path + ": PLY header: 'obj_info unit_mm' is " + inQuotes(*unit) + ", expected a number above 0");
  return value;
}

// One vertex per cell.
SampleGrid organisedGrid(const PlyDocument& document, const std::string& path) {
  const PlyHeader& header = document.header();
  if (!header.info("num_cols") && !header.info("num_rows"))
    throw InvalidInput(path +
                       ": PLY header: has no element 'range_grid' and no 'obj_info num_cols' and 'num_rows' with one "
                       "vertex per cell: points without rows and columns are no range image");
  const auto columns = static_cast<std::size_t>(gridSize(header, "num_cols", path));
  const auto rows = static_cast<std::size_t>(gridSize(header, "num_rows", path));
  std::vector<Vec3> points = readPoints(document, path);
  if (points.size() != rows * columns)
    throw InvalidInput(path +
                       ": PLY header: has no element 'range_grid', so one vertex per cell is expected: num_rows "
                       "x num_cols = " +
                       std::to_string(rows * columns) + " vertices, but there are " + std::to_string(points.size()));
  SampleGrid grid = gridOf(rows, columns, std::move(points), path);
  grid.colours = vertexColours(document);
  return grid;
}

SampleGrid rangeGrid(const PlyDocument& document, const std::string& path) {
  SampleGrid grid;
  grid.columns = gridSize(document.header(), "num_cols", path);
  grid.rows = gridSize(document.header(), "num_rows", path);
  const std::size_t cells = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
  if (cells > kMaxGridCells)
    throw InvalidInput(path + ": has a grid of " + std::to_string(cells) + " cells, at most " +
                       std::to_string(kMaxGridCells) + " are supported");
  grid.points = readPoints(document, path);
  grid.colours = vertexColours(document);
  grid.cell = readCells(document, cells, grid.points, path);
  return grid;
}

}  // namespace

bool isPlyGrid(const PlyHeader& header) {
  if (header.find("range_grid") != nullptr) return true;
  const PlyElement* vertices = header.find("vertex");
  const PlyElement* faces = header.find("face");
  if (vertices == nullptr || (faces != nullptr && faces->count > 0)) return false;
  const auto columns = parseInteger(header.info("num_cols").value_or(""));
  const auto rows = parseInteger(header.info("num_rows").value_or(""));
  const auto sensible = [](const auto& size) { return size && *size >= 2 && *size <= 1'000'000; };
  return sensible(columns) && sensible(rows) && vertices->count == static_cast<std::size_t>(*columns * *rows);
}

GridFile readPlyGrid(const FileBytes& bytes, bool anyPoints, const Progress& progress) {
  const PlyDocument document = readPlyDocument(bytes, kWanted, progress);
  const PlyHeader& header = document.header();
  GridFile file;
  const bool lists = header.find("range_grid") != nullptr;
  const bool said = lists || header.info("num_cols") || header.info("num_rows");
  if (anyPoints && !said) {
    file.samples = scatteredPoints(readPoints(document, bytes.path()), vertexColours(document));
    file.organised = false;
  } else {
    file.samples = lists ? rangeGrid(document, bytes.path()) : organisedGrid(document, bytes.path());
  }
  file.bytesLeftOver = document.bytesLeftOver();
  file.unit = statedUnit(header, bytes.path());
  const std::string rays = header.info("rays").value_or("");
  file.alongZ = rays == "along_z";
  file.ofProfile = !rays.empty() && !file.alongZ;
  return file;
}

}  // namespace vantage
