#include "scanner/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "geometry/mesh_border.h"
#include "scanner/sample_spacing.h"

namespace vantage {
namespace {

// Confidence of vertices whose normal noise has tilted away from the scanner.
constexpr double kAngleSlack = radians(8.0);
constexpr double kMinConfidence = 1e-3;

using GridTriangle = std::array<std::uint32_t, 3>;  // indices of samples

// Rows of a grid that one thread works on at once.
constexpr std::size_t kRows = 32;

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

struct Rows {
  int begin;
  int end;
};

std::size_t rowChunks(const RayGrid& rays) {
  return (static_cast<std::size_t>(rays.rows()) - 1 + kRows - 1) / kRows;
}

// Calls visit(rows, chunk) for chunks of the grid's rows that have a row below them, on all threads.
template <typename Visit>
void forRows(const RayGrid& rays, const Progress& progress, const Visit& visit) {
  parallelChunks(static_cast<std::size_t>(rays.rows()) - 1, kRows, progress, [&](std::size_t begin, std::size_t end) {
    visit(Rows{static_cast<int>(begin), static_cast<int>(end)}, begin / kRows);
  });
}

template <typename Value>
std::vector<Value> joined(std::vector<std::vector<Value>>& parts) {
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  std::vector<Value> all;
  all.reserve(count);
  for (auto& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    std::vector<Value>().swap(part);
  }
  return all;
}

// Whether going along a row and then down a column turns clockwise seen from the scanner, where its samples are.
bool gridIsMirrored(const RangeImage& image, const Progress& progress) {
  const RayGrid& rays = *image.rays;
  std::vector<double> turns(rowChunks(rays), 0.0);
  forRows(rays, progress, [&](const Rows& rows, std::size_t chunk) {
    for (int r = rows.begin; r < rows.end; ++r) {
      for (int c = 0; c + 1 < rays.columns(); ++c) {
        const std::size_t i = rays.index(r, c);
        if (!image.valid(i)) continue;
        const auto depth = static_cast<double>(image.range[i]);
        auto motionTo = [&](std::size_t j) {
          const RangingRay& from = rays.ray(i);
          const RangingRay& to = rays.ray(j);
          return Vec3((to.origin - from.origin) + depth * (to.direction - from.direction));
        };
        turns[chunk] += motionTo(rays.index(r, c + 1)).cross(motionTo(rays.index(r + 1, c))).dot(rays.ray(i).direction);
      }
    }
  });
  return std::accumulate(turns.begin(), turns.end(), 0.0) > 0.0;
}

// Cuts every square of the grid along the shorter of its diagonals, or the only one that has both its samples.
std::vector<GridTriangle> gridTriangles(const RangeImage& image, const SurfaceTest& surface, const Progress& progress) {
  const RayGrid& rays = *image.rays;
  const bool mirrored = gridIsMirrored(image, progress.part(0.0, 0.2));
  std::vector<std::vector<GridTriangle>> parts(rowChunks(rays));
  forRows(rays, progress.part(0.2, 1.0), [&](const Rows& rows, std::size_t chunk) {
    auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const auto x = static_cast<std::uint32_t>(a);
      const auto y = static_cast<std::uint32_t>(b);
      const auto z = static_cast<std::uint32_t>(c);
      const GridTriangle t = mirrored ? GridTriangle{x, z, y} : GridTriangle{x, y, z};
      if (surface.isSurface(t)) parts[chunk].push_back(t);
    };
    for (int r = rows.begin; r < rows.end; ++r) {
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
  });
  return joined(parts);
}

// Median distance between neighbouring rays at their samples; 0 when no two neighbours belong together.
double medianSpacing(const RangeImage& image, const SurfaceTest& surface, const Progress& progress) {
  const RayGrid& rays = *image.rays;
  std::vector<std::vector<double>> parts(rowChunks(rays));
  forRows(rays, progress, [&](const Rows& rows, std::size_t chunk) {
    for (int r = rows.begin; r < rows.end; ++r) {
      for (int c = 0; c + 1 < rays.columns(); ++c) {
        const std::size_t i = rays.index(r, c);
        if (!image.valid(i)) continue;
        for (const std::size_t j : {rays.index(r, c + 1), rays.index(r + 1, c)})
          if (image.valid(j) && surface.continuous(i, j)) parts[chunk].push_back(raySpacing(image, i, j));
      }
    }
  });
  std::vector<double> lengths = joined(parts);
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

ViewMesh triangulate(const RangeImage& image, const TriangulationOptions& options, const Progress& progress) {
  validate(image);
  const SurfaceTest surface(image, options);
  const std::vector<GridTriangle> triangles = gridTriangles(image, surface, progress.part(0.0, 0.6));

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

  progress.checkpoint(0.7);
  view.normals = computeVertexNormals(view.mesh);
  view.confidence.resize(view.normals.size());
  for (std::size_t v = 0; v < view.normals.size(); ++v) {
    const double cosine = -view.normals[v].dot(image.rays->ray(view.sample[v]).direction);
    view.confidence[v] = static_cast<float>(std::clamp(cosine, kMinConfidence, 1.0));
  }
  progress.checkpoint(0.8);
  view.onBoundary = borderVertices(view.mesh);
  view.spacing = medianSpacing(image, surface, progress.part(0.9, 1.0));
  return view;
}

}  // namespace vantage
