#include "io/three_mf_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/errors.h"
#include "io/zip_writer.h"

namespace vantage {
namespace {

constexpr std::size_t kRowsPerCheckpoint = 65536;
constexpr std::size_t kPiece = 1U << 16;

constexpr std::string_view kContentTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";
constexpr std::string_view kRelations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
    "</Relationships>\n";

std::string_view unitName(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Millimetre:
      return "millimeter";
    case LengthUnit::Centimetre:
      return "centimeter";
    case LengthUnit::Inch:
      return "inch";
    case LengthUnit::Metre:
      break;
  }
  return "meter";
}

// Text that goes into a member piece by piece.
class Text {
 public:
  explicit Text(PackedMember& member) : member_(member) {}
  ~Text() = default;
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  Text& operator<<(std::string_view text) {
    text_ += text;
    if (text_.size() >= kPiece) flush();
    return *this;
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number> Text& operator<<(Number number) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return *this << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }
  void flush() {
    member_.write(text_);
    text_.clear();
  }

 private:
  PackedMember& member_;
  std::string text_;
};

void writeVertices(Text& text, const Mesh& mesh, LengthUnit unit, const Progress& progress) {
  const double scale = 1.0 / millimetresIn(unit);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (i % kRowsPerCheckpoint == 0)
      progress.checkpoint(static_cast<double>(i) / static_cast<double>(mesh.vertices.size()));
    const Eigen::Vector3f p = (scale * mesh.vertices[i]).cast<float>();
    if (!p.allFinite())
      throw InvalidInput("vertex " + std::to_string(i) + " has a coordinate that is not finite, which 3MF cannot hold");
    text << "<vertex x=\"" << p.x() << "\" y=\"" << p.y() << "\" z=\"" << p.z() << "\"/>\n";
  }
}

void writeTriangles(Text& text, const Mesh& mesh, std::span<const std::uint8_t> invented, const Progress& progress) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % kRowsPerCheckpoint == 0)
      progress.checkpoint(static_cast<double>(i) / static_cast<double>(mesh.triangles.size()));
    const Triangle& t = mesh.triangles[i];
    text << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"";
    if (!invented.empty() && invented[i] != 0) text << " pid=\"1\" p1=\"1\"";
    text << "/>\n";
  }
}

}  // namespace

void writeThreeMf(const Mesh& mesh, std::span<const std::uint8_t> invented, LengthUnit unit, AtomicFile& file,
                  const Progress& progress) {
  const bool marks = std::find(invented.begin(), invented.end(), 1) != invented.end();
  PackedMember types("[Content_Types].xml");
  types.write(kContentTypes);
  PackedMember relations("_rels/.rels");
  relations.write(kRelations);
  PackedMember model("3D/3dmodel.model");
  Text text(model);
  text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" << unitName(unit)
       << "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
          "<metadata name=\"Application\">Vantage</metadata>\n<resources>\n";
  if (marks)
    text << "<basematerials id=\"1\"><base name=\"measured\" displaycolor=\"#C8C8C8\"/>"
            "<base name=\"invented\" displaycolor=\"#E69F00\"/></basematerials>\n";
  text << "<object id=\"2\" type=\"model\""
       << (marks ? std::string_view(" pid=\"1\" pindex=\"0\"") : std::string_view()) << "><mesh>\n<vertices>\n";
  writeVertices(text, mesh, unit, progress.part(0.0, 0.4));
  text << "</vertices>\n<triangles>\n";
  writeTriangles(text, mesh, marks ? invented : std::span<const std::uint8_t>(), progress.part(0.4, 0.9));
  text << "</triangles>\n</mesh></object>\n</resources>\n<build><item objectid=\"2\"/></build>\n</model>\n";
  text.flush();
  ZipWriter zip(file);
  zip.add(std::move(types));
  zip.add(std::move(relations));
  zip.add(std::move(model));
  zip.finish();
  progress.checkpoint(1.0);
}

}  // namespace vantage
