#include "io/scan_on_rays.h"

#include <Eigen/SVD>
#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "io/grid_images.h"
#include "io/profile_scan.h"
#include "scanner/length_unit.h"

namespace vantage {
namespace {

constexpr double kSameOrigin = 1e-6;  // [mm]
constexpr double kAsideShare = 0.01;  // of the range
constexpr double kMostSamples = 0.95;

// The units that a file may have, the likely ones first.
std::vector<std::pair<double, KnownBy>> unitsToTry(const RawScan& scan, std::optional<double> given) {
  if (given) return {{*given, KnownBy::Operator}};
  std::vector<std::pair<double, KnownBy>> units;
  if (scan.file.unit) units.emplace_back(*scan.file.unit, KnownBy::File);
  for (const LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Inch})
    units.emplace_back(millimetresIn(unit), KnownBy::Evidence);
  return units;
}

// The place of a camera at the origin of the file among rays that all begin at one point: the rotation that brings the
// directions of its samples best to those of their rays.
std::optional<Pose> cameraAmong(const SampleGrid& grid, const RayGrid& rays) {
  const Vec3 origin = rays.ray(0).origin;
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < grid.cell.size(); ++i) {
    if ((rays.ray(i).origin - origin).norm() > kSameOrigin) return std::nullopt;
    if (grid.cell[i] != kNoIndex)
      products += rays.ray(i).direction * grid.points[grid.cell[i]].normalized().transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sense = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  Pose pose = Pose::Identity();
  pose.linear() = svd.matrixU() * Vec3(1.0, 1.0, sense).asDiagonal() * svd.matrixV().transpose();
  pose.translation() = origin;
  return pose;
}

// A frame that the points may be in.
struct Frame {
  enum class Kind { Profile, Camera, Table };
  Pose T_scanner_file = Pose::Identity();  // [mm]
  Kind kind = Kind::Profile;
};

std::vector<Frame> framesToTry(const SampleGrid& grid, const RayGrid& rays, const std::optional<Pose>& T_table_scanner,
                               double poseUnit) {
  std::vector<Frame> frames{{}};
  if (const auto camera = cameraAmong(grid, rays)) frames.push_back({*camera, Frame::Kind::Camera});
  if (!T_table_scanner) return frames;
  Pose T = *T_table_scanner;
  T.translation() *= poseUnit;
  frames.push_back({T.inverse(), Frame::Kind::Table});
  return frames;
}

std::string cellText(std::size_t cell, int columns) {
  return "row " + std::to_string(cell / static_cast<std::size_t>(columns)) + ", column " +
         std::to_string(cell % static_cast<std::size_t>(columns));
}

// Whether rows and columns are those of the rays, exchanged if need be.
bool fitSize(RawScan& scan, const RayGrid& rays) {
  SampleGrid& grid = scan.file.samples;
  if (!scan.file.organised) return false;
  if (grid.rows == rays.rows() && grid.columns == rays.columns()) return true;
  if (grid.rows != rays.columns() || grid.columns != rays.rows()) return false;
  grid = transposed(grid);
  scan.reading.exchanged = true;
  return true;
}

SampleGrid moved(SampleGrid grid, double unit, const Pose& T_scanner_file) {
  for (Vec3& p : grid.points) p = T_scanner_file * (unit * p);
  return grid;
}

// Whether a point is in the viewing volume, or near it.
bool isAboutVolume(const Vec3& p, const ViewingVolume& volume) {
  return p.head<2>().norm() <= 1.25 * volume.radius && p.z() >= -0.5 * volume.height && p.z() <= 1.5 * volume.height;
}

// Whether most samples of a camera, whose directions are the same in every unit, are about the viewing volume.
bool areAboutVolume(const SampleGrid& samples, const ScannerProfile& profile, const Pose& T_table_scanner) {
  const auto inside = std::count_if(samples.points.begin(), samples.points.end(), [&](const Vec3& p) {
    return isAboutVolume(T_table_scanner * p, profile.viewingVolume);
  });
  return 2 * static_cast<std::size_t>(inside) >= samples.points.size();
}

// Whether a range image is one that the scanner could have taken: samples that are all near the beginning of the rays
// are near every ray.
bool isPlausible(const RangeImage& image, const SampleGrid& grid, const ScannerProfile& profile) {
  std::size_t near = 0;
  std::size_t reached = 0;
  for (std::size_t i = 0; i < grid.cell.size(); ++i) {
    if (!image.valid(i)) continue;
    const auto range = static_cast<double>(image.range[i]);
    const double aside = (grid.points[grid.cell[i]] - image.point(i)).norm();
    near += aside <= kAsideShare * range ? 1U : 0U;
    reached += range >= profile.minRange && range <= profile.maxRange ? 1U : 0U;
  }
  const double count = static_cast<double>(grid.points.size());
  return static_cast<double>(near) >= kMostSamples * count && static_cast<double>(reached) >= 0.5 * count;
}

Pose scaled(Pose pose, double unit) {
  pose.translation() *= unit;
  return pose;
}

// Cell by cell on the rays of the same rows and columns.
class CellByCell {
 public:
  CellByCell(const RawScan& scan, const ScannerProfile& profile, const std::optional<Pose>& T_table_scanner)
      : scan_(scan), profile_(profile), T_table_scanner_(T_table_scanner) {}

