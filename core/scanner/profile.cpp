#include "scanner/profile.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/errors.h"
#include "scanner/profile_reader.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

// No profile needs more: larger files are something else.
constexpr std::uintmax_t kMaxProfileBytes = 16ULL << 20;
constexpr std::uintmax_t kMaxTableBytes = 1ULL << 30;
constexpr std::size_t kMaxRays = 16'000'000;
constexpr std::size_t kMaxPositions = 100'000;
constexpr std::size_t kMaxReceivers = 16;

std::string readWholeFile(const std::string& path, std::uintmax_t limit) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw IoError(path, "is a folder, expected a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path, "cannot be opened for reading");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > limit)
    throw IoError(path, "has " + std::to_string(size) + " bytes, more than the " + std::to_string(limit) + " allowed");
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

nlohmann::json parseJson(const ProfileSource& source) {
  try {
    return nlohmann::json::parse(source.text);
  } catch (const nlohmann::json::exception& e) {
    std::string what = e.what();
    if (const auto at = what.find("] "); at != std::string::npos) what = what.substr(at + 2);
    std::string clean;
    for (const char ch : what) clean += static_cast<unsigned char>(ch) < 0x20 || static_cast<unsigned char>(ch) > 0x7e ? '?' : ch;
    throw InvalidInput(source.path + ": is not a JSON profile: " + clean);
  }
}

const std::string& attachment(const ProfileSource& source, const std::string& name) {
  const auto it = source.attachments.find(name);
  if (it == source.attachments.end()) throw IoError(source.path, "names the file " + name + ", which was not read");
  return it->second;
}

// Rows of comma or space separated numbers; blank lines and lines that begin with # or a letter (a header) are skipped.
std::vector<std::vector<double>> parseTable(const std::string& text, const std::string& file) {
  std::vector<std::vector<double>> rows;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    for (char& ch : line)
      if (ch == ',' || ch == ';' || ch == '\t' || ch == '\r') ch = ' ';
    const auto start = line.find_first_not_of(' ');
    if (start == std::string::npos || line[start] == '#') continue;
    if (rows.empty() && std::isalpha(static_cast<unsigned char>(line[start])) != 0 && line.compare(start, 3, "nan") != 0)
      continue;
    std::vector<double> row;
    std::istringstream fields(line);
    std::string field;
    while (fields >> field) {
      char* end = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      if (end == field.c_str() || *end != 0 || !std::isfinite(value))
        throw InvalidInput(file + ": line " + std::to_string(number) + " has '" + field.substr(0, 40) +
                           "', expected a finite number");
      row.push_back(value);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

ReceiverOffsets readReceivers(JsonObjectReader& scanner) {
  return scanner.has("receivers") ? scanner.vectors("receivers", kMaxReceivers) : ReceiverOffsets{};
}

void checkRayCount(JsonObjectReader& scanner, const std::string& key, int rows, int columns) {
  if (static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) > kMaxRays)
    scanner.fail(key, "a grid of at most " + std::to_string(kMaxRays) + " rays");
}

template <typename Stripe>
Stripe readStripe(JsonObjectReader& scanner) {
  Stripe s{};
  s.position = scanner.vector("position");
  s.stripeHeight = scanner.number("stripe_height_mm", 0.0, 1e5, true);
  s.samplesPerStripe = scanner.integer("samples_per_stripe", 2, 100000);
  s.stripes = scanner.integer("stripes", 2, 100000);
  checkRayCount(scanner, "stripes", s.samplesPerStripe, s.stripes);
  return s;
}

RayGrid readPinhole(JsonObjectReader& scanner) {
  Pinhole s{};
  s.position = scanner.vector("position");
  s.lookAt = scanner.vector("look_at");
  s.rows = scanner.integer("rows", 2, 100000);
  s.columns = scanner.integer("columns", 2, 100000);
  checkRayCount(scanner, "columns", s.rows, s.columns);
  s.horizontalFov = radians(scanner.number("horizontal_fov_deg", 0.0, 170.0, true));
  s.verticalFov = radians(scanner.number("vertical_fov_deg", 0.0, 170.0, true));
  const Vec3 forward = s.lookAt - s.position;
  if (forward.norm() < 1e-6) scanner.fail("look_at", "a point other than position");
  if (forward.normalized().cross(Vec3::UnitZ()).norm() < 1e-6)
    scanner.fail("look_at", "a point that is not straight above or below position");
  return makeRays(s, readReceivers(scanner));
}

RayGrid readRayTable(JsonObjectReader& scanner, const ProfileSource& source) {
  const std::string file = scanner.string("file");
  const int rows = scanner.integer("rows", 2, 100000);
  const int columns = scanner.integer("columns", 2, 100000);
  checkRayCount(scanner, "columns", rows, columns);
  const auto table = parseTable(attachment(source, file), file);
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  if (table.size() != count)
    throw InvalidInput(file + ": has " + std::to_string(table.size()) + " rays, expected rows x columns = " +
                       std::to_string(count));
  std::vector<RangingRay> rays;
  std::vector<Vec3> receivers;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto& row = table[i];
    if (row.size() < 6 || row.size() % 3 != 0 || row.size() != table[0].size() || row.size() > 6 + 3 * kMaxReceivers)
      throw InvalidInput(file + ": ray " + std::to_string(i) + " has " + std::to_string(row.size()) +
                         " numbers, expected ox,oy,oz,dx,dy,dz and three for every receiver");
    const Vec3 direction(row[3], row[4], row[5]);
    if (!(direction.norm() > 1e-9))
      throw InvalidInput(file + ": ray " + std::to_string(i) + " has the direction 0, expected a vector with a length");
    rays.push_back({Vec3(row[0], row[1], row[2]), direction.normalized()});
    for (std::size_t k = 6; k < row.size(); k += 3) receivers.emplace_back(row[k], row[k + 1], row[k + 2]);
  }
  return {rows, columns, std::move(rays), std::move(receivers), static_cast<int>(table[0].size() / 3) - 2};
}

RayGrid readRays(JsonObjectReader& scanner, const std::string& type, const ProfileSource& source) {
  if (type == "rotating_stripe") {
    auto s = readStripe<RotatingStripe>(scanner);
    s.sweep = radians(scanner.number("sweep_deg", 0.0, 170.0, true));
    return makeRays(s, readReceivers(scanner));
  }
  if (type == "linear_stripe") {
    auto s = readStripe<LinearStripe>(scanner);
    s.travel = scanner.number("travel_mm", 0.0, 1e5, true);
    return makeRays(s, readReceivers(scanner));
  }
  if (type == "pinhole") return readPinhole(scanner);
  if (type == "rays") return readRayTable(scanner, source);
  scanner.fail("type", "one of rotating_stripe, linear_stripe, pinhole, rays");
}

void readScanner(JsonObjectReader scanner, const ProfileSource& source, ScannerProfile& profile) {
  profile.type = scanner.string("type");
  profile.rays = std::make_shared<const RayGrid>(readRays(scanner, profile.type, source));
  profile.breakdownAngle = radians(scanner.number("breakdown_angle_deg", 0.0, 90.0, true));
  const auto range = scanner.numbers("range_mm", 2, 2);
  if (!(range[0] >= 0.0 && range[0] < range[1] && range[1] <= 1e6))
    scanner.fail("range_mm", "[nearest, farthest] with 0 <= nearest < farthest <= 1000000");
  profile.minRange = range[0];
  profile.maxRange = range[1];
  if (scanner.has("noise")) {
    JsonObjectReader noise = scanner.object("noise");
    profile.noise.rangeSigma = noise.number("range_sigma_mm", 0.0, 1000.0, false, 0.0);
    profile.noise.dropout = noise.number("dropout", 0.0, 1.0, false, 0.0);
    noise.finish();
  }
  scanner.finish();
}

Pose checkedPose(const std::vector<double>& m, const std::string& what) {
  if (m.size() != 12 && m.size() != 16)
    throw InvalidInput(what + " has " + std::to_string(m.size()) + " numbers, expected the 12 or 16 of a matrix, row by row");
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t k = 0; k < m.size(); ++k)
    matrix(static_cast<Eigen::Index>(k / 4), static_cast<Eigen::Index>(k % 4)) = m[k];
  Pose pose(matrix);
  const Eigen::Matrix3d r = pose.linear();
  if (!matrix.allFinite() || !(r * r.transpose()).isIdentity(1e-4) || r.determinant() < 0.0 ||
      !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1)))
    throw InvalidInput(what + " is not a rigid motion, expected a rotation and a translation");
  pose.linear() = Eigen::Quaterniond(r).normalized().toRotationMatrix();
  return pose;
}

