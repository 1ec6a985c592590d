#include "void_space/ray_index.h"

#include <algorithm>
#include <string>

#include "base/errors.h"

namespace vantage {

RayIndex::RayIndex(std::span<const View> views) : views_(views) {
  T_scanner_object_.reserve(views.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    if (views[v].image == nullptr || views[v].image->rays == nullptr)
      throw InvalidInput("view " + std::to_string(v) + " has no range image");
    T_scanner_object_.push_back(views[v].T_object_scanner.inverse());
  }
}

std::optional<RayPassage> RayIndex::through(std::uint32_t view, const Vec3& p,
                                            const std::optional<GridPosition>& hint) const {
  const RayGrid& rays = *views_[view].image->rays;
  const Vec3 inScanner = T_scanner_object_[view] * p;
  const auto position = hint ? rays.locate(inScanner, *hint) : rays.locate(inScanner);
  if (!position) return std::nullopt;
  RayPassage passage;
  passage.view = view;
  passage.position = *position;
  passage.ray = rays.nearest(*position);
  passage.line = rays.rayAt(*position);
  complete(passage, p, inScanner);
  return passage;
}

RayPassage RayIndex::ofSample(std::uint32_t view, std::uint32_t sample, const Vec3& p) const {
  const RayGrid& rays = *views_[view].image->rays;
  const auto columns = static_cast<std::uint32_t>(rays.columns());
  const std::uint32_t row = sample / columns;
  RayPassage passage;
  passage.view = view;
  passage.position = {static_cast<double>(row), static_cast<double>(sample % columns)};
  passage.ray = sample;
  passage.line = rays.ray(sample);
  complete(passage, p, T_scanner_object_[view] * p);
  return passage;
}

// Takes the line from scanner to object coordinates and fills in what follows from it.
void RayIndex::complete(RayPassage& passage, const Vec3& p, const Vec3& inScanner) const {
  const View& view = views_[passage.view];
  passage.spacing = view.image->rays->spacingAt(inScanner, passage.position);
  passage.line = {view.T_object_scanner * passage.line.origin, view.T_object_scanner.linear() * passage.line.direction};
  passage.depth = (p - passage.line.origin).dot(passage.line.direction);
  passage.sampleDepth = sampleDepth(passage, passage.ray);
}

std::optional<double> RayIndex::sampleDepth(const RayPassage& passage, std::size_t ray) const {
  const View& view = views_[passage.view];
  if (!view.image->valid(ray)) return std::nullopt;
  return (view.T_object_scanner * view.image->point(ray) - passage.line.origin).dot(passage.line.direction);
}

std::vector<double> RayIndex::depthsAround(const RayPassage& passage) const {
  const RayGrid& rays = *views_[passage.view].image->rays;
  const int row = static_cast<int>(passage.ray) / rays.columns();
  const int column = static_cast<int>(passage.ray) % rays.columns();
  std::vector<double> depths;
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rays.rows() - 1); ++r)
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, rays.columns() - 1); ++c)
      if (const auto depth = sampleDepth(passage, rays.index(r, c))) depths.push_back(*depth);
  return depths;
}

std::vector<Vec3> RayIndex::receivers(const RayPassage& passage) const {
  const View& view = views_[passage.view];
  std::vector<Vec3> positions;
  for (const Vec3& r : view.image->rays->receivers(passage.ray)) positions.push_back(view.T_object_scanner * r);
  return positions;
}

}  // namespace vantage
