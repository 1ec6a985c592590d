#include <array>
#include <cmath>

#include "base/errors.h"
#include "io/mesh_formats.h"
#include "io/ply_document.h"

namespace vantage {
namespace {

constexpr std::array<PlySelection, 5> kWanted{{{"vertex", "x"},
                                               {"vertex", "y"},
                                               {"vertex", "z"},
                                               {"face", "vertex_indices"},
                                               {"face", "vertex_index"}}};

std::vector<Vec3> pointsOf(const PlyDocument& document, const std::string& path) {
  const PlyColumn* x = document.find("vertex", "x");
  const PlyColumn* y = document.find("vertex", "y");
  const PlyColumn* z = document.find("vertex", "z");
  for (const PlyColumn* column : {x, y, z})
    if (column == nullptr || !column->start.empty())
      throw InvalidInput(path + ": PLY header: expected an element 'vertex' with the properties x, y and z");
  std::vector<Vec3> points(x->values.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = Vec3(x->values[i], y->values[i], z->values[i]);
  return points;
}

}  // namespace

PolygonSoup readPlySoup(const FileBytes& file, const Progress& progress) {
  const PlyDocument document = readPlyDocument(file, kWanted, progress);
  PolygonSoup soup;
  soup.points = pointsOf(document, file.path());
  const PlyColumn* faces = document.find("face", "vertex_indices");
  if (faces == nullptr) faces = document.find("face", "vertex_index");
  const PlyElement* element = document.header().find("face");
  if (faces == nullptr || faces->start.empty()) {
    if (element == nullptr || element->count == 0) return soup;
    throw InvalidInput(file.path() + ": PLY header: the element 'face' has no list 'vertex_indices' or 'vertex_index'");
  }
  soup.ends.assign(faces->start.begin() + 1, faces->start.end());
  soup.corners.resize(faces->values.size());
  for (std::size_t i = 0; i < soup.corners.size(); ++i) {
    const double index = faces->values[i];
    const bool exists = index >= 0.0 && index < static_cast<double>(soup.points.size()) && index == std::floor(index);
    soup.corners[i] = exists ? static_cast<std::uint32_t>(index) : kNoIndex;
  }
  return soup;
}

}  // namespace vantage
