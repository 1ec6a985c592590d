#include "support/sample_objects/distance_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vantage::testing {

double join(double a, double b, double blend) {
  if (blend <= 0.0) return std::min(a, b);
  const double h = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - 0.25 * h * h / blend;
}

double cut(double a, double b, double blend) {
  return -join(-a, b, blend);
}

double sphere(const Vec3& p, const Vec3& centre, double radius) {
  return (p - centre).norm() - radius;
}

double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
  const Vec3 q = (p - centre).cwiseQuotient(radii);
  const double gradient = q.cwiseQuotient(radii).norm();
  const double length = q.norm();
  return gradient > 0.0 ? length * (length - 1.0) / gradient : -radii.minCoeff();
}

double bar(const Vec3& p, const Vec3& a, const Vec3& b, double radiusA, double radiusB) {
  const Vec3 along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm() - ((1.0 - t) * radiusA + t * radiusB);
}

double tube(const Vec3& p, std::span<const Vec3> path, double firstRadius, double lastRadius) {
  const double pieces = static_cast<double>(path.size() - 1);
  auto radius = [&](std::size_t i) {
    return firstRadius + (lastRadius - firstRadius) * static_cast<double>(i) / pieces;
  };
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    distance = std::min(distance, bar(p, path[i], path[i + 1], radius(i), radius(i + 1)));
  return distance;
}

double plate(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double thickness) {
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const bool above = (b - a).cross(normal).dot(p - a) <= 0.0 && (c - b).cross(normal).dot(p - b) <= 0.0 &&
                     (a - c).cross(normal).dot(p - c) <= 0.0;
  const double distance = above ? std::abs(normal.dot(p - a))
                                : std::min({bar(p, a, b, 0.0, 0.0), bar(p, b, c, 0.0, 0.0), bar(p, c, a, 0.0, 0.0)});
  return distance - 0.5 * thickness;
}

double post(const Vec3& p, const Vec3& foot, double radius, double height, double rounding) {
  const double outside = (p - foot).head<2>().norm() - (radius - rounding);
  const double above = std::abs(p.z() - foot.z() - 0.5 * height) - (0.5 * height - rounding);
  return std::hypot(std::max(outside, 0.0), std::max(above, 0.0)) + std::min(std::max(outside, above), 0.0) - rounding;
}

double ring(const Vec3& p, const Vec3& centre, const Vec3& axis, double radius, double thickness) {
  const double height = (p - centre).dot(axis);
  const double away = (p - centre - height * axis).norm();
  return std::hypot(away - radius, height) - 0.5 * thickness;
}

double segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm();
}

}  // namespace vantage::testing
