#include "registration/known_surface.h"

#include <algorithm>

#include "geometry/mesh_union.h"

namespace vantage {
KnownSurface::KnownSurface(std::span<const Mesh* const> meshes, double margin, const Progress& progress)
    : caster_(together(meshes), RayCaster::Precision::Fast, progress), margin_(margin) {}

bool KnownSurface::hides(const Vec3& p, const RayGrid& rays, std::size_t ray, const Pose& T_surface_scanner) const {
  const Vec3 point = T_surface_scanner * p;
  const auto blocked = [&](const Vec3& optics) {
    const Vec3 there = T_surface_scanner * optics;
    const double distance = (there - point).norm();
    return distance > margin_ && caster_.occluded(point + margin_ / distance * (there - point), there);
  };
  if (blocked(rays.ray(ray).origin)) return true;
  const auto receivers = rays.receivers(ray);
  return rays.triangulates() && std::all_of(receivers.begin(), receivers.end(), blocked);
}

}  // namespace vantage
