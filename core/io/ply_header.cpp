#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/errors.h"
#include "io/file_bytes.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kMaxProperties = 1000;
// Of UTF-8; some editors write it before a header.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames{{{"char", PlyType::Int8},
                                                                           {"int8", PlyType::Int8},
                                                                           {"uchar", PlyType::UInt8},
                                                                           {"uint8", PlyType::UInt8},
                                                                           {"short", PlyType::Int16},
                                                                           {"int16", PlyType::Int16},
                                                                           {"ushort", PlyType::UInt16},
                                                                           {"uint16", PlyType::UInt16},
                                                                           {"int", PlyType::Int32},
                                                                           {"int32", PlyType::Int32},
                                                                           {"uint", PlyType::UInt32},
                                                                           {"uint32", PlyType::UInt32},
                                                                           {"float", PlyType::Float32},
                                                                           {"float32", PlyType::Float32},
                                                                           {"double", PlyType::Float64},
                                                                           {"float64", PlyType::Float64}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, std::size_t fileSize, const std::string& path)
      : bytes_(bytes), fileSize_(fileSize), path_(path) {}

  PlyHeader parse() {
    if (bytes_.starts_with(kByteOrderMark))
      fail("begins with a byte order mark (BOM), which an editor put before 'ply': save the file without it");
    if (!readLine() || line_ != "ply") fail("is " + inQuotes(line_) + ", expected 'ply'");
    while (true) {
      if (!readLine()) fail("the header does not end, expected 'end_header'");
      TextScanner fields(line_, path_, number_);
      const std::string_view keyword = fields.fieldOnLine();
      if (keyword == "end_header") break;
      parseLine(keyword, fields);
    }
    if (!hasFormat_) fail("the header has no 'format' line");
    if (header_.elements.empty()) fail("the header has no 'element' line, so the file has no geometry");
    header_.bodyOffset = at_;
    header_.bodyLine = number_ + 1;
    checkCounts();
    return std::move(header_);
  }

 private:
  // A binary body may begin with the byte of a line end. Where lines end with CR, LF is not part of the end; where they
  // end with LF or CR LF, a CR with LF behind it is one end.
  bool readLine() {
    if (at_ >= bytes_.size()) return false;
    const std::size_t stop = bytes_.substr(0, kMaxPlyHeaderBytes).find_first_of("\r\n", at_);
    const bool ended = stop != std::string_view::npos;
    if (!ended && bytes_.size() >= kMaxPlyHeaderBytes) fail("the header does not end within its first megabyte");
    line_ = bytes_.substr(at_, ended ? stop - at_ : std::string_view::npos);
    at_ = ended ? stop + 1 : bytes_.size();
    const bool pair = ended && bytes_[stop] == '\r' && at_ < bytes_.size() && bytes_[at_] == '\n';
    if (number_ == 0) endsInReturns_ = ended && bytes_[stop] == '\r' && !pair;
    if (pair && !endsInReturns_) ++at_;
    ++number_;
    return true;
  }

  void parseLine(std::string_view keyword, TextScanner& fields) {
    const std::string_view rest = fields.restOfLine().substr(fields.restOfLine().starts_with(' ') ? 1 : 0);
    if (keyword == "comment") {
      header_.comments.emplace_back(rest);
    } else if (keyword == "obj_info") {
      header_.objInfo.emplace_back(rest);
    } else if (keyword == "format") {
      parseFormat(fields);
    } else if (keyword == "element") {
      parseElement(fields);
    } else if (keyword == "property") {
      parseProperty(fields);
    } else {
      fail(inQuotes(line_) +
           " is no line of a PLY header, expected comment, obj_info, format, element, property or end_header");
    }
  }

  void parseFormat(TextScanner& fields) {
    const std::string_view name = fields.fieldOnLine();
    const std::string_view version = fields.fieldOnLine();
    if (hasFormat_) fail("the format is given twice");
    if (name == "ascii") {
      header_.format = PlyFormat::Ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::BinaryLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::BinaryBigEndian;
    } else {
      fail(inQuotes(name) + " is no PLY format, expected ascii, binary_little_endian or binary_big_endian");
    }
    if (version != "1.0") fail("the format's version is " + inQuotes(version) + ", expected '1.0'");
    hasFormat_ = true;
    expectEnd(fields);
  }

  void parseElement(TextScanner& fields) {
    const std::string name(fields.fieldOnLine());
    const std::string_view countField = fields.fieldOnLine();
    const auto count = parseInteger(countField);
    if (name.empty() || !count || *count < 0)
      fail("the element's count is " + inQuotes(countField) +
           ", expected 'element NAME COUNT' with a count of 0 or more");
    if (header_.find(name) != nullptr) fail("the element " + inQuotes(name) + " is given twice");
    header_.elements.push_back({name, static_cast<std::size_t>(*count), {}});
    expectEnd(fields);
  }

  void parseProperty(TextScanner& fields) {
    if (header_.elements.empty()) fail("a property comes before any element");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    std::string_view type = fields.fieldOnLine();
    if (type == "list") {
      property.listCount = parseType(fields.fieldOnLine());
      if (*property.listCount == PlyType::Float32 || *property.listCount == PlyType::Float64)
        fail("a list's length has a floating point type, expected an integer type");
      type = fields.fieldOnLine();
    }
    property.type = parseType(type);
    property.name = fields.fieldOnLine();
    if (property.name.empty()) fail("the property has no name");
    if (element.find(property.name) != nullptr)
      fail("the property " + inQuotes(property.name) + " is given twice in the element " + inQuotes(element.name));
    if (element.properties.size() == kMaxProperties)
      fail("the element " + inQuotes(element.name) + " has more than " + std::to_string(kMaxProperties) +
           " properties");
    element.properties.push_back(std::move(property));
    expectEnd(fields);
  }

  PlyType parseType(std::string_view name) const {
    const auto it = std::find_if(kTypeNames.begin(), kTypeNames.end(), [&](const auto& t) { return t.first == name; });
    if (it == kTypeNames.end()) fail(inQuotes(name) + " is no PLY type, expected char ... double or int8 ... float64");
    return it->second;
  }

  void expectEnd(TextScanner& fields) const {
    const std::string_view extra = fields.fieldOnLine();
    if (!extra.empty()) fail("the line goes on with " + inQuotes(extra) + ", expected its end");
  }

  // A value takes at least its bytes, or a digit and a separator (the last one of the file none).
  void checkCounts() const {
    const std::size_t available = fileSize_ - header_.bodyOffset + (header_.format == PlyFormat::Ascii ? 1 : 0);
    std::size_t needed = 0;
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0) continue;
      const std::string what =
          "the element " + inQuotes(element.name) + " with " + std::to_string(element.count) + " rows";
      if (element.properties.empty()) throw InvalidInput(path_ + ": " + what + " has no properties");
      const std::size_t row =
          header_.format == PlyFormat::Ascii ? 2 * element.properties.size() : element.leastRowBytes();
      if (element.count > (available - needed) / row)
        throw InvalidInput(path_ + ": " + what + " needs at least " + std::to_string(row) + " bytes a row, but only " +
                           std::to_string(available - needed) + " are left: the file is truncated or its header wrong");
      needed += element.count * row;
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidInput(path_ + ": PLY header, line " + std::to_string(number_) + ": " + what);
  }

  std::string_view bytes_;
  std::size_t fileSize_;
  const std::string& path_;
  PlyHeader header_;
  std::string_view line_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  bool endsInReturns_ = false;
  bool hasFormat_ = false;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

