#include "simulated_imports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/random.h"

namespace vantage {
namespace {

using Body = std::function<double(const Vec3& point)>;

constexpr int kViews = 8;
constexpr int kRows = 100;
constexpr int kColumns = 96;
// Rays span this much of the body's size.
constexpr double kField = 1.5;

double boxDistance(const Vec3& p, const Vec3& half) {
  const Vec3 q = p.cwiseAbs() - half;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

Body box(const Vec3& centre, const Vec3& half) {
  return [=](const Vec3& p) { return boxDistance(p - centre, half); };
}

Body capsule(const Vec3& a, const Vec3& b, double radius) {
  return [=](const Vec3& p) {
    const Vec3 u = b - a;
    const double t = std::clamp((p - a).dot(u) / std::max(u.squaredNorm(), 1e-12), 0.0, 1.0);
    return (p - a - t * u).norm() - radius;
  };
}

Body cylinder(double radius, double low, double high) {
  return [=](const Vec3& p) {
    const double r = p.head<2>().norm() - radius;
    const double h = std::abs(p.z() - 0.5 * (low + high)) - 0.5 * (high - low);
    return std::hypot(std::max(r, 0.0), std::max(h, 0.0)) + std::min(std::max(r, h), 0.0);
  };
}

Body together(std::vector<Body> parts) {
  return [parts = std::move(parts)](const Vec3& p) {
    double least = 1e30;
    for (const Body& part : parts) least = std::min(least, part(p));
    return least;
  };
}

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

Vec3 somewhere(Random& random, double radius, double low, double high) {
  const double angle = 2.0 * kPi * random.uniform();
  const double r = radius * std::sqrt(random.uniform());
  return {r * std::cos(angle), r * std::sin(angle), between(random, low, high)};
}

// Bodies of about 100 mm, standing on z = 0 about the axis.
Body uniqueBody(Random& random) {
  std::vector<Body> parts{
      capsule(Vec3(0, 0, 12), Vec3(between(random, -6, 6), between(random, -6, 6), 75), between(random, 12, 20))};
  const auto limbs = 3 + random.below(4);
  for (std::uint64_t i = 0; i < limbs; ++i) {
    const Vec3 from = somewhere(random, 10, 15, 80);
    const Vec3 to = somewhere(random, 42, 10, 95);
    if (random.uniform() < 0.3)
      parts.push_back(
          box(0.5 * (from + to), Vec3(between(random, 5, 14), between(random, 5, 14), between(random, 5, 14))));
    else
      parts.push_back(capsule(from, to, between(random, 5, 11)));
  }
  return together(std::move(parts));
}

Body symmetricBody(Random& random) {
  if (random.uniform() < 0.5)
    return together(
        {cylinder(between(random, 22, 35), 0, 60), cylinder(between(random, 10, 18), 60, between(random, 80, 105))});
  return together({box(Vec3(0, 0, 40), Vec3(between(random, 15, 30), between(random, 15, 30), 40)),
                   cylinder(between(random, 8, 14), 80, 98)});
}

Body plate(Random& random) {
  return box(Vec3(0, 0, 45), Vec3(between(random, 2, 6), between(random, 35, 50), 45));
}

Body partOnTable(Random& random) {
  const double h = between(random, 10, 22);
  return together({box(Vec3(0, 0, -3), Vec3(50, 50, 3)), capsule(Vec3(0, 0, 0), Vec3(3, 2, h), between(random, 5, 8)),
                   box(Vec3(between(random, 6, 10), 0, 4), Vec3(between(random, 5, 8), between(random, 3, 5), 4))});
}

Body bodyOf(BodyKind kind, Random& random) {
  switch (kind) {
    case BodyKind::Symmetric:
      return symmetricBody(random);
    case BodyKind::Plate:
      return plate(random);
    case BodyKind::PartOnTable:
      return partOnTable(random);
    case BodyKind::Unique:
      break;
  }
  return uniqueBody(random);
}

Body scaledBy(const Body& body, double factor) {
  return [body, factor](const Vec3& p) { return factor * body(p / factor); };
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

// Along a ray in object coordinates; nothing beyond `most` or where the surface is steeper than 72 degrees.
std::optional<double> traced(const Body& body, const Vec3& origin, const Vec3& direction, double most, double step) {
  double along = 0.0;
  for (int i = 0; i < 200 && along < most; ++i) {
    const Vec3 p = origin + along * direction;
    const double distance = body(p);
    if (distance < 1e-3 * step) {
      const double h = 1e-2 * step;
      const Vec3 gradient(body(p + Vec3(h, 0, 0)) - body(p - Vec3(h, 0, 0)),
                          body(p + Vec3(0, h, 0)) - body(p - Vec3(0, h, 0)),
                          body(p + Vec3(0, 0, h)) - body(p - Vec3(0, 0, h)));
      if (-gradient.normalized().dot(direction) < std::cos(radians(72.0))) return std::nullopt;
      return along;
    }
    along += distance;
  }
  return std::nullopt;
}

RangeImage scanned(const Body& body, const Pose& T_object_scanner, const std::shared_ptr<const RayGrid>& rays,
                   double reach, double pitch, double noise, std::uint64_t seed) {
  RangeImage image;
  image.rays = rays;
  image.range.assign(rays->size(), kNoSample);
  for (std::size_t i = 0; i < rays->size(); ++i) {
    const RangingRay& ray = rays->ray(i);
    const auto along =
        traced(body, T_object_scanner * ray.origin, T_object_scanner.linear() * ray.direction, reach, pitch);
    if (along) image.range[i] = static_cast<float>(*along + noise * Random(seed, i).normal());
  }
  return image;
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

const char* name(BodyKind kind) {
  constexpr std::array<const char*, kBodyKinds> kNames{"unique", "symmetric", "plate", "part on table"};
  return kNames.at(static_cast<std::size_t>(kind));
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
