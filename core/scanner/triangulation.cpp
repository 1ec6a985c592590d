#include "scanner/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/mesh_border.h"
#include "scanner/sample_spacing.h"

namespace vantage {
namespace {

// Confidence of vertices whose normal noise has tilted away from the scanner.
constexpr double kAngleSlack = radians(8.0);
constexpr double kMinConfidence = 1e-3;

using GridTriangle = std::array<std::size_t, 3>;  // indices of samples

// Decides which grid triangles are surface.
class SurfaceTest {
 public:
  SurfaceTest(const RangeImage& image, const TriangulationOptions& options)
      : image_(image),
        maxLengthRatio_(options.discontinuityFactor / std::cos(options.breakdownAngle)),
        minCosine_(
            std::cos(std::min(options.breakdownAngle + options.angleSlack.value_or(kAngleSlack), radians(89.0)))) {}

  [[nodiscard]] bool continuous(std::size_t a, std::size_t b) const {
    return (image_.point(a) - image_.point(b)).norm() <= maxLengthRatio_ * raySpacing(image_, a, b);
  }

  // All three samples are there, without a jump between them, and the triangle does not lean too far from its rays. Its
  // corners turn counter-clockwise seen from the scanner.
  [[nodiscard]] bool isSurface(const GridTriangle& t) const {
    for (const std::size_t i : t)
      if (!image_.valid(i)) return false;
    if (!continuous(t[0], t[1]) || !continuous(t[1], t[2]) || !continuous(t[2], t[0])) return false;
    const Vec3 a = image_.point(t[0]);
    const Vec3 n = (image_.point(t[1]) - a).cross(image_.point(t[2]) - a);
    const Vec3 rays = direction(t[0]) + direction(t[1]) + direction(t[2]);
    return n.norm() > 0.0 && -n.dot(rays) >= minCosine_ * n.norm() * rays.norm();
  }

 private:
  [[nodiscard]] const Vec3& direction(std::size_t i) const { return image_.rays->ray(i).direction; }

  const RangeImage& image_;
  double maxLengthRatio_;
  double minCosine_;
};

// Whether going along a row and then down a column turns clockwise seen from the scanner, where its samples are.
bool gridIsMirrored(const RangeImage& image) {
  const RayGrid& rays = *image.rays;
  double turn = 0.0;
  for (int r = 0; r + 1 < rays.rows(); ++r) {
    for (int c = 0; c + 1 < rays.columns(); ++c) {
      const std::size_t i = rays.index(r, c);
      if (!image.valid(i)) continue;
      const auto depth = static_cast<double>(image.range[i]);
      auto motionTo = [&](std::size_t j) {
        const RangingRay& from = rays.ray(i);
        const RangingRay& to = rays.ray(j);
        return Vec3((to.origin - from.origin) + depth * (to.direction - from.direction));
      };
      turn += motionTo(rays.index(r, c + 1)).cross(motionTo(rays.index(r + 1, c))).dot(rays.ray(i).direction);
    }
  }
  return turn > 0.0;
}

// Cuts every square of the grid along the shorter of its diagonals, or the only one that has both its samples.
std::vector<GridTriangle> gridTriangles(const RangeImage& image, const SurfaceTest& surface) {
  const RayGrid& rays = *image.rays;
  const bool mirrored = gridIsMirrored(image);
  std::vector<GridTriangle> triangles;
  auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const GridTriangle t = mirrored ? GridTriangle{a, c, b} : GridTriangle{a, b, c};
    if (surface.isSurface(t)) triangles.push_back(t);
  };
  for (int r = 0; r + 1 < rays.rows(); ++r) {
    for (int c = 0; c + 1 < rays.columns(); ++c) {
      const std::size_t a = rays.index(r, c);
      const std::size_t b = rays.index(r, c + 1);
      const std::size_t d = rays.index(r + 1, c);
      const std::size_t e = rays.index(r + 1, c + 1);
      const bool ae = image.valid(a) && image.valid(e);
      const bool bd = image.valid(b) && image.valid(d);
      if (!ae && !bd) continue;
      if (ae && (!bd || (image.point(a) - image.point(e)).norm() <= (image.point(b) - image.point(d)).norm())) {
        add(a, b, e);
        add(a, e, d);
      } else {
        add(a, b, d);
        add(b, e, d);
      }
    }
  }
  return triangles;
}

// Median distance between neighbouring rays at their samples; 0 when no two neighbours belong together.
double medianSpacing(const RangeImage& image, const SurfaceTest& surface) {
  std::vector<double> lengths;
  const RayGrid& rays = *image.rays;
  for (int r = 0; r + 1 < rays.rows(); ++r) {
    for (int c = 0; c + 1 < rays.columns(); ++c) {
      const std::size_t i = rays.index(r, c);
      if (!image.valid(i)) continue;
      for (const std::size_t j : {rays.index(r, c + 1), rays.index(r + 1, c)})
        if (image.valid(j) && surface.continuous(i, j)) lengths.push_back(raySpacing(image, i, j));
    }
  }
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

ViewMesh triangulate(const RangeImage& image, const TriangulationOptions& options) {
  validate(image);
  const SurfaceTest surface(image, options);
  const std::vector<GridTriangle> triangles = gridTriangles(image, surface);

  ViewMesh view;
  view.vertexOfSample.assign(image.rays->size(), kNoIndex);
  for (const GridTriangle& t : triangles)
    for (const std::size_t i : t) view.vertexOfSample[i] = 0;
  for (std::size_t i = 0; i < view.vertexOfSample.size(); ++i) {
    if (view.vertexOfSample[i] == kNoIndex) continue;
    view.vertexOfSample[i] = static_cast<std::uint32_t>(view.sample.size());
    view.sample.push_back(static_cast<std::uint32_t>(i));
    view.mesh.vertices.push_back(image.point(i));
  }
  view.mesh.triangles.reserve(triangles.size());
  for (const GridTriangle& t : triangles)
    view.mesh.triangles.push_back({view.vertexOfSample[t[0]], view.vertexOfSample[t[1]], view.vertexOfSample[t[2]]});

  view.normals = computeVertexNormals(view.mesh);
  view.confidence.resize(view.normals.size());
  for (std::size_t v = 0; v < view.normals.size(); ++v) {
    const double cosine = -view.normals[v].dot(image.rays->ray(view.sample[v]).direction);
    view.confidence[v] = static_cast<float>(std::clamp(cosine, kMinConfidence, 1.0));
  }
  view.onBoundary = borderVertices(view.mesh);
  view.spacing = medianSpacing(image, surface);
  return view;
}

}  // namespace vantage
