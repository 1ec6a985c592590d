#include "scanner/sight.h"

#include <algorithm>
#include <cmath>

namespace vantage {

std::string_view name(Visibility visibility) {
  switch (visibility) {
    case Visibility::OutOfReach:
      return "out_of_reach";
    case Visibility::TooSteep:
      return "too_steep";
    case Visibility::LightBlocked:
      return "light_blocked";
    case Visibility::ReceiverBlocked:
      return "receiver_blocked";
    case Visibility::Seen:
      return "seen";
  }
  return "";
}

SightTest::SightTest(const ScannerProfile& profile, const RayCaster& obstacles, const SightOptions& options,
                     const RayCaster* assumed)
    : profile_(profile), obstacles_(obstacles), assumed_(assumed), options_(options) {}

bool SightTest::blocked(const Vec3& from, const Vec3& to) const {
  return obstacles_.occluded(from, to, options_.margin) ||
         (assumed_ != nullptr && assumed_->occluded(from, to, options_.margin));
}

Sight SightTest::look(const Pose& T_object_scanner, const Vec3& point, const Vec3& normal, double widestAngle) const {
  Sight sighting;
  const RayGrid& rays = *profile_.rays;
  const Vec3 inScanner = T_object_scanner.inverse() * point;
  const auto place = rays.locate(inScanner);
  if (!place) return sighting;
  const RangingRay ray = rays.rayAt(*place);
  const double range = (inScanner - ray.origin).dot(ray.direction);
  if (range < profile_.minRange || range > profile_.maxRange) return sighting;

  sighting.direction = -(T_object_scanner.linear() * ray.direction);
  sighting.cosine = sighting.direction.dot(normal);
  sighting.visibility = Visibility::TooSteep;
  if (sighting.cosine < std::cos(widestAngle)) return sighting;

  sighting.visibility = Visibility::LightBlocked;
  const Vec3 start = point + options_.offset * normal;
  if (blocked(start, T_object_scanner * ray.origin)) return sighting;

  sighting.visibility = Visibility::ReceiverBlocked;
  if (received(T_object_scanner, rays.nearest(*place), point, normal)) sighting.visibility = Visibility::Seen;
  return sighting;
}

bool SightTest::received(const Pose& T_object_scanner, std::size_t ray, const Vec3& point, const Vec3& normal) const {
  const RayGrid& rays = *profile_.rays;
  if (!rays.triangulates()) return true;
  const Vec3 start = point + options_.offset * normal;
  const auto receivers = rays.receivers(ray);
  return std::any_of(receivers.begin(), receivers.end(), [&](const Vec3& r) {
    const Vec3 receiver = T_object_scanner * r;
    return (receiver - point).dot(normal) > 0.0 && !blocked(start, receiver);
  });
}

}  // namespace vantage
