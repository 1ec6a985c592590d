#include "io/scan_sights.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kAboutAxis = 0.85;  // [cosine] nearer to an axis it is that axis
constexpr double kSameSight = 0.7;   // [cosine]
constexpr double kMostOfScans = 0.8;

bool isAxis(FrameChoice frame) {
  return frame <= FrameChoice::LooksZDown;
}

Vec3 axisOf(FrameChoice frame) {
  Vec3 axis = Vec3::Zero();
  const int k = static_cast<int>(frame);
  axis[k / 2] = k % 2 == 0 ? 1.0 : -1.0;
  return axis;
}

// The axis of coordinates that a direction is about along, else the direction.
Vec3 snapped(const Vec3& direction) {
  Eigen::Index k = 0;
  if (direction.cwiseAbs().maxCoeff(&k) < kAboutAxis) return direction;
  Vec3 axis = Vec3::Zero();
  axis[k] = std::copysign(1.0, direction[k]);
  return axis;
}

void setSight(RawScan& scan, const Vec3& sight, KnownBy knownBy) {
  scan.reading.sightKind = SightKind::Grid;
  scan.reading.sight = sight;
  scan.reading.sightKnownBy = knownBy;
}

void setKind(RawScan& scan, SightKind kind, KnownBy knownBy) {
  scan.reading.sightKind = kind;
  scan.reading.sightKnownBy = knownBy;
}

// The operator named an axis: the line of sight that the grid has, on that side.
void setGiven(RawScan& scan, const Vec3& axis) {
  const double cosine = scan.sight.fits ? scan.sight.direction.dot(axis) : 0.0;
  const bool oblique = scan.sight.fits && std::abs(cosine) < kAboutAxis && std::abs(cosine) > 0.1;
  setSight(scan, oblique ? Vec3(std::copysign(1.0, cosine) * scan.sight.direction) : axis, KnownBy::Operator);
}

class SightDecision {
 public:
  SightDecision(std::vector<RawScan>& scans, const ScanReadingOptions& options) : scans_(scans), options_(options) {}

  void decide() {
    if (options_.frame == FrameChoice::World) place();
    if (!options_.frame && (areAlreadyPlaced(scans_) || lookDifferentWays(scans_))) place();
    if (!placed_) alignSigns();
    for (RawScan& scan : scans_) decide(scan);
  }

 private:
  void place() {
    placed_ = true;
    for (RawScan& scan : scans_) {
      scan.T_object_scanner = Pose(Eigen::Translation3d(scan.shift));
      scan.reading.placed = true;
    }
  }

  // One scanner took all scans: lines of sight that tell no side point to the same one.
  void alignSigns() {
    const Vec3 first = scans_.front().sight.direction;
    for (RawScan& scan : scans_)
      if (!scan.sight.spreads && scan.sight.direction.dot(first) < 0.0) scan.sight.direction *= -1.0;
  }

  void decide(RawScan& scan) {
    if (options_.frame && isAxis(*options_.frame)) return setGiven(scan, axisOf(*options_.frame));
    if (options_.frame == FrameChoice::Turn) return setTurn(scan);
    if (scan.file.alongZ) return setSight(scan, -Vec3::UnitZ(), KnownBy::File);
    if (scan.turn) return setKind(scan, SightKind::Turntable, KnownBy::Evidence);
    if (scan.file.fromOrigin && fitTurn(scan.file.samples, Axis::Z))
      return setKind(scan, SightKind::Point, KnownBy::File);
    if (const auto found = foundSight(scan)) return setSight(scan, snapped(*found), KnownBy::Evidence);
    if (scan.sight.fits && std::abs(scan.sight.direction.z()) < kAboutAxis) refuse(scan);
    setSight(scan, -Vec3::UnitZ(), KnownBy::Default);
  }

  static void setTurn(RawScan& scan) {
    if (!scan.turn)
      throw InvalidInput(scan.path +
                         ": its columns do not go around an axis of coordinates, so --frame cylinder does "
                         "not describe it");
    setKind(scan, SightKind::Turntable, KnownBy::Operator);
  }

  [[nodiscard]] std::optional<Vec3> foundSight(const RawScan& scan) const {
    if (!placed_)
      if (auto common = commonSpread()) return common;
    if (!scan.sight.fits) return std::nullopt;
    if (scan.sight.spreads) return scan.sight.direction;
    const auto side = sideOfOne(scan);
    if (!side) return std::nullopt;
    return Vec3(*side * scan.sight.direction);
  }

  [[nodiscard]] std::optional<int> sideOfOne(const RawScan& scan) const {
    const bool all =
        std::all_of(scans_.begin(), scans_.end(), [](const RawScan& s) { return s.T_object_scanner && s.sight.fits; });
    if (!all) return std::nullopt;
    return placed_ ? sideOf(scan, scans_) : commonSide(scans_);
  }

  // Where the lines of sight of most scans spread one way, all scans look that way.
  [[nodiscard]] std::optional<Vec3> commonSpread() const {
    Vec3 sum = Vec3::Zero();
    double spreading = 0.0;
    for (const RawScan& scan : scans_) {
      if (!scan.sight.spreads) continue;
      sum += scan.sight.direction;
      spreading += 1.0;
    }
    if (!(sum.norm() > 0.0)) return std::nullopt;
    const Vec3 mean = sum.normalized();
    double agreeing = 0.0;
    for (const RawScan& scan : scans_)
      agreeing += scan.sight.spreads && scan.sight.direction.dot(mean) > kSameSight ? 1.0 : 0.0;
    if (agreeing < kMostOfScans * spreading) return std::nullopt;
    return mean;
  }

  [[noreturn]] static void refuse(const RawScan& scan) {
    const Vec3& d = scan.sight.direction;
    Eigen::Index k = 0;
    d.cwiseAbs().maxCoeff(&k);
    const std::string axis(name(static_cast<Axis>(k)));
    throw InvalidInput(scan.path + ": its lines of sight lie about along " + axis +
                       ", but it cannot be told from which side the scanner looks: say --frame " + axis +
                       "+ if it looks along " + axis + ", --frame " + axis + "- if it looks the other way");
  }

  std::vector<RawScan>& scans_;
  const ScanReadingOptions& options_;
  bool placed_ = false;
};

}  // namespace

void decideSights(std::vector<RawScan>& scans, const ScanReadingOptions& options) {
  SightDecision(scans, options).decide();
}

}  // namespace vantage
