#include "planning/objective.h"

#include <algorithm>
#include <cmath>

#include "planning/patch_promise.h"
#include "positional_space/objective_sums.h"
#include "positional_space/positional_image.h"

namespace vantage {
namespace {

AccumulationOptions accumulation(const ObjectiveOptions& options, bool keepSightings) {
  AccumulationOptions result;
  result.keepSightings = keepSightings;
  result.surfaceOffset = options.surfaceOffset;
  return result;
}

// Tells `add` what the patches that attract views give to every cell they are seen through [mm^2], direction by
// direction.
template <typename Add>
void forEachContribution(std::span<const VoidPatch> patches, const PatchHistory& history, const PositionalImage& image,
                         const ScannerImages& images, const ObjectiveOptions& options, const Add& add) {
  for (std::size_t p = 0; p < patches.size(); ++p) {
    for (const auto& sighting : image.sightingsOf(p)) {
      const OutwardRay cellRay = images.ray(sighting.cell);
      const Vec3 direction = (cellRay.point - patches[p].centre).normalized();
      if (!history.attracts(p, static_cast<double>(sighting.confidence))) continue;
      double area = patches[p].weight * static_cast<double>(sighting.confidence);
      if (options.lookAhead) area *= lookAhead(patches[p], direction, options.breakdownAngle);
      add(sighting.cell, area);
    }
  }
}

// Forgets the sightings of each patch beyond its own widest look.
void narrow(PositionalImage& image, std::span<const VoidPatch> patches, double breakdownAngle) {
  std::size_t kept = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto sightings = image.sightingsOf(p);
    const double minCosine = std::cos(widestLook(patches[p], breakdownAngle));
    image.sightingStart[p] = kept;
    for (const Sighting& sighting : sightings)
      if (static_cast<double>(sighting.confidence) >= minCosine) image.sightings[kept++] = sighting;
  }
  image.sightingStart[patches.size()] = kept;
  image.sightings.resize(kept);
}

PositionalImage sightingsOf(std::span<const VoidPatch> patches, const PatchHistory& history, const RayCaster& obstacles,
                            const ScannerImages& images, const ObjectiveOptions& options, const Progress& progress) {
  std::vector<ObservationSource> sources;
  sources.reserve(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    sources.push_back({patches[p].centre, patches[p].normal, history.answered(p) ? 0.0 : patches[p].weight});
  if (!options.lookAhead)
    return accumulate(sources, obstacles, images, options.breakdownAngle, accumulation(options, true), progress);
  double widest = options.breakdownAngle;
  for (const VoidPatch& patch : patches) widest = std::max(widest, widestLook(patch, options.breakdownAngle));
  PositionalImage image = accumulate(sources, obstacles, images, widest, accumulation(options, true), progress);
  narrow(image, patches, options.breakdownAngle);
  return image;
}

// Triangles sampled with less confidence than u: c(T) is the least of their vertices.
std::vector<ObservationSource> poorTriangles(const Model& model, double tolerance) {
  std::vector<ObservationSource> sources;
  for (const Triangle& t : model.mesh.triangles) {
    const float confidence = std::min({model.confidence[t[0]], model.confidence[t[1]], model.confidence[t[2]]});
    const Vec3 normal = triangleNormal(model.mesh, t);
    if (static_cast<double>(confidence) >= tolerance || normal.isZero()) continue;
    sources.push_back({triangleCentre(model.mesh, t), normal, triangleArea(model.mesh, t)});
  }
  return sources;
}

PositionalImage poorTrianglesImage(const Model& model, const RayCaster& obstacles, const ScannerImages& images,
                                   const ObjectiveOptions& options, const Progress& progress) {
  const auto sources = poorTriangles(model, options.tolerance);
  // Rays that would not reach the tolerance are not worth tracing: a narrower breakdown angle leaves them out.
  const double angle = std::min(options.breakdownAngle, std::acos(std::clamp(options.tolerance, 0.0, 1.0)));
  return accumulate(sources, obstacles, images, angle, accumulation(options, false), progress);
}

}  // namespace

std::vector<double> voidObjective(std::span<const VoidPatch> patches, const PatchHistory& history, const Model& model,
                                  const RayCaster& obstacles, const ScannerImages& images,
                                  const ObjectiveOptions& options, const Progress& progress) {
  std::vector<double> sums(static_cast<std::size_t>(images.positions()), 0.0);
  const auto image = sightingsOf(patches, history, obstacles, images, options,
                                 progress.part(0.0, options.tolerance > 0.0 ? 0.5 : 1.0));
  forEachContribution(patches, history, image, images, options, [&](std::uint32_t cell, double area) {
    for (const int position : images.positionsOf(cell)) sums[static_cast<std::size_t>(position)] += area;
  });
  if (options.tolerance > 0.0) {
    const auto poor = intersect(poorTrianglesImage(model, obstacles, images, options, progress.part(0.5, 1.0)), images);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += poor[i];
  }
  return sums;
}

PositionalImage voidImage(std::span<const VoidPatch> patches, const PatchHistory& history, const Model& model,
                          const RayCaster& obstacles, const ScannerImages& images, const ObjectiveOptions& options,
                          const Progress& progress) {
  PositionalImage image = sightingsOf(patches, history, obstacles, images, options,
                                      progress.part(0.0, options.tolerance > 0.0 ? 0.5 : 1.0));
  std::fill(image.sums.begin(), image.sums.end(), 0);
  if (options.tolerance > 0.0)
    image.sums = poorTrianglesImage(model, obstacles, images, options, progress.part(0.5, 1.0)).sums;
  forEachContribution(patches, history, image, images, options, [&](std::uint32_t cell, double area) {
    image.sums[cell] += std::llround(area / PositionalImage::kUnit);
  });
  return image;
}

PositionalImage overlapImage(std::span<const SurfaceElement> seen, const RayCaster& obstacles,
                             const ScannerImages& images, const ObjectiveOptions& options, const Progress& progress) {
  std::vector<ObservationSource> sources;
  sources.reserve(seen.size());
  for (const SurfaceElement& e : seen)
    if (!e.normal.isZero()) sources.push_back({e.centre, e.normal, e.area});
  return accumulate(sources, obstacles, images, options.breakdownAngle, accumulation(options, false), progress);
}

std::vector<double> overlapObjective(std::span<const SurfaceElement> seen, const RayCaster& obstacles,
                                     const ScannerImages& images, const ObjectiveOptions& options,
                                     const Progress& progress) {
  return intersect(overlapImage(seen, obstacles, images, options, progress), images);
}

}  // namespace vantage
