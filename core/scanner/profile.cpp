#include "scanner/profile.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/plain_text.h"
#include "scanner/calibration_file.h"
#include "scanner/number_table.h"
#include "scanner/profile_reader.h"
#include "scanner/profile_workspace.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

// No profile needs more: larger files are something else.
constexpr std::size_t kMaxProfileBytes = 16ULL << 20;
constexpr std::size_t kMaxTableBytes = 1ULL << 30;
constexpr std::size_t kMaxRays = 16'000'000;
constexpr std::size_t kMaxReceivers = 16;

// Reads piece by piece: what a name leads to may have no size, or no end.
std::string readWholeFile(const std::string& path, std::size_t limit) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw IoError(path, "is a folder, expected a file");
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    throw IoError(path, "is a device or pipe, expected a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path, "cannot be opened for reading");
  std::string text;
  std::vector<char> piece(1 << 16);
  do {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > limit) throw IoError(path, "has more than the " + std::to_string(limit) + " bytes allowed");
  } while (in);
  if (in.bad()) throw IoError(path, "cannot be read");
  return text;
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
  const std::string file = scanner.fileName("file");
  const int rows = scanner.integer("rows", 2, 100000);
  const int columns = scanner.integer("columns", 2, 100000);
  checkRayCount(scanner, "columns", rows, columns);
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  const NumberTable table = parseNumberTable(attachment(source, file), file, count, 6 + 3 * kMaxReceivers);
  if (table.rows() != count)
    throw InvalidInput(file + ": has " + std::to_string(table.rows()) +
                       " rays, expected rows x columns = " + std::to_string(count));
  if (table.columns < 6 || table.columns % 3 != 0)
    throw InvalidInput(file + ": has " + std::to_string(table.columns) +
                       " numbers for every ray, expected ox,oy,oz,dx,dy,dz and three for every receiver");
  std::vector<RangingRay> rays;
  std::vector<Vec3> receivers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = table.row(i);
    auto ray = [&] { return file + ": ray " + std::to_string(i); };
    const Vec3 direction(row[3], row[4], row[5]);
    if (!(direction.norm() > 1e-9 && direction.norm() < 1e9))
      throw InvalidInput(ray() + " has a direction of length " + std::to_string(direction.norm()) +
                         ", expected a vector with a length, best 1");
    for (std::size_t k = 0; k < row.size(); ++k)
      if ((k < 3 || k > 5) && std::abs(row[k]) > kMaxCoordinate)
        throw InvalidInput(ray() + " has the coordinate " + std::to_string(row[k]) + ", expected one within 100 m");
    rays.push_back({Vec3(row[0], row[1], row[2]), direction.normalized()});
    for (std::size_t k = 6; k < row.size(); k += 3) receivers.emplace_back(row[k], row[k + 1], row[k + 2]);
  }
  return {rows, columns, std::move(rays), std::move(receivers), static_cast<int>(table.columns / 3) - 2};
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

// Whether the scanner's rays, inside its range limits, come into the viewing volume of a table at that place.
bool seesVolume(const ScannerProfile& profile, const Pose& T_table_scanner) {
  constexpr int kRays = 24;  // along rows and columns
  constexpr int kDepths = 200;
  const RayGrid& rays = *profile.rays;
  const ViewingVolume& volume = profile.viewingVolume;
  const Vec3 middleOfVolume = T_table_scanner.inverse() * Vec3(0.0, 0.0, 0.5 * volume.height);
  const double reach = volume.radius + volume.height;
  for (int k = 0; k < kRays * kRays; ++k) {
    const GridPosition at{(rays.rows() - 1.0) * (k / kRays) / (kRays - 1),
                          (rays.columns() - 1.0) * (k % kRays) / (kRays - 1)};
    const RangingRay& ray = rays.ray(rays.nearest(at));
    const double middle = (middleOfVolume - ray.origin).dot(ray.direction);
    for (int i = 0; i <= kDepths; ++i) {
      const double range = middle + reach * (2.0 * i / kDepths - 1.0);
      if (range < profile.minRange || range > profile.maxRange) continue;
      const Vec3 p = T_table_scanner * (ray.origin + range * ray.direction);
      if (p.head<2>().norm() <= volume.radius && p.z() >= 0.0 && p.z() <= volume.height) return true;
    }
  }
  return false;
}

// The table is where its calibration has it.
void calibrate(JsonObjectReader& reader, ScannerProfile& profile) {
  JsonObjectReader object = reader.object("calibration");
  const TableCalibration calibration = readCalibration(object);
  if (calibration.verdict == CalibrationVerdict::Failed)
    object.fail("verdict", "good or doubtful: one that failed cannot be used, calibrate again");
  const Pose T_table_scanner = tablePose(calibration);
  if (T_table_scanner.translation().cwiseAbs().maxCoeff() > kMaxCoordinate || !seesVolume(profile, T_table_scanner))
    object.fail("axis", "an axis whose viewing volume the scanner sees: calibrate this scanner before this table");
  for (Pose& pose : profile.workspace.poses) pose = pose * T_table_scanner;
  profile.workspace.T_table_scanner0 = T_table_scanner;
  profile.calibration = calibration;
}

}  // namespace

ProfileSource readProfileSource(const std::string& path) {
  ProfileSource source;
  source.path = path;
  source.text = readWholeFile(path, kMaxProfileBytes);
  const nlohmann::json document = parseJson(source.text, path);
  JsonObjectReader reader(document, path, "");
  for (const char* part : {"scanner", "workspace"}) {
    if (!reader.has(part)) continue;
    JsonObjectReader object = reader.object(part);
    if (!object.has("file")) continue;
    const std::string name = object.fileName("file");
    const std::filesystem::path beside = std::filesystem::path(path).parent_path() / name;
    source.attachments[name] = readWholeFile(beside.string(), kMaxTableBytes);
  }
  return source;
}

ScannerProfile parseProfile(const ProfileSource& source) {
  const nlohmann::json document = parseJson(source.text, source.path);
  JsonObjectReader reader(document, source.path, "");
  ScannerProfile profile;
  profile.name = plainText(reader.string("name"));
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
  if (reader.has("calibration")) calibrate(reader, profile);
  reader.finish();
  return profile;
}

ScannerProfile loadProfile(const std::string& path) {
  return parseProfile(readProfileSource(path));
}

}  // namespace vantage
