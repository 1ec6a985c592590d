#include "io/scan_poses.h"

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

ScanPose readRecord(TextScanner& text, double scale) {
  ScanPose pose;
  pose.file = text.fieldOnLine();
  std::array<double, 7> n{};
  for (double& value : n) {
    const std::string_view field = text.fieldOnLine();
    const auto number = parseNumber(field);
    if (!number || !std::isfinite(*number))
      text.fail("bmesh " + inQuotes(pose.file) + " has " + inQuotes(field) +
                ", expected the seven numbers tx ty tz qx qy qz qw");
    value = *number;
  }
  const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
  if (std::abs(q.norm() - 1.0) > kUnitTolerance)
    text.fail("bmesh " + inQuotes(pose.file) + " has a quaternion of length " + std::to_string(q.norm()) +
              ", expected 1");
  pose.T_object_scanner.linear() = q.normalized().toRotationMatrix().transpose();
  pose.T_object_scanner.translation() = scale * Vec3(n[0], n[1], n[2]);
  return pose;
}

std::string nameOf(const std::string& file) {
  const std::filesystem::path name = std::filesystem::path(file).filename();
  return extensionOf(name.string()) == "ply" ? name.stem().string() : name.string();
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
