#include "io/model_reader.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/errors.h"
#include "base/parallel.h"
#include "io/ply_document.h"
#include "io/ply_mesh.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are copied as they are");

constexpr std::size_t kGrain = 65536;
constexpr std::size_t kIndexBytes = 12;
constexpr double kInventedView = -1.0;

// Where a little endian file with rows of constant length has what we look for, in bytes from the row's beginning.
struct FlatLayout {
  const char* vertices;
  std::size_t vertexCount;
  std::size_t vertexBytes;
  std::array<std::size_t, 3> coordinate;
  const char* faces;
  std::size_t faceCount;
  std::size_t faceBytes;  // of a triangle
  std::size_t corners;    // of the length of the list of corners
};

// Offset of a scalar of that type in a row without lists.
std::optional<std::size_t> offsetOf(const PlyElement& element, std::string_view name, PlyType type) {
  std::size_t offset = 0;
  for (const PlyProperty& p : element.properties) {
    if (p.name == name) return p.type == type && !p.isList() ? std::optional(offset) : std::nullopt;
    offset += sizeOf(p.type) + (p.isList() ? 1 + kIndexBytes - sizeOf(p.type) : 0);
  }
  return std::nullopt;
}

bool isCornerList(const PlyProperty& p) {
  return (p.name == "vertex_indices" || p.name == "vertex_index") && p.listCount == PlyType::UInt8 &&
         (p.type == PlyType::Int32 || p.type == PlyType::UInt32);
}

// The layout of a file that holds nothing but vertices and then faces whose only list are the corners.
std::optional<FlatLayout> flatLayout(const FileBytes& file, const PlyHeader& header) {
  if (header.format != PlyFormat::BinaryLittleEndian || header.elements.size() != 2) return std::nullopt;
  const PlyElement& vertex = header.elements[0];
  const PlyElement& face = header.elements[1];
  if (vertex.name != "vertex" || face.name != "face" || vertex.hasLists()) return std::nullopt;
  FlatLayout layout{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto offset = offsetOf(vertex, std::string_view("xyz").substr(k, 1), PlyType::Float32);
    if (!offset) return std::nullopt;
    layout.coordinate[k] = *offset;
  }
  bool found = false;
  for (const PlyProperty& p : face.properties) {
    if (p.isList() && (found || !isCornerList(p))) return std::nullopt;
    if (p.isList()) layout.corners = layout.faceBytes;
    found = found || p.isList();
    layout.faceBytes += p.isList() ? 1 + kIndexBytes : sizeOf(p.type);
  }
  layout.vertices = file.text().data() + header.bodyOffset;
  layout.vertexCount = vertex.count;
  layout.vertexBytes = vertex.leastRowBytes();
  layout.faces = layout.vertices + layout.vertexCount * layout.vertexBytes;
  layout.faceCount = face.count;
  // Rows of other lengths would not add up to the file's size.
  const std::size_t left = file.size() - header.bodyOffset - layout.vertexCount * layout.vertexBytes;
  return found && left == layout.faceCount * layout.faceBytes ? std::optional(layout) : std::nullopt;
}

template <typename T>
T copyAt(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

[[noreturn]] void failFace(const std::string& path, std::size_t face, std::size_t vertices) {
  throw InvalidInput(path + ": face " + std::to_string(face) + " is not a triangle of three of the " +
                     std::to_string(vertices) + " vertices, which all faces of this file should be");
}

[[noreturn]] void failVertex(const std::string& path, std::size_t vertex) {
  throw InvalidInput(path + ": vertex " + std::to_string(vertex) + " has a coordinate that is not finite");
}

Mesh readFlat(const FileBytes& file, const FlatLayout& layout, const Progress& progress) {
  Mesh mesh;
  mesh.vertices.resize(layout.vertexCount);
  parallelChunks(layout.vertexCount, kGrain, progress.part(0.0, 0.5), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const char* row = layout.vertices + i * layout.vertexBytes;
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k) p[static_cast<Eigen::Index>(k)] = copyAt<float>(row + layout.coordinate[k]);
      if (!p.allFinite()) failVertex(file.path(), i);
      mesh.vertices[i] = p;
    }
  });
  mesh.triangles.resize(layout.faceCount);
  const auto vertices = static_cast<std::uint32_t>(layout.vertexCount);
  parallelChunks(layout.faceCount, kGrain, progress.part(0.5, 1.0), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const char* row = layout.faces + i * layout.faceBytes + layout.corners;
      const auto t = copyAt<Triangle>(row + 1);
      if (*row != 3 || t[0] >= vertices || t[1] >= vertices || t[2] >= vertices)
        failFace(file.path(), i, layout.vertexCount);
      mesh.triangles[i] = t;
    }
  });
  return mesh;
}

