#include "planning/objective.h"

#include <algorithm>
#include <cmath>

#include "planning/patch_promise.h"
#include "positional_space/objective_sums.h"

namespace vantage {
namespace {

AccumulationOptions accumulation(const PlanningScene& scene, bool keepSightings) {
  AccumulationOptions result;
  result.keepSightings = keepSightings;
  result.surfaceOffset = scene.sight().options().offset;
  return result;
}

// What a patch gives to a cell that it is seen through [mm^2]; 0 when that attracts no view.
double contribution(const PlanningScene& scene, std::size_t p, const Sighting& sighting, const ScannerImages& images) {
  if (!scene.history().attracts(p, static_cast<double>(sighting.confidence))) return 0.0;
  const VoidPatch& patch = scene.patches()[p];
  const double area = patchShare(scene) * patch.weight * static_cast<double>(sighting.confidence);
  if (!scene.options().lookAhead) return area;
  const Vec3 direction = (images.ray(sighting.cell).point - patch.centre).normalized();
  return area * lookAhead(patch, direction, scene.breakdownAngle());
}

// Forgets the sightings of each patch beyond its own widest angle.
void narrow(PositionalImage& image, const PlanningScene& scene) {
  const std::span<const VoidPatch> patches = scene.patches();
  std::size_t kept = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto sightings = image.sightingsOf(p);
    const double minCosine = std::cos(widestAngle(scene, patches[p]));
    image.sightingStart[p] = kept;
    for (const Sighting& sighting : sightings)
      if (static_cast<double>(sighting.confidence) >= minCosine) image.sightings[kept++] = sighting;
  }
  image.sightingStart[patches.size()] = kept;
  image.sightings.resize(kept);
}

// Which patch is seen through which cell; the sums do not count yet.
PositionalImage sightingsOf(const PlanningScene& scene, const ScannerImages& images, const Progress& progress) {
  const std::span<const VoidPatch> patches = scene.patches();
  std::vector<ObservationSource> sources;
  sources.reserve(patches.size());
  double widest = scene.breakdownAngle();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    sources.push_back({patches[p].centre, patches[p].normal, scene.history().answered(p) ? 0.0 : patches[p].weight});
    widest = std::max(widest, widestAngle(scene, patches[p]));
  }
  PositionalImage image = accumulate(sources, scene.obstacles(), images, widest, accumulation(scene, true), progress);
  if (scene.options().lookAhead) narrow(image, scene);
  return image;
}

// Triangles sampled with less confidence than u: c(T) is the least of their vertices.
std::vector<ObservationSource> poorTriangles(const PlanningScene& scene) {
  const Model& model = *scene.input().model;
  std::vector<ObservationSource> sources;
  for (const Triangle& t : model.mesh.triangles) {
    const float confidence = std::min({model.confidence[t[0]], model.confidence[t[1]], model.confidence[t[2]]});
    const Vec3 normal = triangleNormal(model.mesh, t);
    if (static_cast<double>(confidence) >= scene.options().tolerance || normal.isZero()) continue;
    sources.push_back({scene.pointOnTable(triangleCentre(model.mesh, t)), scene.directionOnTable(normal),
                       triangleArea(model.mesh, t)});
  }
  return sources;
}

PositionalImage poorTrianglesImage(const PlanningScene& scene, const ScannerImages& images, const Progress& progress) {
  // Rays that would not reach the tolerance are not worth tracing: a narrower breakdown angle leaves them out.
  const double angle = std::min(scene.breakdownAngle(), std::acos(std::clamp(scene.options().tolerance, 0.0, 1.0)));
  return accumulate(poorTriangles(scene), scene.obstacles(), images, angle, accumulation(scene, false), progress);
}

// Adds the expected surface to the sums: the area that is seen through a cell, however obliquely.
void addExpected(PositionalImage& image, const PlanningScene& scene, const ScannerImages& images,
                 const Progress& progress) {
  const PositionalImage expected = expectedImage(scene, images, progress);
  const std::vector<LevelFace>& faces = scene.expected()->closing.faces;
  const double factor = scene.expected()->trust.factor;
  for (std::size_t f = 0; f < expected.sourceCount(); ++f) {
    const auto area = std::llround(factor * faces[f].area / PositionalImage::kUnit);
    for (const Sighting& sighting : expected.sightingsOf(f))
      if (scene.expectedAttracts(f, static_cast<double>(sighting.confidence))) image.sums[sighting.cell] += area;
  }
}

}  // namespace

PositionalImage expectedImage(const PlanningScene& scene, const ScannerImages& images, const Progress& progress) {
  const SightOptions& looking = scene.sightOfExpected().options();
  std::vector<ObservationSource> sources;
  for (const LevelFace& face : scene.expected()->closing.faces)
    sources.push_back({face.centre, face.normal, face.area});
  AccumulationOptions options;
  options.keepSightings = true;
  options.surfaceOffset = looking.offset;
  return accumulate(sources, scene.expected()->all, images, looking.breakdownAngle, options, progress);
}

PositionalImage voidImage(const PlanningScene& scene, const ScannerImages& images, const Progress& progress) {
  const bool tolerant = scene.options().tolerance > 0.0;
  const double patchesDone = tolerant || scene.expected() != nullptr ? 0.5 : 1.0;
  PositionalImage image = sightingsOf(scene, images, progress.part(0.0, patchesDone));
  std::fill(image.sums.begin(), image.sums.end(), 0);
  if (tolerant) image.sums = poorTrianglesImage(scene, images, progress.part(patchesDone, 0.8)).sums;
  if (scene.expected() != nullptr) addExpected(image, scene, images, progress.part(0.8, 1.0));
  for (std::size_t p = 0; p < image.sourceCount(); ++p)
    for (const Sighting& sighting : image.sightingsOf(p))
      image.sums[sighting.cell] += std::llround(contribution(scene, p, sighting, images) / PositionalImage::kUnit);
  return image;
}

PositionalImage overlapImage(const PlanningScene& scene, std::span<const SurfaceElement> seen,
                             const ScannerImages& images, const Progress& progress) {
  std::vector<ObservationSource> sources;
  sources.reserve(seen.size());
  for (const SurfaceElement& e : seen)
    if (!e.normal.isZero()) sources.push_back({e.centre, e.normal, e.area});
  return accumulate(sources, scene.obstacles(), images, scene.breakdownAngle(), accumulation(scene, false), progress);
}

std::vector<double> voidObjective(const PlanningScene& scene, const ScannerImages& images, const Progress& progress) {
  return intersect(voidImage(scene, images, progress), images);
}

std::vector<double> overlapObjective(const PlanningScene& scene, std::span<const SurfaceElement> seen,
                                     const ScannerImages& images, const Progress& progress) {
  return intersect(overlapImage(scene, seen, images, progress), images);
}

}  // namespace vantage
