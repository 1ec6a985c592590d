#include "io/pcd_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "io/lzf.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::size_t kMaxFields = 1000;
constexpr std::size_t kMaxRowBytes = 1U << 16;
constexpr double kUnitTolerance = 1e-2;

struct PcdField {
  std::string name;
  std::size_t size = 4;
  char type = 'F';
  std::size_t count = 1;

  [[nodiscard]] std::size_t bytes() const { return size * count; }
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::optional<std::size_t> width;
  std::optional<std::size_t> height;
  std::optional<std::size_t> points;
  std::optional<Pose> viewpoint;
  std::string data;
  std::size_t bodyOffset = 0;
  std::size_t bodyLine = 1;
};

class PcdHeaderReader {
 public:
  PcdHeaderReader(const FileBytes& file, bool anyPoints)
      : file_(file), anyPoints_(anyPoints), text_(file.text(), file.path()) {}

  PcdHeader read() {
    do {
      const std::string_view key = text_.fieldOnLine();
      if (key.empty() || key.starts_with('#') || key == "VERSION") continue;
      readLine(key);
      if (key == "DATA") return finish();
    } while (text_.nextLine());
    text_.fail("the PCD header has no line DATA");
  }

 private:
  void readLine(std::string_view key) {
    if (key == "FIELDS" || key == "COLUMNS") return readFields();
    if (key == "SIZE") return forFields([&](PcdField& field) { field.size = count(8); });
    if (key == "COUNT") return forFields([&](PcdField& field) { field.count = count(kMaxRowBytes); });
    if (key == "TYPE") return forFields([&](PcdField& field) { field.type = typeOf(text_.fieldOnLine()); });
    if (key == "WIDTH") header_.width = count(kMaxGridCells);
    if (key == "HEIGHT") header_.height = count(kMaxGridCells);
    if (key == "POINTS") header_.points = count(kMaxGridCells);
    if (key == "VIEWPOINT") header_.viewpoint = readViewpoint();
    if (key == "DATA") header_.data = text_.fieldOnLine();
  }

  void readFields() {
    for (std::string_view name = text_.fieldOnLine(); !name.empty(); name = text_.fieldOnLine()) {
      if (header_.fields.size() == kMaxFields) text_.fail("PCD file has more than 1000 fields");
      header_.fields.push_back({std::string(name)});
    }
  }

  template <typename Reader>
  void forFields(const Reader& reader) {
    for (PcdField& field : header_.fields) reader(field);
  }

  std::size_t count(std::size_t most) {
    const std::string_view field = text_.fieldOnLine();
    const auto value = parseInteger(field);
    if (!value || *value < 1 || *value > static_cast<std::int64_t>(most))
      text_.fail("the PCD header has " + inQuotes(field) + ", expected a whole number from 1 to " +
                 std::to_string(most));
    return static_cast<std::size_t>(*value);
  }

  char typeOf(std::string_view field) const {
    if (field != "F" && field != "I" && field != "U")
      text_.fail("the PCD header has the type " + inQuotes(field) + ", expected F, I or U");
    return field[0];
  }

  Pose readViewpoint() {
    std::array<double, 7> n{};
    for (double& value : n) {
      const std::string_view field = text_.fieldOnLine();
      const auto number = parseDecimal(field);
      if (!number || !std::isfinite(*number))
        text_.fail("VIEWPOINT has " + inQuotes(field) + ", expected the seven numbers tx ty tz qw qx qy qz");
      value = *number;
    }
    const Eigen::Quaterniond q(n[3], n[4], n[5], n[6]);
    if (std::abs(q.norm() - 1.0) > kUnitTolerance)
      text_.fail("VIEWPOINT has a quaternion of length " + std::to_string(q.norm()) + ", expected 1");
    Pose pose = Pose::Identity();
    pose.linear() = q.normalized().toRotationMatrix();
    pose.translation() = Vec3(n[0], n[1], n[2]);
    return pose;
  }

