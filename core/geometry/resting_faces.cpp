#include "geometry/resting_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>

#include "geometry/convex_hull.h"
#include "geometry/measures.h"
#include "geometry/mesh_topology.h"

namespace vantage {
namespace {

// How far the foot may lie beyond an edge and still count as inside [size of the hull].
constexpr double kInside = 1e-9;

class RollingHull {
 public:
  explicit RollingHull(const ConvexHull& hull)
      : hull_(hull), topology_(hull.mesh), size_(boundingBox(hull.mesh).size().norm()) {}

  // The facet on which the body comes to rest.
  [[nodiscard]] std::uint32_t rollFrom(std::uint32_t facet) const {
    std::uint32_t lowest = facet;
    for (std::size_t step = 0; step < hull_.mesh.triangles.size(); ++step) {
      if (heightOn(facet) < heightOn(lowest)) lowest = facet;
      const std::uint32_t next = nextOf(facet);
      if (next == kNoIndex) return facet;
      facet = next;
    }
    return lowest;  // round and round on a facet that was cut into slivers
  }

  [[nodiscard]] double heightOn(std::uint32_t facet) const {
    return hull_.normals[facet].dot(corner(facet, 0) - hull_.centroid);
  }

  // Solid angle under which the centroid sees a facet, as a share of the sphere.
  [[nodiscard]] double shareOf(std::uint32_t facet) const {
    const Vec3 a = (corner(facet, 0) - hull_.centroid).normalized();
    const Vec3 b = (corner(facet, 1) - hull_.centroid).normalized();
    const Vec3 c = (corner(facet, 2) - hull_.centroid).normalized();
    const double angle = 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    return std::max(0.0, angle) / (4.0 * kPi);
  }

  // Least tilt over an edge of all that touches the facet's plane; negative where the foot lies beyond.
  [[nodiscard]] double marginOn(std::uint32_t facet, double contact) const {
    const Vec3& normal = hull_.normals[facet];
    const Vec3 u = normal.unitOrthogonal();
    const Vec3 v = normal.cross(u);
    std::vector<Vec2> touching;
    const double plane = normal.dot(corner(facet, 0));
    for (const Vec3& p : hull_.mesh.vertices)
      if (normal.dot(p) > plane - contact * size_)
        touching.emplace_back(u.dot(p - hull_.centroid), v.dot(p - hull_.centroid));
    return std::atan2(roomAround(std::move(touching)), heightOn(facet));
  }

 private:
  [[nodiscard]] const Vec3& corner(std::uint32_t facet, int k) const {
    return hull_.mesh.vertices[hull_.mesh.triangles[facet][static_cast<std::size_t>(k)]];
  }

  // The facet beyond the edge that the foot of the centroid lies farthest outside of; kNoIndex where it is inside.
  [[nodiscard]] std::uint32_t nextOf(std::uint32_t facet) const {
    double farthest = kInside * size_;
    std::uint32_t next = kNoIndex;
    for (int k = 0; k < 3; ++k) {
      const Vec3& a = corner(facet, k);
      const Vec3 edge = corner(facet, (k + 1) % 3) - a;
      const double beyond = edge.cross(hull_.normals[facet]).normalized().dot(hull_.centroid - a);
      const std::uint32_t neighbour = topology_.neighbour(facet, k);
      if (beyond <= farthest || neighbour == kNoIndex) continue;
      farthest = beyond;
      next = neighbour;
    }
    return next;
  }

  // Distance of the origin from the nearest edge of the points' convex hull, negative outside.
  static double roomAround(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Vec2> hull;
    for (int side = 0; side < 2; ++side) {
      const std::size_t first = hull.size();
      for (const Vec2& p : points) {
        while (hull.size() >= first + 2) {
          const Vec2 a = hull.back() - hull[hull.size() - 2];
          const Vec2 b = p - hull.back();
          if (a.x() * b.y() - a.y() * b.x() > 0.0) break;
          hull.pop_back();
        }
        hull.push_back(p);
      }
      hull.pop_back();
      std::reverse(points.begin(), points.end());
    }
    double room = hull.size() < 3 ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size() && hull.size() >= 3; ++i) {
      const Vec2 edge = hull[(i + 1) % hull.size()] - hull[i];
      if (edge.norm() > 0.0) room = std::min(room, (edge.x() * -hull[i].y() + edge.y() * hull[i].x()) / edge.norm());
    }
    return room;
  }

  const ConvexHull& hull_;
  MeshTopology topology_;
  double size_;
};

}  // namespace

std::vector<RestingFace> restingFaces(std::span<const Vec3> points, const RestingFaceOptions& options) {
  const ConvexHull hull = convexHull(points);
  const RollingHull rolling(hull);
  const auto facets = static_cast<std::uint32_t>(hull.mesh.triangles.size());
  std::vector<double> shares(facets, 0.0);
  for (std::uint32_t f = 0; f < facets; ++f) shares[rolling.rollFrom(f)] += rolling.shareOf(f);
  std::vector<std::uint32_t> order(facets);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return shares[a] > shares[b]; });

  std::vector<RestingFace> faces;
  for (const std::uint32_t f : order) {
    if (shares[f] <= 0.0) break;
    const Vec3& normal = hull.normals[f];
    const auto same = std::find_if(faces.begin(), faces.end(), [&](const RestingFace& face) {
      return face.normal.dot(normal) > std::cos(options.mergeAngle);
    });
    if (same != faces.end()) {
      same->share += shares[f];
      continue;
    }
    const double height = rolling.heightOn(f);
    faces.push_back({normal, hull.centroid + height * normal, height, rolling.marginOn(f, options.contact), shares[f]});
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const RestingFace& a, const RestingFace& b) { return a.share > b.share; });
  const auto firm = [&](const RestingFace& face) { return face.margin >= options.leastMargin; };
  if (std::any_of(faces.begin(), faces.end(), firm)) std::erase_if(faces, std::not_fn(firm));
  if (faces.size() > options.atMost) faces.resize(options.atMost);
  return faces;
}

Pose restingPose(const RestingFace& face) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(face.normal, -Vec3::UnitZ()).toRotationMatrix();
  pose.translation() = -(pose.linear() * face.foot);
  return pose;
}

}  // namespace vantage
