#include "io/ply_document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/errors.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kRowsPerCheckpoint = 65536;

template <typename T>
double valueAt(const char* from, bool swapped) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<T>(bytes));
}

double valueAt(const char* from, PlyType type, bool swapped) {
  switch (type) {
    case PlyType::Int8:
      return valueAt<std::int8_t>(from, swapped);
    case PlyType::UInt8:
      return valueAt<std::uint8_t>(from, swapped);
    case PlyType::Int16:
      return valueAt<std::int16_t>(from, swapped);
    case PlyType::UInt16:
      return valueAt<std::uint16_t>(from, swapped);
    case PlyType::Int32:
      return valueAt<std::int32_t>(from, swapped);
    case PlyType::UInt32:
      return valueAt<std::uint32_t>(from, swapped);
    case PlyType::Float32:
      return valueAt<float>(from, swapped);
    case PlyType::Float64:
      break;
  }
  return valueAt<double>(from, swapped);
}

// Gives the values of the body one after the other.
class BinaryValues {
 public:
  BinaryValues(const FileBytes& file, const PlyHeader& header)
      : file_(file), at_(header.bodyOffset), swapped_(header.format == PlyFormat::BinaryBigEndian) {}

  double next(PlyType type, const PlyElement& element, std::size_t row) {
    need(sizeOf(type), 1, element, row);
    const double value = valueAt(file_.text().data() + at_, type, swapped_);
    at_ += sizeOf(type);
    return value;
  }

  void skip(PlyType type, std::size_t count, const PlyElement& element, std::size_t row) {
    need(sizeOf(type), count, element, row);
    at_ += sizeOf(type) * count;
  }

  // Throws unless `count` values can follow.
  void need(std::size_t size, std::size_t count, const PlyElement& element, std::size_t row) const {
    if (count <= (file_.size() - at_) / size) return;
    fail("the file ends within row " + std::to_string(row) + " of the " + std::to_string(element.count) +
         " rows of element " + inQuotes(element.name));
  }

  [[nodiscard]] std::size_t leftOver() { return file_.size() - at_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidInput(file_.path() + ": byte " + std::to_string(at_) + ": " + what);
  }

 private:
  const FileBytes& file_;
  std::size_t at_;
  bool swapped_;
};

class TextValues {
 public:
  TextValues(const FileBytes& file, const PlyHeader& header)
      : end_(file.text().data() + file.size()),
        left_(file.size() - header.bodyOffset),
        text_(file.text().substr(header.bodyOffset), file.path(), header.bodyLine) {}

  double next(PlyType type, const PlyElement& element, std::size_t row) {
    const std::string_view field = text_.field();
    const auto value = parseDecimal(field);
    if (field.empty())
      text_.fail("the file ends within row " + std::to_string(row) + " of the " + std::to_string(element.count) +
                 " rows of element " + inQuotes(element.name));
    if (!value || !fits(*value, type))
      text_.fail(inQuotes(field) + " is no value of its property in element " + inQuotes(element.name));
    return *value;
  }

  void skip(PlyType type, std::size_t count, const PlyElement& element, std::size_t row) {
    for (std::size_t i = 0; i < count; ++i) static_cast<void>(next(type, element, row));
  }

  // A value takes a digit and a separator at least.
  void need(std::size_t /*size*/, std::size_t count, const PlyElement& element, std::size_t row) const {
    if (count <= left_ / 2 + 1) return;
    text_.fail("a list of " + std::to_string(count) + " values in row " + std::to_string(row) + " of element " +
               inQuotes(element.name) + " is longer than the file");
  }

  [[nodiscard]] std::size_t leftOver() {
    const std::string_view next = text_.field();
    return next.empty() ? 0 : static_cast<std::size_t>(end_ - next.data());
  }

  [[noreturn]] void fail(const std::string& what) const { text_.fail(what); }

 private:
  static bool fits(double value, PlyType type) {
    const int bits = 8 * static_cast<int>(sizeOf(type));
    switch (type) {
      case PlyType::Float32:
      case PlyType::Float64:
        return true;
      case PlyType::Int8:
      case PlyType::Int16:
      case PlyType::Int32:
        return value == std::floor(value) && value >= -std::ldexp(1.0, bits - 1) && value < std::ldexp(1.0, bits - 1);
      default:
        return value == std::floor(value) && value >= 0.0 && value < std::ldexp(1.0, bits);
    }
  }

  const char* end_;
  std::size_t left_;
  TextScanner text_;
};

template <typename Values>
void readProperty(Values& values, const PlyElement& element, const PlyProperty& property, std::size_t row,
                  PlyColumn* column) {
  if (!property.isList()) {
    const double value = values.next(property.type, element, row);
    if (column != nullptr) column->values.push_back(value);
    return;
  }
  const double length = values.next(*property.listCount, element, row);
  if (length < 0.0)
    values.fail("a list in row " + std::to_string(row) + " of element " + inQuotes(element.name) +
                " has a negative length");
  const auto count = static_cast<std::size_t>(length);
  values.need(sizeOf(property.type), count, element, row);
  if (column == nullptr) return values.skip(property.type, count, element, row);
  for (std::size_t i = 0; i < count; ++i) column->values.push_back(values.next(property.type, element, row));
  column->start.push_back(column->values.size());
}

template <typename Values>
PlyDocument::Columns readBody(Values& values, const PlyHeader& header, const std::vector<std::vector<bool>>& wanted,
                              const Progress& progress) {
  PlyDocument::Columns columns(header.elements.size());
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    columns[e].resize(element.properties.size());
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (!wanted[e][p]) continue;
      PlyColumn& column = columns[e][p].emplace();
      column.values.reserve(element.count);
      if (element.properties[p].isList()) column.start.assign(1, 0);
    }
    for (std::size_t row = 0; row < element.count; ++row) {
      if (row % kRowsPerCheckpoint == 0)
        progress.checkpoint(static_cast<double>(row) / static_cast<double>(element.count));
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        readProperty(values, element, element.properties[p], row, columns[e][p] ? &*columns[e][p] : nullptr);
    }
  }
  return columns;
}

}  // namespace

PlyDocument::PlyDocument(PlyHeader header, Columns columns, std::size_t bytesLeftOver)
    : header_(std::move(header)), columns_(std::move(columns)), bytesLeftOver_(bytesLeftOver) {}

const PlyColumn* PlyDocument::find(std::string_view element, std::string_view property) const {
  for (std::size_t e = 0; e < header_.elements.size(); ++e) {
    if (header_.elements[e].name != element) continue;
    for (std::size_t p = 0; p < columns_[e].size(); ++p)
      if (columns_[e][p] && header_.elements[e].properties[p].name == property) return &*columns_[e][p];
  }
  return nullptr;
}

PlyDocument readPlyDocument(const FileBytes& file, std::span<const PlySelection> wanted, const Progress& progress) {
  const PlyHeader header = parsePlyHeader(file.text(), file.size(), file.path());
  std::vector<std::vector<bool>> selected;
  for (const PlyElement& element : header.elements) {
    selected.emplace_back();
    for (const PlyProperty& property : element.properties)
      selected.back().push_back(std::any_of(wanted.begin(), wanted.end(), [&](const PlySelection& s) {
        return s.element == element.name && s.property == property.name;
      }));
  }
  const auto read = [&](auto values) {
    PlyDocument::Columns columns = readBody(values, header, selected, progress);
    return PlyDocument(header, std::move(columns), values.leftOver());
  };
  return header.format == PlyFormat::Ascii ? read(TextValues(file, header)) : read(BinaryValues(file, header));
}

}  // namespace vantage