  PcdHeader finish() {
    if (header_.fields.empty() || !header_.width || !header_.height)
      text_.fail("the PCD header has no FIELDS, WIDTH or HEIGHT before DATA");
    std::size_t row = 0;
    for (const PcdField& field : header_.fields) row += field.bytes();
    if (row > kMaxRowBytes) text_.fail("a point of the PCD file has " + std::to_string(row) + " bytes, at most 65536");
    if (!anyPoints_ && (*header_.height < 2 || *header_.width < 2))
      throw InvalidInput(file_.path() + ": is a PCD point cloud of " + std::to_string(*header_.width) + " x " +
                         std::to_string(*header_.height) +
                         " points, without rows and columns: expected an organised one with WIDTH and HEIGHT above 1");
    if (header_.points.value_or(*header_.width * *header_.height) != *header_.width * *header_.height)
      text_.fail("PCD file: POINTS is " + std::to_string(*header_.points) +
                 ", expected WIDTH x HEIGHT = " + std::to_string(*header_.width * *header_.height));
    if (*header_.width * *header_.height > kMaxGridCells || *header_.width * *header_.height > kMaxFileBytes / row)
      text_.fail("the PCD file has too many points or bytes");
    header_.bodyOffset =
        static_cast<std::size_t>(text_.restOfLine().data() - file_.text().data()) + text_.restOfLine().size();
    skipLineEnd();
    header_.bodyLine = text_.line() + 1;
    return std::move(header_);
  }

  // The line ends with LF or CR LF; what follows a lone CR could be data.
  void skipLineEnd() {
    const std::string_view rest = file_.text().substr(header_.bodyOffset);
    header_.bodyOffset += rest.starts_with("\r\n") ? 2U : rest.empty() ? 0U : 1U;
  }

  const FileBytes& file_;
  bool anyPoints_;
  TextScanner text_;
  PcdHeader header_;
};

// Where x, y and z are among the fields.
std::array<std::size_t, 3> coordinatesOf(const PcdHeader& header, const std::string& path) {
  std::array<std::size_t, 3> found{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view wanted = std::string_view("xyz").substr(k, 1);
    while (found[k] < header.fields.size() && header.fields[found[k]].name != wanted) ++found[k];
    if (found[k] == header.fields.size() || header.fields[found[k]].count != 1)
      throw InvalidInput(path + ": the PCD header has no field " + inQuotes(wanted) + ", expected x, y and z");
    const PcdField& field = header.fields[found[k]];
    if (field.type != 'F' || (field.size != 4 && field.size != 8))
      throw InvalidInput(path + ": the field " + inQuotes(wanted) + " of the PCD file is no number of 4 or 8 bytes");
  }
  return found;
}

double valueAt(const char* from, std::size_t size) {
  if (size == 8) {
    double value = 0.0;
    std::memcpy(&value, from, sizeof(value));
    return value;
  }
  float value = 0.0F;
  std::memcpy(&value, from, sizeof(value));
  return static_cast<double>(value);
}

// The field "rgb" or "rgba" of four bytes, packed as 0xAARRGGBB.
std::optional<std::size_t> colourOf(const PcdHeader& header) {
  for (std::size_t f = 0; f < header.fields.size(); ++f) {
    const PcdField& field = header.fields[f];
    if ((field.name == "rgb" || field.name == "rgba") && field.size == 4 && field.count == 1) return f;
  }
  return std::nullopt;
}

Colour unpacked(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16 & 0xFFU), static_cast<std::uint8_t>(rgb >> 8 & 0xFFU),
          static_cast<std::uint8_t>(rgb & 0xFFU)};
}

// A packed colour that stands there as a whole number, or as the floating point number of the same bits.
Colour colourIn(double value, char type) {
  if (type == 'F') return unpacked(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  if (type == 'I') return unpacked(static_cast<std::uint32_t>(static_cast<std::int64_t>(value)));
  return unpacked(static_cast<std::uint32_t>(std::clamp(value, 0.0, 4294967295.0)));
}

struct PcdPoints {
  std::vector<Vec3> points;
  std::vector<Colour> colours;  // empty where the file has none
};

// What a point is made of.
struct PcdPlaces {
  std::array<std::size_t, 3> coordinates;
  std::optional<std::size_t> colour;
};

PcdPoints readAscii(const FileBytes& file, const PcdHeader& header, const PcdPlaces& wanted, const Progress& progress) {
  constexpr std::size_t kPerCheckpoint = 65536;
  const std::size_t count = *header.width * *header.height;
  if (count > file.size() - header.bodyOffset + 1)
    throw InvalidInput(file.path() + ": the PCD file ends early: it has no room for its " + std::to_string(count) +
                       " points");
  TextScanner text(file.text().substr(header.bodyOffset), file.path(), header.bodyLine);
  PcdPoints read{std::vector<Vec3>(count), std::vector<Colour>(wanted.colour ? count : 0)};
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kPerCheckpoint == 0) progress.checkpoint(static_cast<double>(i) / static_cast<double>(count));
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      for (std::size_t n = 0; n < header.fields[f].count; ++n) {
        const std::string_view field = text.field();
        const auto value = parseDecimal(field);
        if (!value)
          text.fail(field.empty() ? "the PCD file ends within point " + std::to_string(i)
                                  : inQuotes(field) + " is no number");
        for (int k = 0; k < 3; ++k)
          if (wanted.coordinates[static_cast<std::size_t>(k)] == f) read.points[i][k] = *value;
        if (wanted.colour == f && std::isfinite(*value)) read.colours[i] = colourIn(*value, header.fields[f].type);
      }
    }
  }
  return read;
}

