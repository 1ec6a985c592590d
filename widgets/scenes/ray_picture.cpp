#include "scenes/ray_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vantage {
namespace {

constexpr int kFiner = 2;  // rays across a pixel
// Where the light stands, in the camera's right, up and backward.
const Vec3 kLight = Vec3(-0.4, 0.6, 1.0).normalized();
constexpr double kAmbient = 0.3;
constexpr double kInside = 0.55;

QRgb shaded(const Rgb& colour, double brightness) {
  const auto part = [&](std::uint8_t c) { return std::clamp(static_cast<int>(c * brightness), 0, 255); };
  return qRgb(part(colour[0]), part(colour[1]), part(colour[2]));
}

// The light in coordinates of the scene.
Vec3 lightOf(const Camera& camera) {
  const Vec3 up = camera.right().cross(camera.forward());
  return kLight.x() * camera.right() + kLight.y() * up - kLight.z() * camera.forward();
}

std::optional<QRgb> colourAt(std::span<const PicturedSurface> surfaces, const SightLine& line, const Vec3& light) {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<QRgb> colour;
  for (const PicturedSurface& surface : surfaces) {
    const Pose T_surface_scene = surface.T_scene_surface.inverse();
    const auto hit =
        surface.caster->intersect(T_surface_scene * line.origin, T_surface_scene.linear() * line.direction);
    if (!hit || hit->distance >= nearest) continue;
    nearest = hit->distance;
    const Vec3 normal = surface.T_scene_surface.linear() * hit->normal;
    const bool front = normal.dot(line.direction) < 0.0;
    const double facing = std::max(0.0, (front ? 1.0 : -1.0) * normal.dot(light));
    colour = shaded(surface.colour(hit->triangle), (front ? 1.0 : kInside) * (kAmbient + (1.0 - kAmbient) * facing));
  }
  return colour;
}

}  // namespace

QImage rayPicture(std::span<const PicturedSurface> surfaces, const Camera& camera, const QSize& size,
                  const Theme& theme, const Progress& progress) {
  const QSize fine = kFiner * size;
  QImage image(fine, QImage::Format_RGB32);
  const Vec3 light = lightOf(camera);
  for (int y = 0; y < fine.height(); ++y) {
    progress.checkpoint(static_cast<double>(y) / fine.height());
    for (int x = 0; x < fine.width(); ++x)
      image.setPixel(x, y,
                     colourAt(surfaces, sightLine(camera, QPointF(x + 0.5, y + 0.5), fine), light)
                         .value_or(theme.backgroundTop.rgb()));
  }
  return image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace vantage
