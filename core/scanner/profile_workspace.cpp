#include "scanner/profile_workspace.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/errors.h"
#include "scanner/number_table.h"

namespace vantage {
namespace {

constexpr std::size_t kMaxPositions = 100'000;

// The pose of the 12 or 16 numbers of a matrix, row by row. `what` names it in messages.
Pose checkedPose(std::span<const double> numbers, const std::string& what) {
  if (numbers.size() != 12 && numbers.size() != 16)
    throw InvalidInput(what + " has " + std::to_string(numbers.size()) +
                       " numbers, expected the 12 or 16 of a matrix, row by row");
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t k = 0; k < numbers.size(); ++k)
    matrix(static_cast<Eigen::Index>(k / 4), static_cast<Eigen::Index>(k % 4)) = numbers[k];
  Pose pose(matrix);
  const Eigen::Matrix3d r = pose.linear();
  const bool rigid = matrix.allFinite() && (r * r.transpose()).isIdentity(1e-4) && r.determinant() > 0.0 &&
                     (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() < 1e-6;
  if (!rigid) throw InvalidInput(what + " is not a rigid motion, expected a rotation and a translation");
  if (pose.translation().cwiseAbs().maxCoeff() > kMaxCoordinate)
    throw InvalidInput(what + " stands farther out than " + std::to_string(static_cast<long>(kMaxCoordinate)) +
                       " mm, expected a scanner near the object");
  pose.linear() = Eigen::Quaterniond(r).normalized().toRotationMatrix();
  return pose;
}

// The numbers of a matrix given as 12 or 16 numbers or as 3 or 4 rows of 4.
std::vector<double> matrixNumbers(const nlohmann::json& matrix, const JsonObjectReader& reader) {
  const auto expected = "4 x 4 matrices of numbers, row by row";
  if (!matrix.is_array() || matrix.size() > 16) reader.fail("matrices", expected);
  std::vector<double> numbers;
  auto append = [&](const nlohmann::json& number) {
    if (!number.is_number()) reader.fail("matrices", expected);
    numbers.push_back(number.get<double>());
  };
  for (const auto& item : matrix) {
    if (item.is_array()) {
      if (item.size() != 4) reader.fail("matrices", expected);
      for (const auto& number : item) append(number);
    } else {
      append(item);
    }
  }
  return numbers;
}

Workspace readPoses(JsonObjectReader& reader, const ProfileSource& source) {
  Workspace workspace;
  if (reader.has("file")) {
    const std::string file = reader.fileName("file");
    const NumberTable table = parseNumberTable(attachment(source, file), file, kMaxPositions, 16);
    for (std::size_t i = 0; i < table.rows(); ++i)
      workspace.poses.push_back(checkedPose(table.row(i), file + ": pose " + std::to_string(i)));
  } else {
    const nlohmann::json& list = reader.required("matrices", "a list of 4 x 4 matrices, or a file that holds them");
    if (!list.is_array() || list.size() > kMaxPositions)
      reader.fail("matrices", "a list of at most " + std::to_string(kMaxPositions) + " matrices");
    for (std::size_t i = 0; i < list.size(); ++i)
      workspace.poses.push_back(
          checkedPose(matrixNumbers(list[i], reader), source.path + ": /workspace/matrices/" + std::to_string(i)));
  }
  if (workspace.poses.empty()) throw InvalidInput(source.path + ": /workspace has no pose, expected at least one");
  return workspace;
}

Workspace readTiltTurntable(JsonObjectReader& reader) {
  const int steps = reader.integer("steps", 1, 36000);
  std::vector<double> tilts;
  for (const double tilt : reader.numbers("tilts_deg", 1, 180)) {
    if (std::abs(tilt) > 90.0) reader.fail("tilts_deg", "angles from -90 to 90");
    tilts.push_back(radians(tilt));
  }
  if (static_cast<std::size_t>(steps) * tilts.size() > kMaxPositions)
    reader.fail("steps", "at most " + std::to_string(kMaxPositions) + " positions over all tilts");
  const Vec3 centre = reader.has("tilt_center") ? reader.vector("tilt_center") : Vec3(0, 0, 150);
  return turntableWithTilt(steps, tilts, centre);
}

}  // namespace

const std::string& attachment(const ProfileSource& source, const std::string& name) {
  const auto it = source.attachments.find(name);
  if (it == source.attachments.end()) throw IoError(source.path, "names the file " + name + ", which was not read");
  return it->second;
}

Workspace readWorkspace(JsonObjectReader reader, const ProfileSource& source) {
  const std::string type = reader.string("type");
  Workspace workspace;
  if (type == "turntable") {
    workspace = turntable(reader.integer("steps", 1, 36000));
  } else if (type == "turntable_tilt") {
    workspace = readTiltTurntable(reader);
  } else if (type == "poses") {
    workspace = readPoses(reader, source);
  } else {
    reader.fail("type", "one of turntable, turntable_tilt, poses");
  }
  reader.finish();
  return workspace;
}

}  // namespace vantage