const PlyProperty* PlyElement::find(std::string_view property) const {
  for (const PlyProperty& p : properties)
    if (p.name == property) return &p;
  return nullptr;
}

bool PlyElement::hasLists() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.isList(); });
}

std::size_t PlyElement::leastRowBytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& p : properties) bytes += sizeOf(p.listCount.value_or(p.type));
  return bytes;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const PlyElement& e : elements)
    if (e.name == element) return &e;
  return nullptr;
}

std::optional<std::string> PlyHeader::info(std::string_view key) const {
  for (const std::string& text : objInfo) {
    TextScanner fields(text, {});
    if (fields.fieldOnLine() == key) return std::string(fields.fieldOnLine());
  }
  return std::nullopt;
}

bool looksLikePly(std::string_view bytes) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  return bytes.starts_with("ply") && (bytes.size() == 3 || bytes[3] == '\n' || bytes[3] == '\r');
}

PlyHeader parsePlyHeader(std::string_view bytes, std::size_t fileSize, const std::string& path) {
  return HeaderParser(bytes, fileSize, path).parse();
}

PlyHeader readPlyHeader(const std::string& path) {
  return parsePlyHeader(readHead(path, kMaxPlyHeaderBytes), checkedFileSize(path), path);
}

}  // namespace vantage
