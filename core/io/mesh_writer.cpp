#include "io/mesh_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "io/file_kind.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are copied as they are");

constexpr std::size_t kRowsPerCheckpoint = 65536;

// A mesh, and the model that it belongs to if it is not a plain one.
struct Surface {
  const Mesh& mesh;
  const Model* model;
  Vec3 offset = Vec3::Zero();
  const VertexColours* colours = nullptr;

  [[nodiscard]] bool isFar() const { return !offset.isZero(0.0); }
  [[nodiscard]] bool isColoured() const { return colours != nullptr && !colours->empty(); }
  [[nodiscard]] Colour colour(std::size_t vertex) const { return (*colours)[vertex].value_or(kGrey); }
};

void checkIndices(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (v >= mesh.vertices.size())
        throw InvalidInput("triangle " + std::to_string(t) + " names vertex " + std::to_string(v) + " of " +
                           std::to_string(mesh.vertices.size()));
}

template <typename Row>
void forRows(std::size_t count, const Progress& progress, const Row& row) {
  for (std::size_t begin = 0; begin < count; begin += kRowsPerCheckpoint) {
    progress.checkpoint(static_cast<double>(begin) / static_cast<double>(count));
    const std::size_t end = std::min(count, begin + kRowsPerCheckpoint);
    for (std::size_t i = begin; i < end; ++i) row(i);
  }
}

template <typename T>
char* put(char* at, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(at, &value, sizeof(T));
  return at + sizeof(T);
}

// In single precision.
char* putVector(char* at, const Vec3& v) {
  return put(at, std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())});
}

char* putDoubles(char* at, const Vec3& v) {
  return put(at, std::array<double, 3>{v.x(), v.y(), v.z()});
}

std::string greyComment(const VertexColours& colours) {
  const std::size_t grey = countColourless(colours);
  if (grey == 0) return {};
  std::string text = "comment no colour was measured at " + std::to_string(grey) + " vertices, which are";
  for (const int channel : kGrey) {
    text += ' ';
    text += std::to_string(channel);
  }
  return text + "\n";
}

std::string plyHeader(const Surface& surface) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment millimetres\n";
  if (surface.isColoured()) text += greyComment(*surface.colours);
  text += "element vertex " + std::to_string(surface.mesh.vertices.size()) + "\n";
  const std::string real = surface.isFar() ? "double" : "float";
  for (const char* axis : {"x", "y", "z"}) text += "property " + real + " " + axis + "\n";
  if (surface.model != nullptr) text += "property float confidence\n";
  if (surface.isColoured()) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "element face " + std::to_string(surface.mesh.triangles.size()) + "\n";
  text += "property list uchar int vertex_indices\n";
  if (surface.model != nullptr) text += "property int view\n";
  return text + "end_header\n";
}

void writePly(const Surface& surface, AtomicFile& file, const Progress& progress) {
  file.write(plyHeader(surface));
  const Model* model = surface.model;
  const bool coloured = surface.isColoured();
  forRows(surface.mesh.vertices.size(), progress.part(0.0, 0.5), [&](std::size_t i) {
    const Vec3& vertex = surface.mesh.vertices[i];
    char* at = file.grow((surface.isFar() ? 24U : 12U) + (model != nullptr ? 4U : 0U) + (coloured ? 3U : 0U));
    at = surface.isFar() ? putDoubles(at, vertex + surface.offset) : putVector(at, vertex);
    if (model != nullptr) at = put(at, model->confidence[i]);
    if (coloured) put(at, surface.colour(i));
  });
  forRows(surface.mesh.triangles.size(), progress.part(0.5, 1.0), [&](std::size_t i) {
    char* at = put(file.grow(model != nullptr ? 17 : 13), std::uint8_t{3});
    at = put(at, surface.mesh.triangles[i]);
    if (model != nullptr) put(at, model->triangleView[i]);
  });
}

