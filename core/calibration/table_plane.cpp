#include "calibration/table_plane.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr std::size_t kFewest = 200;
constexpr double kLeastExtent = 4.0;  // [mm]
// Of what moves so much may lie below the table: noise, and what hangs over its edge.
constexpr double kMostBelow = 0.1;
constexpr double kSigmas = 4.0;
constexpr double kLeastTolerance = 0.2;  // [mm]

bool isNear(const Vec3& p, const TablePlaneSearch& search) {
  if (!search.axisPoint) return true;
  const Vec3 off = p - *search.axisPoint;
  return (off - off.dot(search.normal) * search.normal).norm() <= search.radius;
}

struct Samples {
  std::vector<Vec3> still;  // one for every ray: the mean of what scans have of it
  std::vector<Vec3> moving;
  double noise = 0.0;
};

Samples gathered(std::span<const CalibrationScan> scans, std::span<const std::vector<SampleMotion>> motions,
                 const TablePlaneSearch& search) {
  Samples samples;
  const RangeImage& first = *scans.front().image;
  for (std::size_t i = 0; i < first.range.size(); ++i) {
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      if (motions[k][i] == SampleMotion::None) continue;
      const Vec3 p = scans[k].image->point(i);
      if (motions[k][i] == SampleMotion::Still) {
        sum += p;
        ++count;
      } else if (isNear(p, search)) {
        samples.moving.push_back(p);
      }
    }
    if (count > 0.0 && isNear(sum / count, search)) samples.still.emplace_back(sum / count);
  }
  for (const CalibrationScan& scan : scans)
    samples.noise = std::max(samples.noise, RangeNoiseCurve(*scan.image).median());
  return samples;
}

}  // namespace

double tableThickness(const PlaneFit& plane) {
  return 1.0 + 4.0 * plane.rms;
}

std::optional<PlaneFit> findTablePlane(std::span<const CalibrationScan> scans,
                                       std::span<const std::vector<SampleMotion>> motions,
                                       const TablePlaneSearch& search) {
  const Samples samples = gathered(scans, motions, search);
  const double tolerance = kLeastTolerance + kSigmas * samples.noise;
  std::vector<Vec3> still = samples.still;
  // A plane through the middle of what moves is not below it: what stands on the table may have flat sides that turn
  // up, a shelf behind may be larger than the table.
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto plane = fitPlane(still, search.normal, search.mostLean, tolerance);
    if (!plane || plane->count < kFewest || plane->extent < kLeastExtent) return {};
    const auto below =
        static_cast<double>(std::count_if(samples.moving.begin(), samples.moving.end(),
                                          [&](const Vec3& p) { return plane->distance(p) < -tableThickness(*plane); }));
    if (below <= kMostBelow * static_cast<double>(samples.moving.size())) return plane;
    std::erase_if(still, [&](const Vec3& p) { return std::abs(plane->distance(p)) <= 2.0 * tolerance; });
  }
  return {};
}

}  // namespace vantage
