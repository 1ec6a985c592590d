#include "io/scan_evidence.h"

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"

namespace vantage {
namespace {

constexpr double kFarPitches = 1e5;
// [cosine] Lines of sight that agree with a list, and that cannot be those of the file's own axes.
constexpr double kAgrees = 0.98;
constexpr double kDiffers = 0.9;
// Surface lies so far from the middle, of its size, and so many scans agree.
constexpr double kClearSide = 0.04;
constexpr double kMostAgree = 0.8;
constexpr double kAllAround = 0.7;
constexpr double kAxisCosine = 0.985;
constexpr double kLeastTurn = 0.02;  // [rad]

Vec3 middleInObject(const RawScan& scan) {
  return *scan.T_object_scanner * middleOf(scan.file.samples);
}

Vec3 centreOf(const std::vector<RawScan>& scans) {
  Vec3 sum = Vec3::Zero();
  for (const RawScan& scan : scans) sum += middleInObject(scan) - middleInObject(scans.front());
  return middleInObject(scans.front()) + sum / static_cast<double>(scans.size());
}

// How far the surface of a scan lies behind the middle of all along its line of sight, of its size.
double sideAbout(const RawScan& scan, const Vec3& centre) {
  const Vec3 sight = scan.T_object_scanner->linear() * scan.sight.direction;
  return sight.dot(middleInObject(scan) - centre) / sizeOf(scan.file.samples);
}

}  // namespace

bool isFar(const Vec3& place, double pitch) {
  return pitch > 0.0 && place.cwiseAbs().maxCoeff() > kFarPitches * pitch;
}

double sizeOf(const SampleGrid& grid) {
  BoundingBox box{grid.points.front(), grid.points.front()};
  for (const Vec3& p : grid.points) box.extend(p);
  return box.size().maxCoeff();
}

bool areAlreadyPlaced(const std::vector<RawScan>& scans) {
  bool moved = false;
  for (const RawScan& scan : scans) {
    if (!scan.T_object_scanner || !scan.sight.fits) return false;
    const Vec3 expected = scan.T_object_scanner->linear().col(2);
    if (std::abs(scan.sight.direction.dot(expected)) < kAgrees) return false;
    moved |= std::abs(scan.sight.direction.z()) < kDiffers;
  }
  return moved;
}

bool lookDifferentWays(const std::vector<RawScan>& scans) {
  const auto fits = [](const RawScan& scan) {
    return !scan.poseOfList && !scan.file.T_world_scanner && scan.sight.fits;
  };
  if (scans.size() < 2 || !std::all_of(scans.begin(), scans.end(), fits)) return false;
  return std::any_of(scans.begin(), scans.end(), [&](const RawScan& scan) {
    return std::abs(scan.sight.direction.dot(scans.front().sight.direction)) < kDiffers;
  });
}

std::optional<int> commonSide(const std::vector<RawScan>& scans) {
  if (scans.size() < 2) return std::nullopt;
  const Vec3 centre = centreOf(scans);
  const auto count = static_cast<double>(scans.size());
  Vec3 meanSight = Vec3::Zero();
  double mean = 0.0;
  double along = 0.0;
  for (const RawScan& scan : scans) {
    const double side = sideAbout(scan, centre);
    meanSight += scan.T_object_scanner->linear() * scan.sight.direction / count;
    mean += side / count;
    along += side < 0.0 ? 1.0 / count : 0.0;
  }
  if (meanSight.norm() > kAllAround || std::abs(mean) < kClearSide) return std::nullopt;
  if ((mean < 0.0 ? along : 1.0 - along) < kMostAgree) return std::nullopt;
  return mean < 0.0 ? 1 : -1;
}

std::optional<int> sideOf(const RawScan& scan, const std::vector<RawScan>& scans) {
  if (scans.size() < 2) return std::nullopt;
  const double side = sideAbout(scan, centreOf(scans));
  if (std::abs(side) < kClearSide) return std::nullopt;
  return side < 0.0 ? 1 : -1;
}

std::optional<Axis> axisOfTurns(const std::vector<RawScan>& scans) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t turns = 0;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (!scans[i].T_object_scanner || !scans[0].T_object_scanner) return std::nullopt;
    const Eigen::AngleAxisd turn(scans[i].T_object_scanner->linear() * scans[0].T_object_scanner->linear().transpose());
    if (std::abs(turn.angle()) < kLeastTurn) continue;
    sum += turn.axis().cwiseAbs();
    ++turns;
  }
  if (turns == 0) return std::nullopt;
  sum /= static_cast<double>(turns);
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
    if (sum[static_cast<int>(axis)] > kAxisCosine) return axis;
  return std::nullopt;
}

}  // namespace vantage