void writeStl(const Surface& surface, AtomicFile& file, const Progress& progress) {
  std::array<char, 80> header{};
  const std::string text =
      surface.isFar() ? "binary STL, millimetres, without the offset of the scans" : "binary STL, millimetres";
  std::copy(text.begin(), text.end(), header.begin());
  file.write({header.data(), header.size()});
  const std::size_t count = surface.mesh.triangles.size();
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw InvalidInput("an STL file holds at most 4294967295 triangles");
  put(file.grow(4), static_cast<std::uint32_t>(count));
  forRows(count, progress, [&](std::size_t i) {
    const Triangle& t = surface.mesh.triangles[i];
    char* at = putVector(file.grow(50), triangleNormal(surface.mesh, t));
    for (const std::uint32_t v : t) at = putVector(at, surface.mesh.vertices[v]);
    put(at, std::uint16_t{0});
  });
}

char* putText(char* at, std::string_view text) {
  return std::copy(text.begin(), text.end(), at);
}

void writeObj(const Surface& surface, AtomicFile& file, const Progress& progress) {
  constexpr std::size_t kMaxLine = 128;
  std::array<char, kMaxLine> line{};
  char* const end = line.data() + line.size();
  file.write("# millimetres\n");
  forRows(surface.mesh.vertices.size(), progress.part(0.0, 0.5), [&](std::size_t i) {
    char* at = putText(line.data(), "v");
    for (int k = 0; k < 3; ++k) {
      const double value = surface.mesh.vertices[i][k];
      at = putText(at, " ");
      at = surface.isFar() ? std::to_chars(at, end, value + surface.offset[k]).ptr
                           : std::to_chars(at, end, static_cast<float>(value)).ptr;
    }
    if (surface.isColoured())
      for (const std::uint8_t channel : surface.colour(i))
        at = std::to_chars(putText(at, " "), end, static_cast<float>(channel) / 255.0F).ptr;
    at = putText(at, "\n");
    file.write({line.data(), static_cast<std::size_t>(at - line.data())});
  });
  forRows(surface.mesh.triangles.size(), progress.part(0.5, 1.0), [&](std::size_t i) {
    char* at = putText(line.data(), "f");
    for (const std::uint32_t v : surface.mesh.triangles[i]) at = std::to_chars(putText(at, " "), end, v + 1ULL).ptr;
    at = putText(at, "\n");
    file.write({line.data(), static_cast<std::size_t>(at - line.data())});
  });
}

void exportSurface(const Surface& surface, const std::string& path, const Progress& progress) {
  checkIndices(surface.mesh);
  const std::string extension = extensionOf(path);
  if (extension != "ply" && extension != "stl" && extension != "obj")
    throw InvalidInput(path + ": has the extension " + inQuotes(extension) + ", expected .ply, .stl or .obj");
  AtomicFile file(path);
  if (extension == "ply") writePly(surface, file, progress);
  if (extension == "stl") writeStl(surface, file, progress);
  if (extension == "obj") writeObj(surface, file, progress);
  file.commit();
  progress.checkpoint(1.0);
}

}  // namespace

void exportModel(const Model& model, const std::string& path, const Progress& progress, const Vec3& offset,
                 const VertexColours& colours) {
  if (model.confidence.size() != model.mesh.vertices.size() || model.triangleView.size() != model.mesh.triangles.size())
    throw InvalidInput("the model's confidences and views do not match its vertices and triangles");
  if (!colours.empty() && colours.size() != model.mesh.vertices.size())
    throw InvalidInput("the model has " + std::to_string(colours.size()) + " colours for " +
                       std::to_string(model.mesh.vertices.size()) + " vertices");
  exportSurface({model.mesh, &model, offset, &colours}, path, progress);
}

bool holdsOffset(const std::string& path) {
  return extensionOf(path) != "stl";
}

bool holdsColours(const std::string& path) {
  return extensionOf(path) != "stl";
}

void exportMesh(const Mesh& mesh, const std::string& path, const Progress& progress) {
  exportSurface({mesh, nullptr}, path, progress);
}

}  // namespace vantage
