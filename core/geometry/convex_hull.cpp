#include "geometry/convex_hull.h"

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "base/errors.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace vantage {
namespace {

// Qhull's state, its memory, and where its remarks go.
class Qhull {
 public:
  Qhull() : nowhere_(std::fopen("/dev/null", "w"), &std::fclose) { qh_zero(&state_, nowhere_.get()); }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int leftLong = 0;
    int leftAll = 0;
    qh_memfreeshort(&state_, &leftLong, &leftAll);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  // Whether there is a hull. The coordinates are kept by reference.
  bool build(std::vector<double>& coordinates) {
    std::string flags = "qhull Qt Pp";
    const auto count = static_cast<int>(coordinates.size() / 3);
    return qh_new_qhull(&state_, 3, count, coordinates.data(), False, flags.data(), nullptr, nowhere_.get()) == 0;
  }

  qhT* state() { return &state_; }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere_;
  qhT state_{};
};

void measure(ConvexHull& hull) {
  const Vec3 inside = hull.mesh.vertices.front();
  Vec3 moment = Vec3::Zero();
  for (const Triangle& t : hull.mesh.triangles) {
    const Vec3 a = hull.mesh.vertices[t[0]] - inside;
    const Vec3 b = hull.mesh.vertices[t[1]] - inside;
    const Vec3 c = hull.mesh.vertices[t[2]] - inside;
    const double volume = a.dot(b.cross(c)) / 6.0;
    hull.volume += volume;
    moment += volume * (a + b + c) / 4.0;
  }
  hull.centroid = inside + moment / hull.volume;
}

}  // namespace

ConvexHull convexHull(std::span<const Vec3> points) {
  if (points.size() < 4)
    throw InvalidInput("a convex hull needs at least four points, there are " + std::to_string(points.size()));
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  Qhull qhull;
  if (!qhull.build(coordinates)) throw InvalidInput("the points lie in a plane, they have no convex hull");

  ConvexHull hull;
  std::vector<std::uint32_t> vertexOf(points.size(), kNoIndex);
  const qhT* qh = qhull.state();
  for (facetT* facet = qh->facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
    Triangle t{};
    for (int k = 0; k < 3; ++k) {
      const auto* vertex = static_cast<const vertexT*>(SETelem_(facet->vertices, k));
      const auto point = static_cast<std::uint32_t>(qh_pointid(qhull.state(), vertex->point));
      if (vertexOf[point] == kNoIndex) {
        vertexOf[point] = static_cast<std::uint32_t>(hull.point.size());
        hull.point.push_back(point);
        hull.mesh.vertices.push_back(points[point]);
      }
      t[static_cast<std::size_t>(k)] = vertexOf[point];
    }
    if ((facet->toporient != 0) != (qh_ORIENTclock != 0)) std::swap(t[1], t[2]);
    hull.mesh.triangles.push_back(t);
    hull.normals.emplace_back(facet->normal[0], facet->normal[1], facet->normal[2]);
  }
  measure(hull);
  return hull;
}

}  // namespace vantage
