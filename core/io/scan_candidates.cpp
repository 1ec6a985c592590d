#include "io/scan_candidates.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/errors.h"
#include "scanner/length_unit.h"

namespace vantage {
namespace {

constexpr std::size_t kMostAsked = 400;  // samples that a score is made of
constexpr double kRangeSlack = 1.02;
constexpr double kRadiusSlack = 1.25;  // what is about the viewing volume
constexpr double kHeightSlack = 0.5;

std::vector<std::pair<double, KnownBy>> unitsFor(const GridFile& file, const std::optional<double>& given) {
  if (given) return {{*given, KnownBy::Operator}};
  if (file.unit) return {{*file.unit, KnownBy::File}};
  std::vector<std::pair<double, KnownBy>> units;
  for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Inch})
    units.emplace_back(millimetresIn(unit), KnownBy::Evidence);
  return units;
}

std::vector<ScanFrame> framesFor(const GridFile& file, const std::optional<FrameChoice>& given) {
  if (!given) {
    if (file.ofCamera) return {ScanFrame::Camera};
    if (!file.T_world_scanner) return {ScanFrame::Profile, ScanFrame::Camera, ScanFrame::OpenGl, ScanFrame::Table};
    return {ScanFrame::Profile, ScanFrame::Camera, ScanFrame::OpenGl, ScanFrame::File, ScanFrame::Table};
  }
  switch (*given) {
    case FrameChoice::Profile:
      return {ScanFrame::Profile};
    case FrameChoice::LooksZUp:
      return {ScanFrame::Camera};
    case FrameChoice::LooksZDown:
      return {ScanFrame::OpenGl};
    case FrameChoice::World:
      return {ScanFrame::Table};
    default:
      throw InvalidInput("the frame of a scanner with a profile is profile, camera, gl or world: say one of them");
  }
}

Pose poseOf(ScanFrame frame, const GridFile& file, double unit, const Pose& head, const Pose& upright,
            const std::optional<Pose>& T_table_scanner) {
  switch (frame) {
    case ScanFrame::Profile:
      return upright;
    case ScanFrame::Camera:
      return head;
    case ScanFrame::OpenGl:
      return head * Pose(Eigen::AngleAxisd(kPi, Vec3::UnitX()));
    case ScanFrame::File: {
      Pose pose = *file.T_world_scanner;
      pose.translation() *= unit;
      return upright * pose;
    }
    case ScanFrame::Table:
      break;
  }
  return T_table_scanner ? T_table_scanner->inverse() * upright : upright;
}

bool isAboutVolume(const Vec3& p, const ViewingVolume& volume) {
  return p.head<2>().norm() <= kRadiusSlack * volume.radius && p.z() >= -kHeightSlack * volume.height &&
         p.z() <= (1.0 + kHeightSlack) * volume.height;
}

}  // namespace

Pose headOf(const RayGrid& rays) {
  const GridPosition middle{0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)};
  const RangingRay ray = rays.rayAt(middle);
  Vec3 right = ray.direction.cross(Vec3::UnitZ());
  if (right.norm() < 1e-6) {
    // It looks straight up or down: right is where columns lead.
    const RangingRay next = rays.rayAt({middle.row, middle.column + 1.0});
    right = (next.origin + next.direction) - (ray.origin + ray.direction);
    right -= right.dot(ray.direction) * ray.direction;
    if (right.norm() < 1e-12) right = Vec3::UnitY();
  }
  right.normalize();
  Pose pose = Pose::Identity();
  pose.linear().col(0) = right;
  pose.linear().col(1) = ray.direction.cross(right);
  pose.linear().col(2) = ray.direction;
  pose.translation() = ray.origin;
  return pose;
}

std::vector<ScanCandidate> candidatesFor(const GridFile& file, const ScannerProfile& profile,
                                         const ScanReadingOptions& options,
                                         const std::optional<Pose>& T_table_scanner) {
  const Pose head = headOf(*profile.rays);
  const Pose upright(uprightTurn(options.up.value_or(Axis::Z)));
  std::vector<ScanCandidate> candidates;
  for (const auto& [unit, knownBy] : unitsFor(file, options.unit))
    for (const ScanFrame frame : framesFor(file, options.frame))
      candidates.push_back({unit, knownBy, frame, poseOf(frame, file, unit, head, upright, T_table_scanner)});
  return candidates;
}

ScanScore scoreOf(const ScanCandidate& candidate, const std::vector<Vec3>& points, const ScannerProfile& profile,
                  const std::optional<Pose>& T_table_scanner) {
  const RayGrid& rays = *profile.rays;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kMostAsked);
  std::vector<double> aside;
  std::set<std::size_t> met;
  double asked = 0.0;
  double inVolume = 0.0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    asked += 1.0;
    const Vec3 p = candidate.T_scanner_file * (candidate.unit * points[i]);
    if (isAboutVolume(T_table_scanner ? Vec3(*T_table_scanner * p) : p, profile.viewingVolume)) inVolume += 1.0;
    const auto place = rays.locate(p);
    if (!place) continue;
    const std::size_t nearest = rays.nearest(*place);
    const RangingRay& ray = rays.ray(nearest);
    const double range = (p - ray.origin).dot(ray.direction);
    if (!(range > 0.0 && range * kRangeSlack >= profile.minRange && range <= kRangeSlack * profile.maxRange)) continue;
    met.insert(nearest);
    aside.push_back(
        std::max(std::abs(place->row - std::round(place->row)), std::abs(place->column - std::round(place->column))));
  }
  ScanScore score;
  if (asked == 0.0) return score;
  score.reached = static_cast<double>(aside.size()) / asked;
  score.inVolume = inVolume / asked;
  score.spread = static_cast<double>(met.size()) / asked;
  if (aside.empty()) return score;
  const auto middle = aside.begin() + static_cast<std::ptrdiff_t>(aside.size() / 2);
  std::nth_element(aside.begin(), middle, aside.end());
  score.aside = *middle;
  return score;
}

}  // namespace vantage
