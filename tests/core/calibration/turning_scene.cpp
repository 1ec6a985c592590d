#include "turning_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/random.h"
#include "scanner/ray_patterns.h"
#include "support/meshes.h"
#include "support/simulation.h"

namespace vantage::testing {
namespace {

Mesh makeDisc(double radius) {
  constexpr int kSides = 72;
  Mesh mesh;
  mesh.vertices.emplace_back(Vec3::Zero());
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * kPi * k / kSides;
    mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    mesh.triangles.push_back({0, static_cast<std::uint32_t>(k + 1), static_cast<std::uint32_t>((k + 1) % kSides + 1)});
  }
  return mesh;
}

Pose turned(double angle) {
  return Pose(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

}  // namespace

std::shared_ptr<const ScannerProfile> cameraOverTable(double rangeSigma) {
  auto profile = std::make_shared<ScannerProfile>();
  profile->rays = std::make_shared<RayGrid>(
      makeRays(Pinhole{Vec3(450, 0, 250), Vec3(0, 0, 60), 240, 320, radians(40.0), radians(30.0)}, ReceiverOffsets{}));
  profile->noise.rangeSigma = rangeSigma;
  profile->breakdownAngle = radians(75.0);
  profile->minRange = 100.0;
  profile->maxRange = 2000.0;
  profile->workspace = turntable(90);
  return profile;
}

std::shared_ptr<const ScannerProfile> stripeScanner() {
  auto profile = std::make_shared<ScannerProfile>();
  profile->rays = std::make_shared<RayGrid>(
      makeRays(RotatingStripe{Vec3(300, 0, 75), 150.0, 125, 120, radians(60.0)}, ReceiverOffsets{}));
  profile->noise.rangeSigma = 0.1;
  profile->minRange = 100.0;
  profile->maxRange = 500.0;
  profile->workspace = turntable(90);
  return profile;
}

std::vector<CalibrationScan> TurningScene::scans(std::span<const double> tableAngles) const {
  // Every scan has a profile of its own: one position, where the scanner really is.
  auto where = std::make_shared<ScannerProfile>(*profile);
  where->workspace = Workspace{{T_table_scanner}, 0, Pose::Identity()};
  where->mechanics = {};
  std::vector<CalibrationScan> result;
  for (std::size_t k = 0; k < tableAngles.size(); ++k) {
    double angle = turnsPerCount * radians(tableAngles[k]);
    if (angleSigma > 0.0) angle += angleSigma * Random(seed, 1000 + k).normal();
    if (slipsBefore && k >= *slipsBefore) angle += slip;
    Mesh world = transformed(object, turned(angle));
    if (tableRadius > 0.0) world = joined(world, makeDisc(tableRadius));
    if (wall) {
      world = joined(world, makeBox(Vec3(-420, -500, -50), Vec3(-400, 500, 600)));
      world = joined(world, makeBox(Vec3(-20, -140, 0), Vec3(0, -120, 200)));
    }
    SimulationOptions options;
    options.seed = seed * 100 + k;
    const Rig rig = simulation(std::move(world), where, options);
    RangeImage image = scanFrom(rig, 0, Progress());
    image.T_table_scanner = Pose::Identity();
    result.push_back({std::make_shared<const RangeImage>(std::move(image)), tableAngles[k]});
  }
  return result;
}

AxisError errorOf(const TableCalibration& calibration, const Pose& T_table_scanner, double height) {
  const Vec3 direction = T_table_scanner.linear() * calibration.axisDirection;
  const Vec3 point = T_table_scanner * calibration.axisPoint;
  const Vec3 there = point + (height - point.z()) / direction.z() * direction;
  const Vec3 centre = T_table_scanner * tableCentre(calibration);
  return {degrees(std::acos(std::clamp(direction.z(), -1.0, 1.0))), there.head<2>().norm(), std::abs(centre.z())};
}

Pose offBy(const Vec3& shift, const Vec3& turnDegrees, const Vec3& about) {
  Pose pose = Pose::Identity();
  pose.translate(about + shift);
  pose.rotate(Eigen::AngleAxisd(radians(turnDegrees.z()), Vec3::UnitZ()) *
              Eigen::AngleAxisd(radians(turnDegrees.y()), Vec3::UnitY()) *
              Eigen::AngleAxisd(radians(turnDegrees.x()), Vec3::UnitX()));
  pose.translate(-about);
  return pose;
}

Mesh makeLump() {
  Mesh mesh = makeSphere(1.0, 60);
  for (Vec3& v : mesh.vertices) {
    const Vec3 d = v;
    const double radius = 40.0 + 5.0 * std::sin(3.0 * d.x() + 1.0) + 4.0 * std::sin(4.0 * d.y() + 3.0 * d.z()) +
                          3.0 * std::sin(5.0 * d.z() + 5.0 * d.x() * d.y());
    v = radius * d + Vec3(15, -10, 42);
  }
  return mesh;
}

Mesh makeCylinder(double radius, double height, double x) {
  Mesh mesh = makeSphere(1.0, 40);
  for (Vec3& v : mesh.vertices) {
    // Rings of latitude become rings of height; those next to the poles the rims of the ends.
    const double level = std::acos(std::clamp(v.z(), -1.0, 1.0)) / kPi;
    const double across = v.head<2>().norm();
    const Vec2 outward = across > 1e-9 ? Vec2(v.head<2>() / across) : Vec2::Zero();
    v << radius * outward + Vec2(x, 0.0), height * (1.0 - level);
  }
  return mesh;
}

Mesh makeCup() {
  Mesh cup = makeSphere(1.0, 60);
  for (Vec3& v : cup.vertices) v = Vec3(38.0 * v.x(), 38.0 * v.y(), 45.0 + 45.0 * v.z());
  cup = joined(cup, makeBox(Vec3(30, -6, 25), Vec3(62, 6, 37)));
  cup = joined(cup, makeBox(Vec3(50, -6, 30), Vec3(62, 6, 75)));
  return joined(cup, makeBox(Vec3(20, -6, 63), Vec3(62, 6, 75)));
}

}  // namespace vantage::testing
