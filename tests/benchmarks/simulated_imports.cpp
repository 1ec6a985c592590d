#include "simulated_imports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/random.h"

namespace vantage {
namespace {

constexpr int kViews = 8;
constexpr int kRows = 100;
constexpr int kColumns = 96;
// Rays span this much of the body's size.
constexpr double kField = 1.5;

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

// x to the right, y up, z to the scanner.
Pose lookFrom(double azimuth, double elevation, double height) {
  const Vec3 out(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Vec3 right(-std::sin(azimuth), std::cos(azimuth), 0.0);
  Pose pose = Pose::Identity();
  pose.linear() << right, out.cross(right), out;
  pose.translation() = Vec3(0, 0, height);
  return pose;
}

// Rays from a scanner at the given distance; a depth camera is as far away as the list says.
std::shared_ptr<const RayGrid> parallelRays(double pitch, double distance) {
  std::vector<RangingRay> rays;
  rays.reserve(static_cast<std::size_t>(kRows) * kColumns);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      rays.push_back(
          {Vec3(pitch * (column - 0.5 * (kColumns - 1)), pitch * (row - 0.5 * (kRows - 1)), distance), Vec3(0, 0, -1)});
  return std::make_shared<const RayGrid>(kRows, kColumns, std::move(rays), std::vector<Vec3>(), 0);
}

Pose turnedBy(double angle, const Vec3& shift) {
  Pose pose = Pose::Identity();
  pose.translate(shift);
  pose.rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  return pose;
}

struct TableRun {
  double step = 0.0;  // between views as the list says [rad]
  double elevation = 0.0;
  double height = 0.0;
  double distance = 0.0;  // of the scanner's frame from the axis [mm]
};

Pose listed(const TableRun& plan, double angle) {
  Pose pose = lookFrom(angle, plan.elevation, plan.height);
  pose.translation() += plan.distance * pose.linear().col(2);
  return pose;
}

double turnFactor(ImportFault fault) {
  return fault == ImportFault::HalfTurns ? 0.5 : fault == ImportFault::OtherWay ? -1.0 : 1.0;
}

Pose saidPose(ImportFault fault, const Pose& pose, double size) {
  Pose said = pose;
  if (fault == ImportFault::ListInMetres) said.translation() /= 1000.0;
  if (fault == ImportFault::NoList) said = Pose::Identity();
  if (fault == ImportFault::InverseList) said = pose.inverse();
  if (fault == ImportFault::AxisBeside) said.translation() += 0.1 * size * Vec3(0.8, 0.6, 0.0);
  return said;
}

}  // namespace

const char* name(ImportFault fault) {
  constexpr std::array<const char*, kImportFaults> kNames{
      "none",      "one elsewhere", "first elsewhere", "two elsewhere", "half turns", "other way",
      "list in m", "no list",       "inverse list",    "flipped frame", "axis beside"};
  return kNames.at(static_cast<std::size_t>(fault));
}

SimulatedImport simulatedImport(std::uint64_t seed) {
  Random random(seed);
  SimulatedImport set;
  // Every third set is right; kinds of bodies as often as people bring them.
  set.fault =
      random.uniform() < 0.35 ? ImportFault::None : static_cast<ImportFault>(1 + random.below(kImportFaults - 1));
  const double kind = random.uniform();
  set.kind = kind < 0.55   ? BodyKind::Unique
             : kind < 0.7  ? BodyKind::Symmetric
             : kind < 0.82 ? BodyKind::Plate
                           : BodyKind::PartOnTable;
  const double scale = std::exp(between(random, std::log(0.09), std::log(12.0)));
  set.size = 100.0 * scale;
  const double pitch = kField * set.size / kColumns;
  set.spacing = pitch;
  set.noise = std::exp(between(random, std::log(0.02), std::log(1.0)));
  const Body body = scaledBy(bodyOf(set.kind, random), scale);
  set.distance = body;

  TableRun plan;
  plan.step = radians(between(random, 25.0, 45.0));
  plan.elevation = set.kind == BodyKind::PartOnTable ? radians(40.0) : radians(between(random, 0.0, 25.0));
  plan.height = set.kind == BodyKind::PartOnTable ? 0.0 : 0.45 * set.size;
  plan.distance = random.uniform() < 0.5 ? 0.0 : 3.0 * set.size;
  const bool flipped = set.fault == ImportFault::FlippedFrame;
  // Rays begin two sizes before the object, wherever the frame is.
  const auto rays = parallelRays(pitch, 2.0 * set.size - plan.distance);
  const double jitterTurn = radians(between(random, 0.0, 1.2));
  const double jitterShift = between(random, 0.0, 0.007) * set.size;

  std::vector<bool> elsewhere(kViews, false);
  if (set.fault == ImportFault::FirstElsewhere) elsewhere[0] = true;
  const int others = set.fault == ImportFault::OneElsewhere ? 1 : set.fault == ImportFault::TwoElsewhere ? 2 : 0;
  for (int k = 0; k < others; ++k) elsewhere[1 + random.below(kViews - 1)] = true;
  for (int k = 0; k < kViews; ++k) {
    const Pose nominal = listed(plan, k * plan.step);
    const double angle = turnFactor(set.fault) * k * plan.step;
    const Vec3 shift(jitterShift * random.normal(), jitterShift * random.normal(), 0.3 * jitterShift * random.normal());
    const Pose moved = k == 0 ? Pose::Identity() : turnedBy(jitterTurn * random.normal(), shift);
    const Pose truth = moved * listed(plan, angle);
    Random own(seed, 100 + static_cast<std::uint64_t>(k));
    const Body other = elsewhere[static_cast<std::size_t>(k)]
                           ? scaledBy(bodyOf(static_cast<BodyKind>(own.below(2)), own), scale)
                           : body;
    RangeImage image = scanned(other, truth, rays, 6.0 * set.size, pitch, set.noise * pitch,
                               seed * 64 + static_cast<std::uint64_t>(k));
    image.T_table_scanner = saidPose(set.fault, nominal, set.size);
    if (flipped) image.T_table_scanner.linear() = image.T_table_scanner.linear() * Vec3(1, -1, -1).asDiagonal();
    image.poseKnownBy = set.fault == ImportFault::NoList ? PoseSource::Unknown : PoseSource::Reported;
    set.scans.push_back({k, std::make_shared<const RangeImage>(std::move(image))});
    set.truth.push_back(truth);
  }
  set.elsewhere = std::move(elsewhere);
  return set;
}

}  // namespace vantage
