#include "scanner/calibration_file.h"

#include <cmath>
#include <fstream>
#include <utility>

#include "base/errors.h"
#include "scanner/profile_reader.h"

namespace vantage {
namespace {

// Farther from the normal of the table plane no axis of a table leans [deg].
constexpr double kMostLean = 30.0;
constexpr std::size_t kMaxFileBytes = 1U << 20;

nlohmann::ordered_json triple(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vec3 readDirection(JsonObjectReader& reader, const std::string& key) {
  const Vec3 v = reader.vector(key);
  if (v.norm() < 1e-9) reader.fail(key, "a direction: three numbers that are not all 0");
  return v.normalized();
}

void readPlane(JsonObjectReader& reader, TableCalibration& calibration) {
  const auto numbers = reader.numbers("table_plane", 4, 4);
  const Vec3 normal(numbers[0], numbers[1], numbers[2]);
  const double length = normal.norm();
  if (!(length > 1e-9 && length < 1e9 && std::abs(numbers[3] / length) < kMaxCoordinate))
    reader.fail("table_plane", "[nx, ny, nz, d] with nx x + ny y + nz z + d = 0 on the table, within 100 m");
  calibration.planeNormal = normal / length;
  calibration.planeOffset = numbers[3] / length;
}

CalibrationVerdict readVerdict(JsonObjectReader& reader) {
  const std::string text = reader.string("verdict");
  for (const auto verdict : {CalibrationVerdict::Good, CalibrationVerdict::Doubtful, CalibrationVerdict::Failed})
    if (text == name(verdict)) return verdict;
  reader.fail("verdict", "one of good, doubtful, failed");
}

}  // namespace

nlohmann::ordered_json calibrationJson(const TableCalibration& c) {
  nlohmann::ordered_json json;
  json["axis"] = {{"point", triple(c.axisPoint)},
                  {"direction", triple(c.axisDirection)},
                  {"sigma_mm", c.sigma},
                  {"sigma_deg", degrees(c.angleSigma)}};
  json["table_plane"] = {c.planeNormal.x(), c.planeNormal.y(), c.planeNormal.z(), c.planeOffset};
  json["sense"] = c.sense;
  json["degrees_per_commanded_degree"] = c.degreesPerCommandedDegree;
  json["residual_mm"] = c.residual;
  json["verdict"] = name(c.verdict);
  return json;
}

TableCalibration readCalibration(JsonObjectReader reader) {
  TableCalibration c;
  JsonObjectReader axis = reader.object("axis");
  c.axisPoint = axis.vector("point");
  c.axisDirection = readDirection(axis, "direction");
  c.sigma = axis.number("sigma_mm", 0.0, 1e5);
  c.angleSigma = radians(axis.number("sigma_deg", 0.0, 360.0));
  axis.finish();
  readPlane(reader, c);
  if (c.axisDirection.dot(c.planeNormal) < std::cos(radians(kMostLean)))
    reader.fail("table_plane", "a plane that the axis stands on: its normal within 30 degrees of the axis's direction");
  c.sense = reader.integer("sense", -1, 1);
  if (c.sense == 0) reader.fail("sense", "1 or -1");
  c.degreesPerCommandedDegree = reader.number("degrees_per_commanded_degree", 1e-3, 1e3);
  c.residual = reader.number("residual_mm", 0.0, 1e5);
  c.verdict = readVerdict(reader);
  reader.finish();
  return c;
}

TableCalibration loadCalibration(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path, "cannot be opened for reading, expected a calibration file");
  std::string text(kMaxFileBytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw IoError(path, "cannot be read");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > kMaxFileBytes) throw IoError(path, "is larger than a calibration file can be");
  const nlohmann::json document = parseJson(text, path);
  return readCalibration(JsonObjectReader(document, path, ""));
}

std::string calibrationText(const TableCalibration& calibration) {
  return calibrationJson(calibration).dump(2) + "\n";
}

ProfileSource withCalibration(ProfileSource source, const TableCalibration& calibration) {
  if (!parseJson(source.text, source.path).is_object())
    throw InvalidInput(source.path + ": is not a JSON object, expected a scanner profile");
  auto document = nlohmann::ordered_json::parse(source.text);
  document["calibration"] = calibrationJson(calibration);
  source.text = document.dump(2) + "\n";
  return source;
}

}  // namespace vantage
