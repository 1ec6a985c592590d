#include "io/stl_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kCountBytes = 4;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kNormalBytes = 12;

static_assert(std::endian::native == std::endian::little, "binary files are copied as they are");

void reserveTriangles(PolygonSoup& soup, std::size_t triangles) {
  soup.points.reserve(3 * triangles);
  soup.corners.reserve(3 * triangles);
  soup.ends.reserve(triangles);
}

void addPoint(PolygonSoup& soup, const Vec3& p) {
  soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
  soup.points.push_back(p);
}

PolygonSoup readBinary(const FileBytes& file, std::size_t count, const Progress& progress) {
  PolygonSoup soup;
  soup.bytesLeftOver = file.size() - kHeaderBytes - kCountBytes - kTriangleBytes * count;
  reserveTriangles(soup, count);
  const char* at = file.text().data() + kHeaderBytes + kCountBytes;
  for (std::size_t t = 0; t < count; ++t, at += kTriangleBytes) {
    if (t % 65536 == 0) progress.checkpoint(static_cast<double>(t) / static_cast<double>(count));
    std::array<float, 9> v;
    std::memcpy(v.data(), at + kNormalBytes, sizeof(v));
    for (std::size_t k = 0; k < 9; k += 3) addPoint(soup, Vec3(v[k], v[k + 1], v[k + 2]));
    soup.endPolygon();
  }
  return soup;
}

class AsciiStl {
 public:
  AsciiStl(const FileBytes& file, const Progress& progress)
      : size_(static_cast<double>(file.size())), text_(file.text(), file.path()), progress_(progress) {}

  PolygonSoup read() {
    bool inSolid = false;
    for (std::string_view field = text_.field(); !field.empty(); field = text_.field()) {
      const std::string word = lowerCase(field);
      if (word == "solid" || word == "endsolid") {
        inSolid = word == "solid";
        text_.nextLine();  // a name follows, which may be any words
      } else if (word == "facet") {
        readFacet();
      }  // some programs add words of their own between facets
    }
    if (inSolid) text_.fail("the file ends, expected 'endsolid': it is truncated");
    return std::move(soup_);
  }

 private:
  void readFacet() {
    if (soup_.ends.size() % 16384 == 0)
      progress_.checkpoint(std::min(1.0, 250.0 * static_cast<double>(soup_.ends.size()) / size_));
    skipTo("outer");  // the normal is recomputed
    expect("loop");
    std::string_view field = text_.field();
    while (lowerCase(field) == "vertex") {
      Vec3 p;
      for (int k = 0; k < 3; ++k) {
        const auto value = parseNumber(text_.fieldOnLine());
        p[k] = value.value_or(std::numeric_limits<double>::quiet_NaN());
      }
      addPoint(soup_, p);
      field = text_.field();
    }
    if (lowerCase(field) != "endloop") failExpected(field, "vertex or endloop");
    skipTo("endfacet");
    soup_.endPolygon();
  }

  void skipTo(std::string_view word) {
    for (std::string_view field = text_.field(); lowerCase(field) != word; field = text_.field())
      if (field.empty() || lowerCase(field) == "facet" || lowerCase(field) == "endsolid") failExpected(field, word);
  }

  void expect(std::string_view word) {
    const std::string_view field = text_.field();
    if (lowerCase(field) != word) failExpected(field, word);
  }

  [[noreturn]] void failExpected(std::string_view field, std::string_view expected) const {
    text_.fail((field.empty() ? "the file ends" : inQuotes(field) + " stands") + std::string(" where ") +
               std::string(expected) + " was expected");
  }

  double size_;
  TextScanner text_;
  const Progress& progress_;
  PolygonSoup soup_;
};

bool looksLikeText(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 1024);
  const std::size_t begin = head.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && lowerCase(head.substr(begin, 5)) == "solid" &&
         head.find('\0') == std::string_view::npos;
}

}  // namespace

PolygonSoup readStlSoup(const FileBytes& file, const Progress& progress) {
  const std::string_view bytes = file.text();
  std::uint32_t count = 0;
  const bool hasCount = bytes.size() >= kHeaderBytes + kCountBytes;
  if (hasCount) std::memcpy(&count, bytes.data() + kHeaderBytes, kCountBytes);
  const std::size_t expected = kHeaderBytes + kCountBytes + kTriangleBytes * static_cast<std::size_t>(count);
  if (hasCount && bytes.size() == expected) return readBinary(file, count, progress);
  if (looksLikeText(bytes)) return AsciiStl(file, progress).read();
  if (hasCount && count > 0 && bytes.size() > expected) return readBinary(file, count, progress);
  if (!hasCount)
    throw InvalidInput(file.path() + ": has " + std::to_string(bytes.size()) +
                       " bytes, a binary STL has at least 84 and an ASCII STL begins with 'solid'");
  throw InvalidInput(file.path() + ": byte 80: the STL declares " + std::to_string(count) + " triangles, which take " +
                     std::to_string(expected) + " bytes, but the file has " + std::to_string(bytes.size()));
}

}  // namespace vantage
