#include "io/ply_mesh.h"

#include <array>
#include <cmath>

#include "base/errors.h"
#include "io/ply_document.h"

namespace vantage {
namespace {

constexpr std::array<PlySelection, 6> kWanted{{{"vertex", "x"},
                                               {"vertex", "y"},
                                               {"vertex", "z"},
                                               {"face", "vertex_indices"},
                                               {"face", "vertex_index"},
                                               {"tristrips", "vertex_indices"}}};

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

std::uint32_t cornerOf(double index, std::size_t points) {
  const bool exists = index >= 0.0 && index < static_cast<double>(points) && index == std::floor(index);
  return exists ? static_cast<std::uint32_t>(index) : kNoIndex;
}

void addFaces(const PlyColumn& faces, PolygonSoup& soup) {
  soup.ends.assign(faces.start.begin() + 1, faces.start.end());
  soup.corners.resize(faces.values.size());
  for (std::size_t i = 0; i < soup.corners.size(); ++i) soup.corners[i] = cornerOf(faces.values[i], soup.points.size());
}

// Every three corners in a row are a triangle, every other one turned round; -1 begins a new strip.
void addStrips(const PlyColumn& strips, PolygonSoup& soup) {
  for (std::size_t row = 0; row + 1 < strips.start.size(); ++row) {
    std::array<double, 2> last{-1.0, -1.0};
    bool turned = false;
    for (std::size_t i = strips.start[row]; i < strips.start[row + 1]; ++i) {
      const double next = strips.values[i];
      if (last[0] != -1.0 && last[1] != -1.0 && next != -1.0) {
        for (const double index : {last[turned ? 1 : 0], last[turned ? 0 : 1], next})
          soup.corners.push_back(cornerOf(index, soup.points.size()));
        soup.endPolygon();
        turned = !turned;
      } else {
        turned = false;
      }
      last = {last[1], next};
    }
  }
}

}  // namespace

PolygonSoup readPlySoup(const FileBytes& file, const Progress& progress) {
  const PlyDocument document = readPlyDocument(file, kWanted, progress);
  PolygonSoup soup;
  soup.bytesLeftOver = document.bytesLeftOver();
  soup.points = pointsOf(document, file.path());
  if (const PlyColumn* strips = document.find("tristrips", "vertex_indices");
      strips != nullptr && !strips->start.empty()) {
    addStrips(*strips, soup);
    return soup;
  }
  const PlyColumn* faces = document.find("face", "vertex_indices");
  if (faces == nullptr) faces = document.find("face", "vertex_index");
  if (faces != nullptr && !faces->start.empty()) {
    addFaces(*faces, soup);
  } else if (const PlyElement* element = document.header().find("face"); element != nullptr && element->count > 0) {
    throw InvalidInput(file.path() + ": PLY header: the element 'face' has no list 'vertex_indices' or 'vertex_index'");
  }
  return soup;
}

}  // namespace vantage