// Any other layout.
Mesh readAnyLayout(const FileBytes& file, const Progress& progress) {
  PolygonSoup soup = readPlySoup(file, progress);
  Mesh mesh;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (!soup.points[i].allFinite()) failVertex(file.path(), i);
  mesh.triangles.reserve(soup.ends.size());
  for (std::size_t i = 0; i < soup.ends.size(); ++i) {
    const auto p = soup.polygon(i);
    if (p.size() != 3 || p[0] == kNoIndex || p[1] == kNoIndex || p[2] == kNoIndex)
      failFace(file.path(), i, soup.points.size());
    mesh.triangles.push_back({p[0], p[1], p[2]});
  }
  mesh.vertices = std::move(soup.points);
  return mesh;
}

Mesh readMesh(const FileBytes& file, const std::optional<FlatLayout>& layout, const Progress& progress) {
  return layout ? readFlat(file, *layout, progress) : readAnyLayout(file, progress);
}

std::vector<double> scalars(const FileBytes& file, const PlySelection& which) {
  const PlyDocument document = readPlyDocument(file, std::array{which});
  const PlyColumn* column = document.find(which.element, which.property);
  if (column == nullptr || !column->start.empty())
    throw InvalidInput(file.path() + ": PLY header: the property '" + std::string(which.property) +
                       "' is a list, expected a number");
  return column->values;
}

void readConfidence(const FileBytes& file, const PlyHeader& header, const std::optional<FlatLayout>& layout,
                    Model& model) {
  const auto offset = offsetOf(*header.find("vertex"), "confidence", PlyType::Float32);
  if (layout && offset) {
    model.confidence.resize(layout->vertexCount);
    for (std::size_t i = 0; i < layout->vertexCount; ++i)
      model.confidence[i] = copyAt<float>(layout->vertices + i * layout->vertexBytes + *offset);
  } else {
    for (const double value : scalars(file, {"vertex", "confidence"}))
      model.confidence.push_back(static_cast<float>(value));
  }
  for (std::size_t i = 0; i < model.confidence.size(); ++i)
    if (!(model.confidence[i] >= 0.0F && model.confidence[i] <= 1.0F))
      throw InvalidInput(file.path() + ": vertex " + std::to_string(i) + " has the confidence " +
                         std::to_string(model.confidence[i]) + ", expected 0 to 1");
}

void readViews(const FileBytes& file, const PlyHeader& header, const std::optional<FlatLayout>& layout, Model& model) {
  const auto offset = offsetOf(*header.find("face"), "view", PlyType::Int32);
  std::vector<double> values;
  if (layout && offset) {
    values.resize(layout->faceCount);
    for (std::size_t i = 0; i < layout->faceCount; ++i)
      values[i] = copyAt<std::int32_t>(layout->faces + i * layout->faceBytes + *offset);
  } else {
    values = scalars(file, {"face", "view"});
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= kInventedView && values[i] < 2147483648.0))
      throw InvalidInput(file.path() + ": face " + std::to_string(i) + " has the view " + std::to_string(values[i]) +
                         ", expected 0 or more, or -1 where it is invented");
    model.triangleView.push_back(values[i] < 0.0 ? kNoIndex : static_cast<std::uint32_t>(values[i]));
  }
}

}  // namespace

bool isModel(const PlyHeader& header) {
  const PlyElement* vertex = header.find("vertex");
  const PlyElement* face = header.find("face");
  return vertex != nullptr && face != nullptr && vertex->find("confidence") != nullptr && face->find("view") != nullptr;
}

Model readModel(const std::string& path, const Progress& progress) {
  const FileBytes file(path);
  const PlyHeader header = parsePlyHeader(file.text(), file.size(), path);
  if (!isModel(header))
    throw InvalidInput(path + ": is no model: expected the vertex property 'confidence' and the face property 'view'");
  const std::optional<FlatLayout> layout = flatLayout(file, header);
  Model model;
  model.mesh = readMesh(file, layout, progress);
  readConfidence(file, header, layout, model);
  readViews(file, header, layout, model);
  model.vertexView.assign(model.mesh.vertices.size(), kNoIndex);
  model.vertexSample.assign(model.mesh.vertices.size(), kNoIndex);
  return model;
}

}  // namespace vantage
