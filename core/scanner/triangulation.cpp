#include "scanner/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

// Decides which grid triangles are surface.
class SurfaceTest {
 public:
  SurfaceTest(const RangeImage& image, const TriangulationOptions& options)
      : image_(image),
        maxLengthRatio_(options.discontinuityFactor / std::cos(options.breakdownAngle)),
        minCosine_(std::cos(std::min(options.breakdownAngle + options.angleSlack, radians(89.0)))) {}

  // Distance of two neighbouring rays where the nearer of their samples lies, across the rays.
  [[nodiscard]] double raySpacing(std::size_t a, std::size_t b) const {
    const double depth = std::min(image_.range[a], image_.range[b]);
    const RangingRay& ra = image_.rays->ray(a);
    const RangingRay& rb = image_.rays->ray(b);
    const Vec3 offset = (rb.origin - ra.origin) + depth * (rb.direction - ra.direction);
    return (offset - offset.dot(ra.direction) * ra.direction).norm();
  }

  [[nodiscard]] bool continuous(std::size_t a, std::size_t b) const {
    return (image_.point(a) - image_.point(b)).norm() <= maxLengthRatio_ * raySpacing(a, b);
  }

  // Counter-clockwise seen from the scanner and not too steep.
  [[nodiscard]] bool facing(const std::array<std::size_t, 3>& t, bool flip) const {
    const Vec3 a = image_.point(t[0]);
    Vec3 n = (image_.point(t[1]) - a).cross(image_.point(t[2]) - a);
    if (flip) n = -n;
    const double length = n.norm();
    if (!(length > 0.0)) return false;
    const Vec3 ray = (image_.rays->ray(t[0]).direction + image_.rays->ray(t[1]).direction + image_.rays->ray(t[2]).direction).normalized();
    return -n.dot(ray) >= minCosine_ * length;
  }

 private:
  const RangeImage& image_;
  double maxLengthRatio_;
  double minCosine_;
};

// Whether row, column order turns clockwise seen from the scanner.
bool gridIsMirrored(const RayGrid& rays) {
  const int r = rays.rows() / 2 - 1 + (rays.rows() < 2);
  const int c = rays.columns() / 2 - 1 + (rays.columns() < 2);
  const RangingRay& a = rays.ray(rays.index(r, c));
  const RangingRay& b = rays.ray(rays.index(r, c + 1));
  const RangingRay& d = rays.ray(rays.index(r + 1, c));
  // A depth at which neighbouring rays are apart even when they share their origin.
  const double depth = 1e3;
  const Vec3 alongColumn = (b.origin - a.origin) + depth * (b.direction - a.direction);
  const Vec3 alongRow = (d.origin - a.origin) + depth * (d.direction - a.direction);
  return alongColumn.cross(alongRow).dot(a.direction) > 0.0;
}

std::vector<std::array<std::size_t, 3>> gridTriangles(const RangeImage& image, const SurfaceTest& surface, bool mirrored) {
  const RayGrid& rays = *image.rays;
  std::vector<std::array<std::size_t, 3>> triangles;
  auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (!image.valid(a) || !image.valid(b) || !image.valid(c)) return;
    if (!surface.continuous(a, b) || !surface.continuous(b, c) || !surface.continuous(c, a)) return;
    if (!surface.facing({a, b, c}, mirrored)) return;
    if (mirrored) std::swap(b, c);
    triangles.push_back({a, b, c});
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
      const bool cutAe =
          ae && (!bd || (image.point(a) - image.point(e)).norm() <= (image.point(b) - image.point(d)).norm());
      if (cutAe) {
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

double medianSpacing(const RangeImage& image, const SurfaceTest& surface) {
  std::vector<double> lengths;
  const RayGrid& rays = *image.rays;
  for (int r = 0; r + 1 < rays.rows(); ++r) {
    for (int c = 0; c + 1 < rays.columns(); ++c) {
      const std::size_t i = rays.index(r, c);
      if (!image.valid(i)) continue;
      for (const std::size_t j : {rays.index(r, c + 1), rays.index(r + 1, c)})
        if (image.valid(j) && surface.continuous(i, j)) lengths.push_back(surface.raySpacing(i, j));
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
  const auto triangles = gridTriangles(image, surface, gridIsMirrored(*image.rays));

  ViewMesh view;
  view.vertexOfSample.assign(image.rays->size(), kNoIndex);
  for (const auto& t : triangles)
    for (const std::size_t i : t) view.vertexOfSample[i] = 0;
  for (std::size_t i = 0; i < view.vertexOfSample.size(); ++i) {
    if (view.vertexOfSample[i] == kNoIndex) continue;
    view.vertexOfSample[i] = static_cast<std::uint32_t>(view.sample.size());
    view.sample.push_back(static_cast<std::uint32_t>(i));
    view.mesh.vertices.push_back(image.point(i));
  }
  view.mesh.triangles.reserve(triangles.size());
  for (const auto& t : triangles)
    view.mesh.triangles.push_back({view.vertexOfSample[t[0]], view.vertexOfSample[t[1]], view.vertexOfSample[t[2]]});

  view.normals = computeVertexNormals(view.mesh);
  view.confidence.resize(view.normals.size());
  for (std::size_t v = 0; v < view.normals.size(); ++v)
    view.confidence[v] = static_cast<float>(std::clamp(-view.normals[v].dot(image.rays->ray(view.sample[v]).direction), 1e-3, 1.0));
  view.onBoundary = MeshTopology(view.mesh).onBoundary();
  view.spacing = medianSpacing(image, surface);
  return view;
}

}  // namespace vantage
