#include "calibration/turning_views.h"

#include <memory>
#include <utility>

#include "base/parallel.h"
#include "calibration/table_plane.h"
#include "scanner/triangulation.h"

namespace vantage {
namespace {

// A still sample turns if it is found in so many of the other scans that should see it, and in at least two.
constexpr double kFoundIn = 0.7;
constexpr int kFewest = 2;

// A view of all samples, to look points up on.
View viewOf(RangeImage image, double breakdownAngle) {
  TriangulationOptions options;
  options.breakdownAngle = breakdownAngle;
  View view;
  view.mesh = std::make_shared<const ViewMesh>(triangulate(image, options));
  view.image = std::make_shared<const RangeImage>(std::move(image));
  return view;
}

}  // namespace

TurningViews::TurningViews(std::span<const CalibrationScan> scans, std::span<const std::vector<SampleMotion>> motions,
                           const std::optional<PlaneFit>& table, double breakdownAngle, const Progress& progress)
    : breakdownAngle_(breakdownAngle) {
  for (std::size_t k = 0; k < scans.size(); ++k) {
    RangeImage image;
    image.rays = scans[k].image->rays;
    image.range = scans[k].image->range;
    for (std::size_t i = 0; table && i < image.range.size(); ++i)
      if (image.valid(i) && table->distance(image.point(i)) < tableThickness(*table)) image.range[i] = kNoSample;
    all_.push_back(image);
    for (std::size_t i = 0; i < image.range.size(); ++i)
      if (motions[k][i] != SampleMotion::Moving) image.range[i] = kNoSample;
    turning_.push_back(std::move(image));
  }
  prepare(progress);
}

void TurningViews::prepare(const Progress& progress) {
  views_.assign(turning_.size(), {});
  parallelChunks(turning_.size(), 1, progress,
                 [&](std::size_t k, std::size_t) { views_[k] = viewOf(turning_[k], breakdownAngle_); });
  prepared_ = prepareViews(views_, progress.part(1.0, 1.0));
  samples_.clear();
  for (const View& view : views_) samples_.push_back(view.mesh->sample.size());
}

Vec3 TurningViews::centre() const {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  for (const View& view : views_) {
    for (const Vec3& p : view.mesh->mesh.vertices) sum += p;
    count += static_cast<double>(view.mesh->mesh.vertices.size());
  }
  return count > 0.0 ? Vec3(sum / count) : sum;
}

TurningViews TurningViews::withRound(const ScrewMotion& motion, double gate, const Progress& progress) const {
  TurningViews result = *this;
  const std::size_t n = all_.size();
  std::vector<View> views(n);
  const Progress looking = progress.part(0.0, 0.8);
  parallelChunks(n, 1, looking, [&](std::size_t k, std::size_t) { views[k] = viewOf(all_[k], breakdownAngle_); });
  const std::vector<PreparedView> whole = prepareViews(views, looking.part(1.0, 1.0));
  const PairGates gates{gate, 4.0 * gate, radians(25.0)};
  parallelChunks(n, 1, progress.part(0.8, 0.9), [&](std::size_t k, std::size_t) {
    // Every vertex of the whole surface as a point: normals are those of the mesh.
    OrientedPoints points;
    std::vector<std::size_t> sample;
    for (std::size_t v = 0; v < views[k].mesh->sample.size(); ++v) {
      const std::size_t i = views[k].mesh->sample[v];
      if (turning_[k].valid(i)) continue;
      points.points.push_back(views[k].mesh->mesh.vertices[v]);
      points.normals.push_back(views[k].mesh->normals[v]);
      points.confidence.push_back(views[k].mesh->confidence[v]);
      sample.push_back(i);
    }
    std::vector<int> found(sample.size(), 0);
    std::vector<int> sought(sample.size(), 0);
    const auto ids = allIndices(sample.size());
    for (std::size_t other = 0; other < n; ++other) {
      if (other == k) continue;
      std::vector<std::optional<GridPosition>> positions(ids.size());
      std::vector<Pair> pairs(ids.size());
      findPairs(points, ids, motion.pose(other).inverse() * motion.pose(k), whole[other].surface, gates, positions,
                Progress(), pairs);
      for (std::size_t s = 0; s < pairs.size(); ++s) {
        if (pairs[s].state == PairState::Unseen || pairs[s].state == PairState::Border) continue;
        ++sought[s];
        found[s] += pairs[s].state == PairState::Paired ? 1 : 0;
      }
    }
    for (std::size_t s = 0; s < sample.size(); ++s)
      if (found[s] >= kFewest && found[s] >= kFoundIn * sought[s])
        result.turning_[k].range[sample[s]] = all_[k].range[sample[s]];
  });
  result.prepare(progress.part(0.9, 1.0));
  return result;
}

}  // namespace vantage
