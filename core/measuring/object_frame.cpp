#include "measuring/object_frame.h"

#include <Eigen/Geometry>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr double kShortest = 1e-9;

Pose frameOf(const Vec3& origin, const Vec3& x, const Vec3& z) {
  Pose T_out_object = Pose::Identity();
  T_out_object.linear().row(0) = x;
  T_out_object.linear().row(1) = z.cross(x);
  T_out_object.linear().row(2) = z;
  T_out_object.translation() = -(T_out_object.linear() * origin);
  return T_out_object;
}

}  // namespace

Pose frameOnBase(const SurfacePlane& base, const Vec3& origin, const Vec3& along) {
  const Vec3 foot = origin - base.distance(origin) * base.normal;
  const Vec3 offset = along - origin;
  const Vec3 x = offset - offset.dot(base.normal) * base.normal;
  if (!(x.norm() > kShortest * offset.norm()) || !x.allFinite())
    throw InvalidInput("the two points are above each other, they do not tell the direction of x");
  return frameOf(foot, x.normalized(), base.normal);
}

Pose frameFromPicks(const std::array<Vec3, 3>& points) {
  const SurfacePlane plane = planeThrough(points);
  return frameOf(points[0], (points[1] - points[0]).normalized(), plane.normal);
}

Pose frameOnPlane(const SurfacePlane& base) {
  Pose T_out_object = Pose::Identity();
  T_out_object.linear() = Eigen::Quaterniond::FromTwoVectors(base.normal, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 foot = base.offset * base.normal;
  T_out_object.translation() = -(T_out_object.linear() * foot);
  T_out_object.translation().head<2>() += foot.head<2>();
  return T_out_object;
}

}  // namespace vantage
