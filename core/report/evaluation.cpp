#include "report/evaluation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/errors.h"
#include "base/parallel.h"
#include "base/random.h"
#include "geometry/ray_caster.h"
#include "scanner/sight.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 256;
// Distances count up to this far [mm].
constexpr double kSearchRadius = 5.0;
// The fit looks for the object this far around the model [mm], with errors beyond kFitScale losing weight.
constexpr double kFitRadius = 3.0;
constexpr double kFitScale = 0.2;
constexpr int kFitSteps = 30;
constexpr std::size_t kFitPoints = 20000;

struct SamplePoint {
  Vec3 point;
  Vec3 normal;
};

// Points spread over a mesh in proportion to area.
std::vector<SamplePoint> sampleSurface(const Mesh& mesh, int count, std::uint64_t seed) {
  std::vector<double> cumulated;
  cumulated.reserve(mesh.triangles.size());
  double total = 0.0;
  for (const Triangle& t : mesh.triangles) cumulated.push_back(total += triangleArea(mesh, t));
  Random random(seed);
  std::vector<SamplePoint> samples;
  if (!(total > 0.0)) return samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const auto at = std::upper_bound(cumulated.begin(), cumulated.end(), random.uniform() * total);
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(std::min(at, cumulated.end() - 1) - cumulated.begin())];
    const double s = std::sqrt(random.uniform());
    const double u = random.uniform();
    samples.push_back(
        {(1.0 - s) * mesh.vertices[t[0]] + s * (1.0 - u) * mesh.vertices[t[1]] + s * u * mesh.vertices[t[2]],
         triangleNormal(mesh, t)});
  }
  return samples;
}

// The model moved onto the object.
Mesh fitted(Mesh model, const Mesh& object, const RayCaster& caster, const Progress& progress) {
  const std::size_t stride = std::max<std::size_t>(1, model.vertices.size() / kFitPoints);
  for (int step = 0; step < kFitSteps; ++step) {
    progress.checkpoint(static_cast<double>(step) / kFitSteps);
    Mat6 a = 1e-9 * Mat6::Identity();
    Vec6 b = Vec6::Zero();
    for (std::size_t i = 0; i < model.vertices.size(); i += stride) {
      const auto near = caster.closestPoint(model.vertices[i], kFitRadius);
      if (!near) continue;
      const Vec3 n = triangleNormal(object, object.triangles[near->triangle]);
      Vec6 j;
      j << model.vertices[i].cross(n), n;
      const double r = (model.vertices[i] - near->point).dot(n);
      const double w = 1.0 / (1.0 + r * r / (kFitScale * kFitScale));
      a += w * j * j.transpose();
      b -= w * r * j;
    }
    const Vec6 x = a.ldlt().solve(b);
    model = transformed(model, smallMotion(x));
    if (x.norm() < 1e-7) break;
  }
  return model;
}

// 1 per sample that some position of the workspace can scan.
std::vector<std::uint8_t> findScannable(const std::vector<SamplePoint>& samples, const RayCaster& caster,
                                        const ScannerProfile& profile, const EvaluationOptions& options,
                                        const Progress& progress) {
  SightOptions sightOptions;
  sightOptions.breakdownAngle = std::max(0.0, profile.breakdownAngle - options.clearOfBreakdown);
  sightOptions.offset = 1e-2;
  sightOptions.margin = 1e-2;
  const SightTest sight(profile, caster, sightOptions);
  std::vector<std::uint8_t> scannable(samples.size(), 0);
  parallelChunks(samples.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      scannable[i] = std::any_of(profile.workspace.poses.begin(), profile.workspace.poses.end(), [&](const Pose& pose) {
        return sight.look(pose, samples[i].point, samples[i].normal).visibility == Visibility::Seen;
      });
  });
  return scannable;
}

void measureCoverage(const std::vector<SamplePoint>& samples, const std::vector<std::uint8_t>& scannable,
                     const Mesh& model, const EvaluationOptions& options, const Progress& progress,
                     Evaluation& result) {
  const RayCaster caster(model);
  std::vector<std::uint8_t> covered(samples.size(), 0);
  parallelChunks(samples.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto near = caster.closestPoint(samples[i].point, options.tolerance);
      covered[i] = near && triangleNormal(model, model.triangles[near->triangle]).dot(samples[i].normal) > 0.5;
    }
  });
  const auto scannableCount = static_cast<double>(std::count(scannable.begin(), scannable.end(), 1));
  result.scannableShare = scannableCount / static_cast<double>(std::max<std::size_t>(1, samples.size()));
  double both = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) both += scannable[i] != 0 && covered[i] != 0 ? 1.0 : 0.0;
  result.coverage = scannableCount > 0.0 ? both / scannableCount : 0.0;
  result.wholeCoverage = static_cast<double>(std::count(covered.begin(), covered.end(), 1)) /
                         static_cast<double>(std::max<std::size_t>(1, samples.size()));
}

void measureAccuracy(const Mesh& model, const RayCaster& object, const EvaluationOptions& options,
                     const Progress& progress, Evaluation& result) {
  const auto samples = sampleSurface(model, options.samples, options.seed + 1);
  if (samples.empty()) return;
  std::vector<double> distances(samples.size(), kSearchRadius);
  parallelChunks(samples.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (const auto near = object.closestPoint(samples[i].point, kSearchRadius)) distances[i] = near->distance;
  });
  std::sort(distances.begin(), distances.end());
  double squares = 0.0;
  for (const double d : distances) squares += d * d;
  const auto count = static_cast<double>(distances.size());
  result.rms = std::sqrt(squares / count);
  result.percentile99 = distances[distances.size() * 99 / 100];
  const auto beyond = distances.end() - std::upper_bound(distances.begin(), distances.end(), options.tolerance);
  result.falseSurface = static_cast<double>(beyond) / count;
}

}  // namespace

Evaluation evaluate(const Mesh& model, const Mesh& object, const ScannerProfile& profile,
                    const EvaluationOptions& options, const Progress& progress) {
  if (model.empty() || object.empty()) throw InvalidInput("evaluation needs a model and an object with triangles");
  const RayCaster caster(object, RayCaster::Precision::Robust);
  const Mesh placed = fitted(model, object, caster, progress.part(0.0, 0.2, "fit"));
  const auto samples = sampleSurface(object, options.samples, options.seed);
  const auto scannable = findScannable(samples, caster, profile, options, progress.part(0.2, 0.8, "scannable_surface"));
  Evaluation result;
  measureCoverage(samples, scannable, placed, options, progress.part(0.8, 0.9, "coverage"), result);
  measureAccuracy(placed, caster, options, progress.part(0.9, 1.0, "accuracy"), result);
  return result;
}

}  // namespace vantage
