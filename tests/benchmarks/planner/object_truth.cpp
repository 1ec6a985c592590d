#include "planner/object_truth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/ray_caster.h"
#include "scanner/sight.h"
#include "scanner/simulated_sensor.h"
#include "scanner/triangulation.h"

namespace vantage {
namespace {

constexpr double kTolerance = 0.75;                 // [mm] a point this near to a surface is covered by it
constexpr double kClearOfBreakdown = radians(2.0);  // scannable means this much inside the breakdown angle
constexpr double kNear = 1e-2;                      // [mm]
constexpr std::uint64_t kSeed = 7;

double counted(const ObjectTruth::Marks& marks) {
  return static_cast<double>(std::count(marks.begin(), marks.end(), 1));
}

}  // namespace

ObjectTruth::ObjectTruth(std::shared_ptr<const Mesh> object, std::shared_ptr<const ScannerProfile> profile, int points,
                         const Progress& progress)
    : profile_(std::move(profile)) {
  samplePoints(*object, points);
  const RayCaster caster(*object);
  const SightTest sight(*profile_, caster, {profile_->breakdownAngle - kClearOfBreakdown, kNear, kNear});
  const std::vector<Pose>& poses = profile_->workspace.poses;
  seen_.assign(poses.size(), Marks(points_.size(), 0));
  parallelChunks(poses.size(), 1, progress, [&](std::size_t begin, std::size_t /*end*/) {
    for (std::size_t k = 0; k < points_.size(); ++k)
      seen_[begin][k] =
          sight.look(poses[begin], points_[k].place, points_[k].normal).visibility == Visibility::Seen ? 1 : 0;
  });
  scannableMarks_.assign(points_.size(), 0);
  for (const Marks& seen : seen_)
    for (std::size_t k = 0; k < points_.size(); ++k) scannableMarks_[k] |= seen[k];
  scannable_ = counted(scannableMarks_);
  SimulationOptions ideal;
  ideal.ideal = true;
  const Rig rig = opened(simulatedRig(object, profile_, ideal));
  TriangulationOptions triangulation;
  triangulation.breakdownAngle = profile_->breakdownAngle;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const RangeImage scan = scanFrom(rig, static_cast<int>(i), progress);
    sampled_.push_back(covered(transformed(triangulate(scan, triangulation, progress).mesh, poses[i]), progress));
  }
}

void ObjectTruth::samplePoints(const Mesh& object, int count) {
  std::vector<double> cumulated;
  double total = 0.0;
  for (const Triangle& t : object.triangles) cumulated.push_back(total += triangleArea(object, t));
  areaPerPoint_ = total / count;
  Random random(kSeed);
  for (int i = 0; i < count; ++i) {
    const auto at = std::upper_bound(cumulated.begin(), cumulated.end() - 1, random.uniform() * total);
    const Triangle& t = object.triangles[static_cast<std::size_t>(at - cumulated.begin())];
    const double s = std::sqrt(random.uniform());
    const double u = random.uniform();
    points_.push_back(
        {(1.0 - s) * object.vertices[t[0]] + s * (1.0 - u) * object.vertices[t[1]] + s * u * object.vertices[t[2]],
         triangleNormal(object, t)});
  }
}

ObjectTruth::Marks ObjectTruth::covered(const Mesh& model, const Progress& progress) const {
  Marks marks(points_.size(), 0);
  if (model.empty()) return marks;
  const RayCaster caster(model);
  parallelChunks(marks.size(), 256, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto near = caster.closestPoint(points_[k].place, kTolerance);
      marks[k] = near && triangleNormal(model, model.triangles[near->triangle]).dot(points_[k].normal) > 0.5 ? 1 : 0;
    }
  });
  return marks;
}

double ObjectTruth::ceiling() const {
  Marks all(points_.size(), 0);
  for (const Marks& sampled : sampled_)
    for (std::size_t k = 0; k < all.size(); ++k) all[k] |= sampled[k];
  return coverage(all);
}

double ObjectTruth::coverage(const Marks& covered) const {
  double both = 0.0;
  for (std::size_t k = 0; k < covered.size(); ++k) both += covered[k] * scannableMarks_[k];
  return both / std::max(1.0, scannable_);
}

std::vector<double> ObjectTruth::gains(const Marks& covered) const {
  std::vector<double> gains;
  for (const Marks& seen : seen_) {
    double points = 0.0;
    for (std::size_t k = 0; k < covered.size(); ++k) points += seen[k] * (1 - covered[k]);
    gains.push_back(points * areaPerPoint_);
  }
  return gains;
}

int ObjectTruth::greedyViews(double coverage, int first) const {
  Marks marks = sampled_[static_cast<std::size_t>(first)];
  for (int views = 1;; ++views) {
    if (this->coverage(marks) >= coverage) return views;
    double most = 0.0;
    std::size_t best = 0;
    for (std::size_t i = 0; i < sampled_.size(); ++i) {
      double gain = 0.0;
      for (std::size_t k = 0; k < marks.size(); ++k) gain += sampled_[i][k] * (1 - marks[k]) * scannableMarks_[k];
      if (gain <= most) continue;
      most = gain;
      best = i;
    }
    if (most == 0.0) return views;
    for (std::size_t k = 0; k < marks.size(); ++k) marks[k] |= sampled_[best][k];
  }
}

}  // namespace vantage
