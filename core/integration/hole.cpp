#include "integration/hole.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vantage {
namespace {

// A triangle across a hole leans no farther from the hole's plane than this.
const double kMinFlatness = std::cos(radians(75.0));

// The border edge that leaves the vertex, or kNoIndex.
std::uint32_t nextOnBorder(const ModelEditor& editor, std::uint32_t vertex) {
  std::uint32_t next = kNoIndex;
  editor.visitTriangles(vertex, [&](std::uint32_t t) {
    const Triangle& v = editor.triangle(t);
    const int k = v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    if (editor.triangleAt(v[(k + 1) % 3], vertex) == kNoIndex) next = v[(k + 1) % 3];
  });
  return next;
}

// The loop through the vertex, turned so that it runs counter-clockwise about the hole; empty when it is too long.
std::vector<std::uint32_t> loopAt(const ModelEditor& editor, std::uint32_t vertex, int maxEdges) {
  std::vector<std::uint32_t> loop;
  std::uint32_t at = vertex;
  if (nextOnBorder(editor, at) == kNoIndex) return loop;
  do {
    loop.push_back(at);
    at = nextOnBorder(editor, at);
    if (at == kNoIndex || loop.size() > static_cast<std::size_t>(maxEdges)) return {};
  } while (at != vertex);
  if (loop.size() < 3) return {};
  std::reverse(loop.begin(), loop.end());
  return loop;
}

// Least-area triangulation of a polygon of few corners; empty when every one would be folded.
class PolygonFill {
 public:
  PolygonFill(const ModelEditor& editor, const std::vector<std::uint32_t>& loop) : editor_(editor), loop_(loop) {
    for (std::size_t i = 2; i < loop.size(); ++i) normal_ += area(0, i - 1, i);
    if (normal_.norm() > 0.0) normal_.normalize();
  }

  [[nodiscard]] std::vector<Triangle> triangles() {
    const std::size_t n = loop_.size();
    cost_.assign(n * n, 0.0);
    apex_.assign(n * n, 0);
    for (std::size_t span = 2; span < n; ++span)
      for (std::size_t i = 0; i + span < n; ++i) solve(i, i + span);
    std::vector<Triangle> result;
    if (cost_[n - 1] < std::numeric_limits<double>::infinity()) collect(0, n - 1, result);
    return result;
  }

  [[nodiscard]] const Vec3& normal() const { return normal_; }

 private:
  [[nodiscard]] Vec3 area(std::size_t a, std::size_t b, std::size_t c) const {
    const Vec3& p = editor_.position(loop_[a]);
    return 0.5 * (editor_.position(loop_[b]) - p).cross(editor_.position(loop_[c]) - p);
  }

  [[nodiscard]] bool chordFree(std::size_t a, std::size_t b) const {
    if (b == a + 1 || (a == 0 && b + 1 == loop_.size())) return true;
    return editor_.triangleAt(loop_[a], loop_[b]) == kNoIndex && editor_.triangleAt(loop_[b], loop_[a]) == kNoIndex;
  }

  void solve(std::size_t i, std::size_t k) {
    const std::size_t n = loop_.size();
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t j = i + 1; j < k; ++j) {
      const Vec3 a = area(i, j, k);
      if (a.dot(normal_) < kMinFlatness * a.norm() || !chordFree(i, k)) continue;
      const double cost = cost_[i * n + j] + cost_[j * n + k] + a.norm();
      if (cost >= best) continue;
      best = cost;
      apex_[i * n + k] = j;
    }
    cost_[i * n + k] = best;
  }

  void collect(std::size_t i, std::size_t k, std::vector<Triangle>& result) const {
    if (k < i + 2) return;
    const std::size_t j = apex_[i * loop_.size() + k];
    result.push_back({loop_[i], loop_[j], loop_[k]});
    collect(i, j, result);
    collect(j, k, result);
  }

  const ModelEditor& editor_;
  const std::vector<std::uint32_t>& loop_;
  Vec3 normal_ = Vec3::Zero();
  std::vector<double> cost_;
  std::vector<std::size_t> apex_;
};

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

// Whether the surface around the loop faces the way the fill would; it does not at the outer border of a small piece.
bool facesAlike(const ModelEditor& editor, const std::vector<std::uint32_t>& loop, const Vec3& normal) {
  Vec3 around = Vec3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t t = editor.triangleAt(loop[(i + 1) % loop.size()], loop[i]);
    if (t != kNoIndex) around += triangleNormal(editor.model().mesh, editor.triangle(t));
  }
  return around.dot(normal) > 0.0;
}

double widthOf(const ModelEditor& editor, const std::vector<std::uint32_t>& loop) {
  double width = 0.0;
  for (const std::uint32_t a : loop)
    for (const std::uint32_t b : loop) width = std::max(width, (editor.position(a) - editor.position(b)).norm());
  return width;
}

}  // namespace

std::size_t closeSmallHoles(ModelEditor& editor, const GridSurface& surface, std::uint32_t newView, const ZipperOptions& options) {
  const double spacing = surface.mesh().spacing;
  const double tolerance = std::max(options.surfaceTolerance, options.spacingTolerance * spacing);
  std::size_t closed = 0;
  for (std::uint32_t v = 0; v < editor.vertexCount(); ++v) {
    const std::vector<std::uint32_t> loop = loopAt(editor, v, options.maxHoleEdges);
    if (loop.empty() || widthOf(editor, loop) > options.maxHoleSize * spacing) continue;
    PolygonFill fill(editor, loop);
    if (!facesAlike(editor, loop, fill.normal()) || !isSurface(editor, loop, fill.normal(), surface, tolerance)) continue;
    const std::vector<Triangle> triangles = fill.triangles();
    for (const Triangle& t : triangles) editor.addTriangle(t, newView);
    closed += triangles.empty() ? 0 : 1;
  }
  return closed;
}

}  // namespace vantage
