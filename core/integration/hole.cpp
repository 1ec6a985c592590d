#include "integration/hole.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "integration/manifold.h"
#include "integration/polygon_fill.h"

namespace vantage {
namespace {

// A triangle across a hole leans no farther than this from the surface around it,
const double kMinFlatness = std::cos(radians(75.0));
// unless it is smaller than this share of the square of the longest chord.
constexpr double kNegligible = 0.01;

// Mean normal of the triangles around the loop.
Vec3 normalAround(const ModelEditor& editor, const std::vector<std::uint32_t>& loop) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum +=
        triangleNormal(editor.model().mesh, editor.triangle(editor.triangleAt(loop[(i + 1) % loop.size()], loop[i])));
  return sum.normalized();
}

// What the new view says about the middle of the hole.
enum class Evidence { Surface, Beyond, Nothing };
Evidence lookAt(const Vec3& centre, const Vec3& normal, const GridSurface& surface, double tolerance) {
  const Vec3 p = surface.T_scanner_object() * centre;
  const auto position = surface.rays().locate(p);
  if (!position) return Evidence::Nothing;
  const auto contact = surface.at(*position);
  if (!contact) return Evidence::Nothing;
  const Mesh& mesh = surface.mesh().mesh;
  const Triangle& t = mesh.triangles[contact->triangle];
  const Vec3 plane = triangleNormal(mesh, t);
  const double height = (p - mesh.vertices[t[0]]).dot(plane);
  if (height > tolerance) return Evidence::Beyond;
  const bool agrees = height >= -tolerance && (surface.T_scanner_object().linear() * normal).dot(plane) > 0.0;
  return agrees ? Evidence::Surface : Evidence::Nothing;
}

bool isSurface(const ModelEditor& editor, const std::vector<std::uint32_t>& loop, const Vec3& normal,
               const GridSurface& surface, double tolerance) {
  Vec3 centre = Vec3::Zero();
  bool severalViews = false;
  for (const std::uint32_t v : loop) {
    centre += editor.position(v) / static_cast<double>(loop.size());
    severalViews = severalViews || editor.model().vertexView[v] != editor.model().vertexView[loop[0]];
  }
  const Evidence evidence = lookAt(centre, normal, surface, tolerance);
  if (evidence == Evidence::Nothing) return severalViews || loop.size() == 3;
  return evidence == Evidence::Surface;
}

class HoleCloser {
 public:
  HoleCloser(ModelEditor& editor, const GridSurface& surface, std::uint32_t newView, const ZipperOptions& options)
      : editor_(editor),
        surface_(surface),
        newView_(newView),
        options_(options),
        tolerance_(std::max(options.surfaceTolerance, options.spacingTolerance * surface.mesh().spacing)),
        maxChord_(options.maxHoleChord * surface.mesh().spacing) {}

  bool close(const std::vector<std::uint32_t>& loop) {
    if (!isSurface(editor_, loop, normalAround(editor_, loop), surface_, tolerance_)) return false;
    return fill(loop) || refill(loop);
  }

 private:
  bool fill(const std::vector<std::uint32_t>& loop) {
    const Vec3 normal = normalAround(editor_, loop);
    const std::vector<Triangle> triangles = fillPolygon(editor_, loop, maxChord_, [&](const Triangle&, const Vec3& a) {
      return a.dot(normal) >= kMinFlatness * a.norm() || a.norm() <= kNegligible * maxChord_ * maxChord_;
    });
    for (const Triangle& t : triangles) editor_.addTriangle(t, newView_);
    return !triangles.empty();
  }

  // Where the borders overlap instead of gaping, there is nothing to fill until the triangles at the loop are gone.
  bool refill(const std::vector<std::uint32_t>& loop) {
    std::vector<std::pair<Triangle, std::uint32_t>> removed;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t t = editor_.triangleAt(loop[(i + 1) % loop.size()], loop[i]);
      if (t == kNoIndex) continue;
      removed.emplace_back(editor_.triangle(t), editor_.model().triangleView[t]);
      editor_.removeTriangle(t);
    }
    if (refillWidened(removed)) return true;
    for (const auto& [triangle, view] : removed) editor_.addTriangle(triangle, view);
    return false;
  }

  bool refillWidened(const std::vector<std::pair<Triangle, std::uint32_t>>& removed) {
    for (const auto& [triangle, view] : removed)
      for (const std::uint32_t v : triangle)
        if (!isSingleFan(editor_, v)) return false;
    for (const auto& [triangle, view] : removed)
      for (const std::uint32_t v : triangle) {
        const std::vector<std::uint32_t> wider = borderLoop(editor_, v, 2 * options_.maxHoleEdges);
        if (!wider.empty()) return holds(wider, removed) && fill(wider);
      }
    return false;
  }

  // Whether every border vertex that the removal made is on the loop: one hole, not several.
  bool holds(const std::vector<std::uint32_t>& loop,
             const std::vector<std::pair<Triangle, std::uint32_t>>& removed) const {
    for (const auto& [triangle, view] : removed)
      for (const std::uint32_t v : triangle)
        if (editor_.onBoundary(v) && std::find(loop.begin(), loop.end(), v) == loop.end()) return false;
    return true;
  }

  ModelEditor& editor_;
  const GridSurface& surface_;
  std::uint32_t newView_;
  const ZipperOptions& options_;
  double tolerance_;
  double maxChord_;
};

}  // namespace

std::size_t closeSmallHoles(ModelEditor& editor, const GridSurface& surface, std::uint32_t newView,
                            const ZipperOptions& options) {
  HoleCloser closer(editor, surface, newView, options);
  std::vector<std::uint8_t> tried(editor.vertexCount(), 0);
  std::size_t closed = 0;
  for (std::uint32_t v = 0; v < editor.vertexCount(); ++v) {
    if (tried[v] || !editor.onBoundary(v)) continue;
    const std::vector<std::uint32_t> loop = borderLoop(editor, v, options.maxHoleEdges);
    for (const std::uint32_t w : loop) tried[w] = 1;
    if (!loop.empty() && closer.close(loop)) ++closed;
  }
  return closed;
}

}  // namespace vantage
