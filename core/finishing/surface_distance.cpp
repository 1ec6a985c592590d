#include "finishing/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/ray_caster.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 4096;

struct Sum {
  double greatest = 0.0;
  double squares = 0.0;  // times area
  double area = 0.0;
};

Sum oneWay(const Mesh& from, const RayCaster& to, const Progress& progress) {
  const auto distance = [&](const Vec3& p) {
    const auto nearest = to.closestPoint(p, std::numeric_limits<double>::infinity());
    return nearest ? nearest->distance : 0.0;
  };
  std::vector<double> atVertex(from.vertices.size(), 0.0);
  parallelChunks(atVertex.size(), kGrain, progress.part(0.0, 0.4), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) atVertex[v] = distance(from.vertices[v]);
  });
  const std::size_t triangles = from.triangles.size();
  std::vector<Sum> sums((triangles + kGrain - 1) / kGrain);
  parallelChunks(triangles, kGrain, progress.part(0.4, 1.0), [&](std::size_t begin, std::size_t end) {
    Sum& sum = sums[begin / kGrain];
    for (std::size_t t = begin; t < end; ++t) {
      const Triangle& corners = from.triangles[t];
      const double centre = distance(triangleCentre(from, corners));
      // The centre counts three quarters of the triangle, its corners a twelfth each.
      double squares = 0.75 * centre * centre;
      sum.greatest = std::max(sum.greatest, centre);
      for (const std::uint32_t v : corners) {
        squares += atVertex[v] * atVertex[v] / 12.0;
        sum.greatest = std::max(sum.greatest, atVertex[v]);
      }
      const double area = triangleArea(from, corners);
      sum.squares += area * squares;
      sum.area += area;
    }
  });
  Sum all;
  for (const Sum& sum : sums) {
    all.greatest = std::max(all.greatest, sum.greatest);
    all.squares += sum.squares;
    all.area += sum.area;
  }
  return all;
}

}  // namespace

SurfaceDistance distanceBetween(const Mesh& a, const Mesh& b, const Progress& progress) {
  if (a.triangles.empty() || b.triangles.empty())
    throw InvalidInput("distances between surfaces need two, one of them has no triangle");
  const Sum there =
      oneWay(a, RayCaster(b, RayCaster::Precision::Robust, progress.part(0.0, 0.1)), progress.part(0.1, 0.5));
  const Sum back =
      oneWay(b, RayCaster(a, RayCaster::Precision::Robust, progress.part(0.5, 0.6)), progress.part(0.6, 1.0));
  const double area = there.area + back.area;
  return {std::max(there.greatest, back.greatest), area > 0.0 ? std::sqrt((there.squares + back.squares) / area) : 0.0};
}

}  // namespace vantage
