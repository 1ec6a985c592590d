#include "vtk/camera.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

// Room left around what is looked at.
constexpr double kMargin = 1.12;

}  // namespace

SightLine sightLine(const Camera& camera, const QPointF& point, const QSizeF& size) {
  const double half = std::tan(0.5 * camera.viewAngle);
  const double x = (2.0 * point.x() - size.width()) / size.height() * half;
  const double y = (1.0 - 2.0 * point.y() / size.height()) * half;
  const Vec3 forward = camera.forward();
  const Vec3 right = camera.right();
  return {camera.eye, (forward + x * right + y * right.cross(forward)).normalized()};
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