Workspace readPoses(JsonObjectReader& reader, const ProfileSource& source) {
  Workspace workspace;
  if (reader.has("file")) {
    const std::string file = reader.string("file");
    const auto table = parseTable(attachment(source, file), file);
    for (std::size_t i = 0; i < table.size(); ++i)
      workspace.poses.push_back(checkedPose(table[i], file + ": pose " + std::to_string(i)));
  } else {
    const nlohmann::json& list = reader.required("matrices", "a list of 4 x 4 matrices, or a file that holds them");
    if (!list.is_array()) reader.fail("matrices", "a list of 4 x 4 matrices");
    for (std::size_t i = 0; i < list.size(); ++i) {
      std::vector<double> numbers;
      const auto flat = list[i].flatten();
      for (const auto& v : flat) {
        if (!v.is_number()) reader.fail("matrices", "matrices of numbers, row by row");
        numbers.push_back(v.get<double>());
      }
      workspace.poses.push_back(checkedPose(numbers, source.path + ": /workspace/matrices/" + std::to_string(i)));
    }
  }
  if (workspace.poses.empty() || workspace.poses.size() > kMaxPositions)
    throw InvalidInput(source.path + ": /workspace has " + std::to_string(workspace.poses.size()) +
                       " poses, expected 1 to " + std::to_string(kMaxPositions));
  return workspace;
}

