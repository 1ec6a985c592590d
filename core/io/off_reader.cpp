#include "io/off_reader.h"

#include <limits>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

// "0 0 0" and "3 0 1 2" with their line ends.
constexpr std::size_t kLeastVertexBytes = 6;
constexpr std::size_t kLeastFaceBytes = 8;

class OffReader {
 public:
  OffReader(const FileBytes& file, const Progress& progress)
      : path_(file.path()), size_(file.size()), text_(file.text(), file.path()), progress_(progress) {}

  PolygonSoup read() {
    readKeyword();
    const std::size_t vertices = readCount("the number of vertices");
    const std::size_t faces = readCount("the number of faces");
    nextLine();  // the number of edges is not needed
    if (vertices > size_ / kLeastVertexBytes || faces > (size_ - kLeastVertexBytes * vertices) / kLeastFaceBytes + 1)
      throw InvalidInput(path_ + ": declares " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                         " faces, more than its " + std::to_string(size_) + " bytes can hold");
    const double rows = static_cast<double>(vertices + faces);
    for (std::size_t i = 0; i < vertices; ++i) {
      if (i % 65536 == 0) progress_.checkpoint(static_cast<double>(i) / rows);
      readVertex(i, vertices);
    }
    for (std::size_t i = 0; i < faces; ++i) {
      if (i % 65536 == 0) progress_.checkpoint(static_cast<double>(vertices + i) / rows);
      readFace(i, faces);
    }
    return std::move(soup_);
  }

 private:
  // A field of the line before its comment; empty at its end.
  std::string_view fieldOnLine() {
    if (inComment_) return {};
    const std::string_view field = text_.fieldOnLine();
    const std::size_t comment = field.find('#');
    inComment_ = comment != std::string_view::npos;
    return field.substr(0, comment);
  }

  bool nextLine() {
    inComment_ = false;
    return text_.nextLine();
  }

  // The first field of the next line that has one; empty at the end of the file.
  std::string_view nextField() {
    for (;;) {
      const std::string_view field = fieldOnLine();
      if (!field.empty() || !nextLine()) return field;
    }
  }

  void readKeyword() {
    std::string_view field = nextField();
    if (field.starts_with("\xef\xbb\xbf")) field.remove_prefix(3);
    const std::string_view whole = field;
    if (field.starts_with("ST")) field.remove_prefix(2);
    if (field.starts_with("C")) field.remove_prefix(1);
    if (field.starts_with("N")) field.remove_prefix(1);
    if (!field.starts_with("OFF")) text_.fail(inQuotes(whole) + " stands where the keyword OFF was expected");
    pending_ = field.substr(3);
  }

  std::size_t readCount(const std::string& what) {
    const std::string_view field = pending_.empty() ? nextField() : pending_;
    pending_ = {};
    if (lowerCase(field) == "binary") text_.fail("the file is a binary OFF, expected a text OFF");
    const auto value = parseInteger(field);
    if (!value || *value < 0) text_.fail(inQuotes(field) + " stands where " + what + " was expected");
    return static_cast<std::size_t>(*value);
  }

  void readVertex(std::size_t i, std::size_t count) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view field = k == 0 ? nextField() : fieldOnLine();
      if (field.empty())
        text_.fail("vertex " + std::to_string(i) + " of " + std::to_string(count) + " has " + std::to_string(k) +
                   " coordinates, expected 3");
      p[k] = parseNumber(field).value_or(std::numeric_limits<double>::quiet_NaN());
    }
    soup_.points.push_back(p);
    nextLine();
  }

  void readFace(std::size_t i, std::size_t count) {
    const auto corners = parseInteger(nextField());
    if (!corners || *corners < 0)
      text_.fail("face " + std::to_string(i) + " of " + std::to_string(count) +
                 " is missing, expected its number of corners");
    for (std::int64_t k = 0; k < *corners; ++k) {
      const auto index = parseInteger(fieldOnLine());
      if (!index)
        text_.fail("face " + std::to_string(i) + " has " + std::to_string(k) + " corners, expected " +
                   std::to_string(*corners));
      const bool exists = *index >= 0 && static_cast<std::size_t>(*index) < soup_.points.size();
      soup_.corners.push_back(exists ? static_cast<std::uint32_t>(*index) : kNoIndex);
    }
    soup_.endPolygon();
    nextLine();
  }

  const std::string& path_;
  std::size_t size_;
  TextScanner text_;
  const Progress& progress_;
  std::string_view pending_;
  bool inComment_ = false;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup readOffSoup(const FileBytes& file, const Progress& progress) {
  return OffReader(file, progress).read();
}

}  // namespace vantage
