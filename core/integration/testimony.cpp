#include "integration/testimony.h"

#include <algorithm>

#include "base/parallel.h"

namespace vantage {
namespace {

// At a seam the normals of what lies between two views may lean far from either.
constexpr double kNormalTolerance = radians(100.0);
constexpr double kSteepest = radians(90.0);
// A sample without surface around it says less than the worst surface.
constexpr double kSampleQuality = 0.05;

ZipperOptions atSeams(ZipperOptions options) {
  options.normalTolerance = kNormalTolerance;
  options.steepest = kSteepest;
  return options;
}

}  // namespace

Witnesses::Witnesses(std::span<const View> views, const ZipperOptions& options, const Progress& progress)
    : views_(views), margin_(options.confidenceMargin), surfaces_(views.size()) {
  parallelChunks(views.size(), 1, progress,
                 [&](std::size_t begin, std::size_t) { surfaces_[begin].emplace(views_[begin]); });
  projectors_.reserve(views.size());
  for (const auto& surface : surfaces_) projectors_.emplace_back(*surface, atSeams(options));
}

Testimony Witnesses::ask(const Model& model, std::span<const Triangle> triangles) const {
  Testimony result;
  for (const Triangle& t : triangles) {
    const double size = triangleArea(model.mesh, t);
    Vec3 centre = Vec3::Zero();
    Vec3 facing = Vec3::Zero();
    for (const std::uint32_t v : t) {
      centre += model.mesh.vertices[v] / 3.0;
      facing += normal(model.vertexView[v], model.vertexSample[v]);
    }
    const Qualities here = at(centre, facing.normalized());
    result.whole += size;
    if (here.refuted > here.seen + margin_)
      result.refuted += size;
    else if (here.seen > 0.0)
      result.seen += size;
  }
  return result;
}

Vec3 Witnesses::normal(std::uint32_t view, std::uint32_t sample) const {
  const ViewMesh& mesh = *views_[view].mesh;
  const std::uint32_t own = mesh.vertexOfSample[sample];
  return own == kNoIndex ? Vec3(Vec3::Zero()) : Vec3(views_[view].T_object_scanner.linear() * mesh.normals[own]);
}

Witnesses::Qualities Witnesses::at(const Vec3& place, const Vec3& normal) const {
  Qualities result;
  for (std::size_t k = 0; k < views_.size(); ++k) {
    const Pose& T_scanner_object = surfaces_[k]->T_scanner_object();
    const Vec3 p = T_scanner_object * place;
    std::optional<GridPosition> hint;
    const ProjectedVertex seen = projectors_[k].project(p, T_scanner_object.linear() * normal, hint);
    const auto quality = static_cast<double>(seen.quality);
    if (seen.contact == Contact::On)
      result.seen = std::max(result.seen, quality);
    else if (seen.refuted)
      result.refuted = std::max(result.refuted, quality);
    else if (hasSample(k, seen, p))
      result.seen = std::max(result.seen, kSampleQuality);
  }
  return result;
}

bool Witnesses::hasSample(std::size_t view, const ProjectedVertex& seen, const Vec3& place) const {
  if (seen.contact == Contact::Unseen) return false;
  const RangeImage& image = *views_[view].image;
  const GridPosition position = surfaces_[view]->centreOf({seen.place, seen.place, seen.place});
  const std::size_t nearest = image.rays->nearest(position);
  return image.valid(nearest) && (image.point(nearest) - place).norm() <= projectors_[view].tolerance();
}

}  // namespace vantage