Workspace readWorkspace(JsonObjectReader reader, const ProfileSource& source) {
  const std::string type = reader.string("type");
  Workspace workspace;
  if (type == "turntable") {
    workspace = turntable(reader.integer("steps", 1, 36000));
  } else if (type == "turntable_tilt") {
    const int steps = reader.integer("steps", 1, 36000);
    std::vector<double> tilts;
    for (const double tilt : reader.numbers("tilts_deg", 1, 180)) {
      if (std::abs(tilt) > 90.0) reader.fail("tilts_deg", "angles from -90 to 90");
      tilts.push_back(radians(tilt));
    }
    if (static_cast<std::size_t>(steps) * tilts.size() > kMaxPositions)
      reader.fail("steps", "at most " + std::to_string(kMaxPositions) + " positions in all");
    const Vec3 centre = reader.has("tilt_center") ? reader.vector("tilt_center") : Vec3(0, 0, 150);
    workspace = turntableWithTilt(steps, tilts, centre);
  } else if (type == "poses") {
    workspace = readPoses(reader, source);
  } else {
    reader.fail("type", "one of turntable, turntable_tilt, poses");
  }
  reader.finish();
  return workspace;
}

PositionalSpaceSize readPositionalSpace(JsonObjectReader reader) {
  PositionalSpaceSize size;
  const std::string surface = reader.string("surface");
  if (surface == "sphere") {
    size.surface = PositionalSpaceSurface::Sphere;
  } else if (surface != "cylinder") {
    reader.fail("surface", "cylinder or sphere");
  }
  size.rows = reader.integer("rows", 1, 1000);
  size.columns = reader.integer("columns", 3, 3600);
  if (size.rows * size.columns > 200'000) reader.fail("columns", "at most 200000 cells in all");
  reader.finish();
  return size;
}

}  // namespace

ProfileSource readProfileSource(const std::string& path) {
  ProfileSource source;
  source.path = path;
  source.text = readWholeFile(path, kMaxProfileBytes);
  const nlohmann::json document = parseJson(source);
  if (!document.is_object()) return source;
  for (const char* part : {"scanner", "workspace"}) {
    const auto object = document.find(part);
    if (object == document.end() || !object->is_object()) continue;
    const auto file = object->find("file");
    if (file == object->end() || !file->is_string()) continue;
    const auto name = file->get<std::string>();
    const std::filesystem::path beside = std::filesystem::path(path).parent_path() / name;
    source.attachments[name] = readWholeFile(beside.string(), kMaxTableBytes);
  }
  return source;
}

ScannerProfile parseProfile(const ProfileSource& source) {
  const nlohmann::json document = parseJson(source);
  JsonObjectReader reader(document, source.path, "");
  ScannerProfile profile;
  profile.name = reader.string("name");
  readScanner(reader.object("scanner"), source, profile);
  profile.workspace = readWorkspace(reader.object("workspace"), source);
  if (reader.has("viewing_volume")) {
    JsonObjectReader volume = reader.object("viewing_volume");
    profile.viewingVolume.radius = volume.number("radius_mm", 0.0, 1e5, true);
    profile.viewingVolume.height = volume.number("height_mm", 0.0, 1e5, true);
    volume.finish();
  }
  if (reader.has("positional_space")) profile.positionalSpace = readPositionalSpace(reader.object("positional_space"));
  if (reader.has("mechanics")) {
    JsonObjectReader mechanics = reader.object("mechanics");
    profile.mechanics.angleSigma = radians(mechanics.number("angle_sigma_deg", 0.0, 90.0, false, 0.0));
    profile.mechanics.positionSigma = mechanics.number("position_sigma_mm", 0.0, 1000.0, false, 0.0);
    mechanics.finish();
  }
  reader.finish();
  return profile;
}

ScannerProfile loadProfile(const std::string& path) {
  return parseProfile(readProfileSource(path));
}

}  // namespace vantage
