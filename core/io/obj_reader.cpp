#include "io/obj_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

// What a corner's field names: position, texture coordinate, normal; and which of the three it has.
struct Corner {
  std::array<std::int64_t, 3> index{};
  int form = 0;
};

std::optional<Corner> parseCorner(std::string_view field) {
  Corner corner;
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = field.find('/');
    const std::string_view number = field.substr(0, slash);
    if (!number.empty()) {
      const auto value = parseInteger(number);
      if (!value || *value == 0) return std::nullopt;
      corner.index[static_cast<std::size_t>(part)] = *value;
      corner.form |= 1 << part;
    }
    if (slash == std::string_view::npos) return (corner.form & 1) != 0 ? std::optional(corner) : std::nullopt;
    field.remove_prefix(slash + 1);
  }
  return std::nullopt;
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& path, const Progress& progress)
      : size_(static_cast<double>(text.size())), text_(text, path), progress_(progress) {}

  PolygonSoup read() {
    std::size_t lines = 0;
    do {
      // A line has ten bytes or more on average; that is near enough for a progress bar.
      if (lines++ % 65536 == 0) progress_.checkpoint(std::min(1.0, 10.0 * static_cast<double>(lines) / size_));
      const std::string_view keyword = text_.fieldOnLine();
      if (keyword == "v") readVertex();
      if (keyword == "vt") ++attributes_[1];
      if (keyword == "vn") ++attributes_[2];
      if (keyword == "f" || keyword == "fo") readFace();
      skipContinued();
    } while (text_.nextLine());
    markMissing();
    return std::move(soup_);
  }

 private:
  // A backslash at the end of a line joins it with the next one.
  std::string_view field() {
    for (;;) {
      std::string_view found = text_.fieldOnLine();
      if (found != "\\") return found;
      if (!text_.nextLine()) return {};
    }
  }

  void skipContinued() {
    while (text_.restOfLine().ends_with('\\') && text_.nextLine()) {
    }
  }

  void readVertex() {
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view text = field();
      if (text.empty()) text_.fail("a vertex has " + std::to_string(k) + " coordinates, expected 3");
      p[k] = parseNumber(text).value_or(std::numeric_limits<double>::quiet_NaN());
    }
    soup_.points.push_back(p);
    attributes_[0] = static_cast<std::int64_t>(soup_.points.size());
  }

  void readFace() {
    int form = 0;
    std::size_t corners = 0;
    for (std::string_view text = field(); !text.empty() && text[0] != '#'; text = field()) {
      const auto corner = parseCorner(text);
      if (!corner || (corners > 0 && corner->form != form))
        text_.fail(inQuotes(text) +
                   " is no corner of a face, expected v, v/vt, v//vn or v/vt/vn with indices other than 0, the same "
                   "for all corners");
      form = corner->form;
      addCorner(*corner);
      ++corners;
    }
    if (corners < 3) text_.fail("a face has " + std::to_string(corners) + " corners, expected at least 3");
    soup_.endPolygon();
  }

  // Relative indices count back from the last one so far. Faces may come before what they name, so existence is checked
  // at the end; the largest index of each kind per face is enough for that.
  void addCorner(const Corner& corner) {
    if (highest_.size() == soup_.ends.size()) highest_.push_back({0, 0});
    std::int64_t position = corner.index[0];
    if (position < 0) position += attributes_[0] + 1;
    const bool possible = position > 0 && position < static_cast<std::int64_t>(kNoIndex);
    soup_.corners.push_back(possible ? static_cast<std::uint32_t>(position - 1) : kNoIndex);
    for (std::size_t part = 1; part < 3; ++part) {
      std::int64_t index = corner.index[part];
      if (index < 0) index += attributes_[part] + 1;
      if (corner.index[part] < 0 && index <= 0) index = std::numeric_limits<std::int64_t>::max();
      highest_.back()[part - 1] = std::max(highest_.back()[part - 1], index);
    }
  }

  // Faces that name a texture coordinate or normal beyond those of the file lose their corners too: the file is damaged
  // there. Exporters that leave all of them out are common and harmless.
  void markMissing() {
    for (std::size_t f = 0; f < highest_.size(); ++f)
      for (std::size_t part = 1; part < 3; ++part)
        if (attributes_[part] > 0 && highest_[f][part - 1] > attributes_[part])
          soup_.corners[soup_.ends[f] - 1] = kNoIndex;
  }

  double size_;
  TextScanner text_;
  const Progress& progress_;
  std::array<std::int64_t, 3> attributes_{};  // how many v, vt, vn so far
  std::vector<std::array<std::int64_t, 2>> highest_;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup readObjSoup(const FileBytes& file, const Progress& progress) {
  const std::string converted = asciiFromUtf16(file.text());
  std::string_view text = converted.empty() ? file.text() : std::string_view(converted);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    throw InvalidInput(file.path() + ": byte " + std::to_string(zero) + " is 0, expected the text of an OBJ file");
  return ObjReader(text, file.path(), progress).read();
}

}  // namespace vantage