  std::optional<ReadScan> read(bool inUnits, std::optional<double> given, const Progress& progress) {
    const SampleGrid& grid = scan_.file.samples;
    for (const auto& [unit, knownBy] : unitsToTry(scan_, given))
      for (const Frame& frame : framesToTry(grid, *profile_.rays, T_table_scanner_, inUnits ? unit : 1.0)) {
        progress.checkpoint(0.0);
        OffRays off;
        const SampleGrid samples = moved(grid, unit, frame.T_scanner_file);
        ReadScan read{0, imageOnRays(samples, profile_.rays, off), scan_.reading};
        progress.checkpoint(0.5);
        if (!first_) first_ = off;
        if (!read.image.rays) continue;
        read.reading.unit = read.reading.poseUnit = unit;
        read.reading.unitKnownBy = knownBy;
        read.reading.sightKind = SightKind::Profile;
        read.reading.sightKnownBy = KnownBy::Evidence;
        read.reading.placed = frame.kind == Frame::Kind::Table;
        const Pose pose = T_table_scanner_.value_or(Pose::Identity());
        const bool camera = frame.kind == Frame::Kind::Camera;
        if (camera && !areAboutVolume(samples, profile_, scaled(pose, inUnits ? unit : 1.0))) continue;
        if (isPlausible(read.image, samples, profile_)) return read;
        if (!likely_ && frame.kind == Frame::Kind::Profile) likely_ = std::move(read);
      }
    return std::nullopt;
  }

  // On the rays, but not where the scanner measures.
  std::optional<ReadScan>& likely() { return likely_; }

  [[noreturn]] void refuse() const {
    throw InvalidInput(scan_.path + ": the sample in " + cellText(first_->cell, scan_.file.samples.columns) + " lies " +
                       std::to_string(first_->aside) +
                       " mm beside its ranging ray, at most 1 mm or 1 % of the range is allowed: this is another "
                       "scanner's file");
  }

 private:
  const RawScan& scan_;
  const ScannerProfile& profile_;
  const std::optional<Pose>& T_table_scanner_;
  std::optional<OffRays> first_;
  std::optional<ReadScan> likely_;
};

ReadScan readAnyway(RawScan scan, const ScannerProfile& profile, const std::optional<Pose>& T_table_scanner,
                    bool inUnits, const ScanReadingOptions& options, const Progress& progress) {
  const bool fits = fitSize(scan, *profile.rays);
  CellByCell direct(scan, profile, T_table_scanner);
  const bool asFound = !options.frame && options.up.value_or(Axis::Z) == Axis::Z;
  if (fits && asFound)
    if (auto read = direct.read(inUnits, options.unit, progress)) return std::move(*read);
  try {
    return placeOnRays(scan, profile, options, T_table_scanner, fits);
  } catch (const UnansweredQuestion&) {
    throw;
  } catch (const InvalidInput&) {
    if (direct.likely()) return std::move(*direct.likely());
    if (fits && asFound) direct.refuse();
    throw;
  }
}

}  // namespace

ReadScan readOnRays(RawScan scan, const ScannerProfile& profile, const std::optional<Pose>& T_table_scanner,
                    bool inUnits, const ScanReadingOptions& options, const Progress& progress) {
  ReadScan read = readAnyway(std::move(scan), profile, T_table_scanner, inUnits, options, progress);
  if (T_table_scanner) read.image.T_table_scanner = scaled(*T_table_scanner, inUnits ? read.reading.unit : 1.0);
  return read;
}

}  // namespace vantage
