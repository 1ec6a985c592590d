#include "io/mesh_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "io/file_kind.h"
#include "io/text_scanner.h"
#include "io/three_mf_writer.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are copied as they are");

constexpr std::size_t kRowsPerCheckpoint = 65536;

// A mesh, and the model that it belongs to if it is not a plain one.
struct Surface {
  const Mesh& mesh;
  const Model* model;
  ExportOptions options = {};

  [[nodiscard]] bool isFar() const { return !options.offset.isZero(0.0); }
  [[nodiscard]] bool isColoured() const { return !options.colours.empty(); }
  [[nodiscard]] bool marksInvented() const { return !options.invented.empty(); }
  [[nodiscard]] Colour colour(std::size_t vertex) const { return options.colours[vertex].value_or(kGrey); }
  // In the unit of the file.
  [[nodiscard]] Vec3 inUnit(const Vec3& p) const {
    return options.unit == LengthUnit::Millimetre ? p : Vec3(p / millimetresIn(options.unit));
  }
  [[nodiscard]] Vec3 vertex(std::size_t i) const { return inUnit(mesh.vertices[i]); }
  [[nodiscard]] Vec3 farVertex(std::size_t i) const { return inUnit(mesh.vertices[i] + options.offset); }
  [[nodiscard]] std::string unitName() const {
    return options.unit == LengthUnit::Millimetre ? "millimetres" : "inches";
  }
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

std::string greyComment(std::span<const std::optional<Colour>> colours) {
  const auto grey = std::count(colours.begin(), colours.end(), std::nullopt);
  if (grey == 0) return {};
  std::string text = "comment no colour was measured at " + std::to_string(grey) + " vertices, which are";
  for (const int channel : kGrey) {
    text += ' ';
    text += std::to_string(channel);
  }
  return text + "\n";
}

std::string plyHeader(const Surface& surface) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + surface.unitName() + "\n";
  if (surface.isColoured()) text += greyComment(surface.options.colours);
  text += "element vertex " + std::to_string(surface.mesh.vertices.size()) + "\n";
  const std::string real = surface.isFar() ? "double" : "float";
  for (const char* axis : {"x", "y", "z"}) text += "property " + real + " " + axis + "\n";
  if (surface.model != nullptr) text += "property float confidence\n";
  if (surface.isColoured()) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (surface.marksInvented()) text += "property uchar invented\n";
  text += "element face " + std::to_string(surface.mesh.triangles.size()) + "\n";
  text += "property list uchar int vertex_indices\n";
  if (surface.model != nullptr) text += "property int view\n";
  return text + "end_header\n";
}

void writePly(const Surface& surface, AtomicFile& file, const Progress& progress) {
  file.write(plyHeader(surface));
  const Model* model = surface.model;
  const bool coloured = surface.isColoured();
  const bool marks = surface.marksInvented();
  forRows(surface.mesh.vertices.size(), progress.part(0.0, 0.5), [&](std::size_t i) {
    char* at = file.grow((surface.isFar() ? 24U : 12U) + (model != nullptr ? 4U : 0U) + (coloured ? 3U : 0U) +
                         (marks ? 1U : 0U));
    at = surface.isFar() ? putDoubles(at, surface.farVertex(i)) : putVector(at, surface.vertex(i));
    if (model != nullptr) at = put(at, model->confidence[i]);
    if (coloured) at = put(at, surface.colour(i));
    if (marks) put(at, surface.options.invented[i]);
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
      "binary STL, " + surface.unitName() + (surface.isFar() ? ", without the offset of the scans" : "");
  std::copy(text.begin(), text.end(), header.begin());
  file.write({header.data(), header.size()});
  const std::size_t count = surface.mesh.triangles.size();
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw InvalidInput("an STL file holds at most 4294967295 triangles");
  put(file.grow(4), static_cast<std::uint32_t>(count));
  forRows(count, progress, [&](std::size_t i) {
    const Triangle& t = surface.mesh.triangles[i];
    char* at = putVector(file.grow(50), triangleNormal(surface.mesh, t));
    for (const std::uint32_t v : t) at = putVector(at, surface.vertex(v));
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
  file.write("# " + surface.unitName() + "\n");
  forRows(surface.mesh.vertices.size(), progress.part(0.0, 0.5), [&](std::size_t i) {
    char* at = putText(line.data(), "v");
    const Vec3 vertex = surface.isFar() ? surface.farVertex(i) : surface.vertex(i);
    for (const double value : vertex) {
      at = putText(at, " ");
      at = surface.isFar() ? std::to_chars(at, end, value).ptr : std::to_chars(at, end, static_cast<float>(value)).ptr;
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

void writeAs3mf(const Surface& surface, AtomicFile& file, const Progress& progress) {
  std::vector<std::uint8_t> invented;
  if (surface.marksInvented())
    for (const std::uint32_t view : surface.model->triangleView) invented.push_back(view == kNoIndex ? 1 : 0);
  writeThreeMf(surface.mesh, invented, surface.options.unit, file, progress);
}

void exportSurface(const Surface& surface, const std::string& path, const Progress& progress) {
  checkIndices(surface.mesh);
  if (surface.options.unit != LengthUnit::Millimetre && surface.options.unit != LengthUnit::Inch)
    throw InvalidInput("models are written in millimetres or inches");
  const std::string extension = extensionOf(path);
  if (extension != "ply" && extension != "stl" && extension != "obj" && extension != "3mf")
    throw InvalidInput(path + ": has the extension " + inQuotes(extension) + ", expected .ply, .stl, .obj or .3mf");
  AtomicFile file(path);
  if (extension == "ply") writePly(surface, file, progress);
  if (extension == "stl") writeStl(surface, file, progress);
  if (extension == "obj") writeObj(surface, file, progress);
  if (extension == "3mf") writeAs3mf(surface, file, progress);
  file.commit();
  progress.checkpoint(1.0);
}

bool isOneOf(const std::string& path, std::initializer_list<std::string_view> extensions) {
  return std::find(extensions.begin(), extensions.end(), extensionOf(path)) != extensions.end();
}

}  // namespace

void exportModelAs(const Model& model, const std::string& path, const ExportOptions& options,
                   const Progress& progress) {
  const std::size_t vertices = model.mesh.vertices.size();
  if (model.confidence.size() != vertices || model.triangleView.size() != model.mesh.triangles.size())
    throw InvalidInput("the model's confidences and views do not match its vertices and triangles");
  if (!options.colours.empty() && options.colours.size() != vertices)
    throw InvalidInput("the model has " + std::to_string(options.colours.size()) + " colours for " +
                       std::to_string(vertices) + " vertices");
  if (!options.invented.empty() && options.invented.size() != vertices)
    throw InvalidInput("the model has " + std::to_string(options.invented.size()) + " marks for " +
                       std::to_string(vertices) + " vertices");
  exportSurface({model.mesh, &model, options}, path, progress);
}

void exportModel(const Model& model, const std::string& path, const Progress& progress, const Vec3& offset,
                 const VertexColours& colours) {
  ExportOptions options;
  options.offset = offset;
  options.colours = colours;
  exportModelAs(model, path, options, progress);
}

bool holdsInvented(const std::string& path) {
  return isOneOf(path, {"ply", "3mf"});
}

bool holdsOffset(const std::string& path) {
  return !isOneOf(path, {"stl", "3mf"});
}

bool holdsColours(const std::string& path) {
  return !isOneOf(path, {"stl", "3mf"});
}

void exportMesh(const Mesh& mesh, const std::string& path, const Progress& progress) {
  exportSurface({mesh, nullptr}, path, progress);
}

}  // namespace vantage
