#include "io/scan_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "io/file_bytes.h"
#include "io/file_kind.h"
#include "io/text_scanner.h"

namespace vantage {
namespace {

constexpr std::uintmax_t kMaxListBytes = 16ULL << 20;
constexpr double kUnitTolerance = 1e-2;
constexpr std::size_t kNumbers = 7;

bool isQuote(char c) {
  return c == '"' || c == '\'';
}

// Says what stands where the numbers were expected.
[[noreturn]] void failRecord(const TextScanner& text, const std::vector<std::string>& fields) {
  std::string wrong;
  for (std::size_t i = 1; i < fields.size() && wrong.empty(); ++i)
    if (const auto number = parseNumber(fields[i]); !number || !std::isfinite(*number)) wrong = fields[i];
  text.fail("bmesh " + inQuotes(fields.empty() ? std::string() : fields.front()) + " has " + inQuotes(wrong) +
            ", expected a file, in quotes where it has blanks, and the seven numbers tx ty tz qx qy qz qw");
}

// A field of a record; one in quotes may hold blanks.
std::vector<std::string> fieldsOf(std::string_view line) {
  std::vector<std::string> fields;
  TextScanner text(line, {});
  for (std::string_view field = text.fieldOnLine(); !field.empty(); field = text.fieldOnLine()) {
    if (!isQuote(field.front())) {
      fields.emplace_back(field);
      continue;
    }
    const auto begin = static_cast<std::size_t>(field.data() - line.data());
    const std::size_t end = line.find(field.front(), begin + 1);
    if (end == std::string_view::npos) return {};
    fields.emplace_back(line.substr(begin + 1, end - begin - 1));
    text = TextScanner(line.substr(end + 1), {});
    line.remove_prefix(end + 1);
  }
  return fields;
}

bool isNumber(const std::string& field) {
  const auto number = parseNumber(field);
  return number && std::isfinite(*number);
}

// Where the seven numbers begin: a name may have blanks, and words that are numbers.
std::optional<std::size_t> numbersIn(const std::vector<std::string>& fields) {
  const auto areNumbers = [&](std::size_t from) {
    return std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(from),
                       fields.begin() + static_cast<std::ptrdiff_t>(from + kNumbers), isNumber);
  };
  if (fields.size() <= kNumbers) return std::nullopt;
  if (areNumbers(fields.size() - kNumbers)) return fields.size() - kNumbers;
  for (std::size_t i = 1; i + kNumbers <= fields.size(); ++i)
    if (areNumbers(i)) return i;
  return std::nullopt;
}

// What stands between the keyword and the numbers, as it stands there.
std::string nameIn(std::string_view line, const std::vector<std::string>& fields, std::size_t numbers) {
  if (numbers == 1) return fields.front();
  TextScanner text(line, {});
  const std::string_view first = text.fieldOnLine();
  std::string_view last = first;
  for (std::size_t i = 1; i < numbers; ++i) last = text.fieldOnLine();
  return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

ScanPose readRecord(TextScanner& text, double scale) {
  const std::string_view line = text.restOfLine();
  const std::vector<std::string> fields = fieldsOf(line);
  const auto numbers = numbersIn(fields);
  if (!numbers) failRecord(text, fields);
  ScanPose pose;
  pose.file = nameIn(line, fields, *numbers);
  std::array<double, kNumbers> n{};
  for (std::size_t i = 0; i < kNumbers; ++i) n[i] = *parseNumber(fields[*numbers + i]);
  const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
  if (std::abs(q.norm() - 1.0) > kUnitTolerance)
    text.fail("bmesh " + inQuotes(pose.file) + " has a quaternion of length " + std::to_string(q.norm()) +
              ", expected 1");
  pose.T_object_scanner.linear() = q.normalized().toRotationMatrix().transpose();
  pose.T_object_scanner.translation() = scale * Vec3(n[0], n[1], n[2]);
  return pose;
}

// The extensions of range files are no part of a name.
std::string nameOf(const std::string& file) {
  const std::filesystem::path name = std::filesystem::path(file).filename();
  const std::string extension = extensionOf(name.string());
  const bool known = extension == "ply" || extension == "pcd" || extension == "ptx";
  return known ? name.stem().string() : name.string();
}

}  // namespace

std::vector<ScanPose> readScanPoses(const std::string& path, double scale) {
  const FileBytes file(path, kMaxListBytes);
  TextScanner text(file.text(), path);
  std::vector<ScanPose> poses;
  do {
    if (text.fieldOnLine() == "bmesh") poses.push_back(readRecord(text, scale));
  } while (text.nextLine());
  if (poses.empty())
    throw InvalidInput(path + ": has no line 'bmesh FILE tx ty tz qx qy qz qw', expected a list of scan poses");
  return poses;
}

std::optional<Pose> findPose(const std::vector<ScanPose>& poses, const std::string& rangeFile) {
  for (const ScanPose& pose : poses)
    if (nameOf(pose.file) == nameOf(rangeFile)) return pose.T_object_scanner;
  return std::nullopt;
}

}  // namespace vantage