// Fields of one point lie beside each other, or, unpacked, all values of a field.
PcdPoints readBinary(std::string_view body, const PcdHeader& header, const PcdPlaces& wanted, bool byField) {
  const std::size_t count = *header.width * *header.height;
  std::vector<std::size_t> before(header.fields.size() + 1, 0);
  for (std::size_t f = 0; f < header.fields.size(); ++f) before[f + 1] = before[f] + header.fields[f].bytes();
  const auto at = [&](std::size_t f, std::size_t i) {
    const std::size_t start = byField ? before[f] * count : before[f];
    return body.data() + start + i * (byField ? header.fields[f].bytes() : before.back());
  };
  PcdPoints read{std::vector<Vec3>(count), std::vector<Colour>(wanted.colour ? count : 0)};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t f = wanted.coordinates[k];
    for (std::size_t i = 0; i < count; ++i)
      read.points[i][static_cast<Eigen::Index>(k)] = valueAt(at(f, i), header.fields[f].size);
  }
  for (std::size_t i = 0; i < read.colours.size(); ++i) {
    std::uint32_t rgb = 0;
    std::memcpy(&rgb, at(*wanted.colour, i), sizeof(rgb));
    read.colours[i] = unpacked(rgb);
  }
  return read;
}

std::size_t bodyBytes(const PcdHeader& header) {
  std::size_t row = 0;
  for (const PcdField& field : header.fields) row += field.bytes();
  return row * *header.width * *header.height;
}

std::string unpackBody(const FileBytes& file, const PcdHeader& header) {
  const std::string_view body = file.text().substr(header.bodyOffset);
  std::array<std::uint32_t, 2> sizes{};
  if (body.size() < sizeof(sizes)) throw InvalidInput(file.path() + ": the PCD file ends before its packed points");
  std::memcpy(sizes.data(), body.data(), sizeof(sizes));
  if (sizes[0] > body.size() - sizeof(sizes) || sizes[1] != bodyBytes(header))
    throw InvalidInput(file.path() + ": the packed points of the PCD file have " + std::to_string(sizes[0]) + " and " +
                       std::to_string(sizes[1]) + " bytes, expected at most " +
                       std::to_string(body.size() - sizeof(sizes)) + " and " + std::to_string(bodyBytes(header)));
  return unpackLzf(body.substr(sizeof(sizes), sizes[0]), sizes[1], file.path() + ": the packed part of the PCD file");
}

PcdPoints readPoints(const FileBytes& file, const PcdHeader& header, const Progress& progress) {
  const PcdPlaces wanted{coordinatesOf(header, file.path()), colourOf(header)};
  if (header.data == "ascii") return readAscii(file, header, wanted, progress);
  if (header.data == "binary_compressed") return readBinary(unpackBody(file, header), header, wanted, true);
  if (header.data != "binary")
    throw InvalidInput(file.path() + ": the PCD header has DATA " + inQuotes(header.data) +
                       ", expected ascii, binary or binary_compressed");
  const std::string_view body = file.text().substr(header.bodyOffset);
  if (body.size() < bodyBytes(header))
    throw InvalidInput(file.path() + ": the PCD file is truncated: its points need " +
                       std::to_string(bodyBytes(header)) + " bytes, but only " + std::to_string(body.size()) +
                       " are left");
  return readBinary(body, header, wanted, false);
}

}  // namespace

GridFile readPcd(const FileBytes& bytes, bool anyPoints, const Progress& progress) {
  const PcdHeader header = PcdHeaderReader(bytes, anyPoints).read();
  GridFile file;
  PcdPoints read = readPoints(bytes, header, progress);
  file.organised = *header.height > 1 && *header.width > 1;
  if (file.organised) {
    file.samples = gridOf(*header.height, *header.width, std::move(read.points), bytes.path());
    file.samples.colours = std::move(read.colours);
  } else {
    file.samples = scatteredPoints(std::move(read.points), std::move(read.colours));
  }
  file.inMetres = true;
  if (header.viewpoint && !header.viewpoint->isApprox(Pose::Identity(), 1e-12)) file.T_world_scanner = header.viewpoint;
  return file;
}

}  // namespace vantage
