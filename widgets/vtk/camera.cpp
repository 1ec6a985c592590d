#include "vtk/camera.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// Room left around what is looked at.
constexpr double kMargin = 1.12;

}  // namespace

double parallelStart(const Camera& camera) {
  constexpr double kLeast = 5000.0;
  return std::max(kLeast, 10.0 * camera.distance());
}

SightLine sightLine(const Camera& camera, const QPointF& point, const QSizeF& size) {
  const double half = std::tan(0.5 * camera.viewAngle);
  const double x = (2.0 * point.x() - size.width()) / size.height() * half;
  const double y = (1.0 - 2.0 * point.y() / size.height()) * half;
  const Vec3 forward = camera.forward();
  const Vec3 right = camera.right();
  if (camera.parallel) {
    const Vec3 middle = camera.target - parallelStart(camera) * forward;
    return {middle + camera.distance() * (x * right + y * right.cross(forward)), forward};
  }
  return {camera.eye, (forward + x * right + y * right.cross(forward)).normalized()};
}

std::optional<double> distanceTo(const std::array<Vec3, 4>& quad, const SightLine& line) {
  const Vec3 normal = (quad[2] - quad[0]).cross(quad[3] - quad[1]);
  const double slope = normal.dot(line.direction);
  if (slope == 0.0) return std::nullopt;
  const double distance = normal.dot(quad[0] - line.origin) / slope;
  if (distance < 0.0) return std::nullopt;
  const Vec3 point = line.origin + distance * line.direction;
  for (std::size_t k = 0; k < 4; ++k)
    if (normal.dot((quad[(k + 1) % 4] - quad[k]).cross(point - quad[k])) < 0.0) return std::nullopt;
  return distance;
}

Camera cameraToward(const Vec3& forward, const BoundingBox& box, double aspect) {
  Camera camera;
  const Vec3 f = forward.normalized();
  camera.up = std::abs(f.z()) > 0.999 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
  camera.target = box.centre();
  const Vec3 right = f.cross(camera.up).normalized();
  const Vec3 up = right.cross(f);
  const double half = std::tan(0.5 * camera.viewAngle);
  // Far enough back that every corner of the box is inside of the picture.
  double distance = 1.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1) ? 1.0 : -1.0, (corner & 2) ? 1.0 : -1.0, (corner & 4) ? 1.0 : -1.0);
    const Vec3 offset = 0.5 * box.size().cwiseProduct(sign);
    const double across = std::max(std::abs(offset.dot(right)) / aspect, std::abs(offset.dot(up)));
    distance = std::max(distance, kMargin * across / half - offset.dot(f));
  }
  camera.eye = camera.target - distance * f;
  camera.up = up;
  return camera;
}

}  // namespace vantage
