#include "geometry/region.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr std::size_t kMostPoints = 1'000'000;
constexpr double kUnitTolerance = 1e-6;

[[noreturn]] void refuse(const std::string& why) {
  throw InvalidInput("region: " + why);
}

void checkPose(const Pose& pose) {
  const Eigen::Matrix3d r = pose.linear();
  if (!pose.matrix().allFinite() || !(r * r.transpose()).isIdentity(kUnitTolerance) || r.determinant() < 0.0)
    refuse("its pose is not a rigid motion");
}

void check(const BelowPlane& region) {
  if (!region.point.allFinite() || !region.normal.allFinite() || std::abs(region.normal.norm() - 1.0) > kUnitTolerance)
    refuse("the plane has no point or no unit normal");
}

void check(const OrientedBox& region) {
  checkPose(region.T_region_box);
  if (!region.size.allFinite() || region.size.minCoeff() <= 0.0) refuse("the box has no size");
}

void check(const Prism& region) {
  checkPose(region.T_region_eye);
  if (region.corners.size() < 3 || region.corners.size() > kMostPoints)
    refuse("the lasso has " + std::to_string(region.corners.size()) + " corners, expected 3 to " +
           std::to_string(kMostPoints));
  if (std::any_of(region.corners.begin(), region.corners.end(), [](const Vec2& c) { return !c.allFinite(); }))
    refuse("a corner of the lasso is not finite");
  if (!std::isfinite(region.nearest) || !(region.farthest > region.nearest) ||
      (region.perspective && region.nearest < 0.0))
    refuse("the lasso ends before it begins");
}

void check(const NearPoints& region) {
  if (region.points.empty() || region.points.size() > kMostPoints)
    refuse(std::to_string(region.points.size()) + " points, expected 1 to " + std::to_string(kMostPoints));
  if (std::any_of(region.points.begin(), region.points.end(), [](const Vec3& p) { return !p.allFinite(); }))
    refuse("a point is not finite");
  if (!std::isfinite(region.radius) || region.radius <= 0.0) refuse("the points have no radius");
}

std::string_view kindOfOne(const BelowPlane& /*region*/) {
  return "below";
}
std::string_view kindOfOne(const OrientedBox& /*region*/) {
  return "box";
}
std::string_view kindOfOne(const Prism& /*region*/) {
  return "lasso";
}
std::string_view kindOfOne(const NearPoints& /*region*/) {
  return "near";
}

Region movedOne(BelowPlane region, const Pose& T) {
  region.point = T * region.point;
  region.normal = T.linear() * region.normal;
  return region;
}

Region movedOne(OrientedBox region, const Pose& T) {
  region.T_region_box = T * region.T_region_box;
  return region;
}

Region movedOne(Prism region, const Pose& T) {
  region.T_region_eye = T * region.T_region_eye;
  return region;
}

Region movedOne(NearPoints region, const Pose& T) {
  for (Vec3& p : region.points) p = T * p;
  return region;
}

}  // namespace

std::string_view kindOf(const Region& region) {
  return std::visit([](const auto& r) { return kindOfOne(r); }, region);
}

void validate(const Region& region) {
  std::visit([](const auto& r) { check(r); }, region);
}

Region moved(const Region& region, const Pose& T_target_region) {
  if (T_target_region.matrix() == Pose::Identity().matrix()) return region;
  return std::visit([&](const auto& r) { return movedOne(r, T_target_region); }, region);
}

}  // namespace vantage
