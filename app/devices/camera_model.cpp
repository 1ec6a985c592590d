#include "devices/camera_model.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/errors.h"

namespace vantage {
namespace {

// Rays leave from one point when they do so to within this [mm].
constexpr double kOnePoint = 0.01;

// The field of view of an image without its first row or column.
double withoutFirst(double fov, int pixels) {
  return 2.0 * std::atan(std::tan(0.5 * fov) * (pixels - 1) / pixels);
}

std::string profileText(const RayGrid& rays) {
  const int middle = rays.rows() / 2;
  const int centre = rays.columns() / 2;
  const auto angle = [&](std::size_t a, std::size_t b) {
    return std::acos(std::clamp(rays.ray(a).direction.dot(rays.ray(b).direction), -1.0, 1.0));
  };
  char text[96];
  std::snprintf(text, sizeof text, "%d x %d rays over %.1f x %.1f degrees", rays.columns(), rays.rows(),
                degrees(angle(rays.index(middle, 0), rays.index(middle, rays.columns() - 1))),
                degrees(angle(rays.index(0, centre), rays.index(rays.rows() - 1, centre))));
  return text;
}

[[noreturn]] void refuse(const CameraModel& camera, const ScannerProfile& profile, const std::string& why) {
  throw InvalidInput("the camera measures " + describe(camera) + ", the profile " + profile.name + " has " +
                     profileText(*profile.rays) + why + ": choose the profile of this camera, or make one from it");
}

// The rotation that brings directions of the camera to those of the rays best.
Eigen::Matrix3d bestTurn(const std::vector<Vec3>& from, const RayGrid& rays) {
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) correlation += rays.ray(i).direction * from[i].normalized().transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 sign = Vec3::Ones();
  sign.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

Vec3 pixelDirection(const CameraModel& camera, int x, int y) {
  return {2.0 * std::tan(0.5 * camera.horizontalFov) * (static_cast<double>(x) / camera.columns - 0.5),
          2.0 * std::tan(0.5 * camera.verticalFov) * (0.5 - static_cast<double>(y) / camera.rows), 1.0};
}

std::string describe(const CameraModel& camera) {
  char text[96];
  std::snprintf(text, sizeof text, "%d x %d pixels over %.1f x %.1f degrees", camera.columns, camera.rows,
                degrees(camera.horizontalFov), degrees(camera.verticalFov));
  return text;
}

bool sizeFits(int columns, int rows, const RayGrid& rays) {
  return (columns == rays.columns() && rows == rays.rows()) ||
         (columns == rays.columns() + 1 && rows == rays.rows() + 1);
}

PixelsOfRays pixelsOfRays(const CameraModel& camera, const ScannerProfile& profile) {
  const RayGrid& rays = *profile.rays;
  if (!sizeFits(camera.columns, camera.rows, rays)) refuse(camera, profile, "");
  for (std::size_t i = 0; i < rays.size(); ++i)
    if ((rays.ray(i).origin - rays.ray(0).origin).norm() > kOnePoint)
      refuse(camera, profile, ", which do not leave from one point");
  const int left = camera.columns - rays.columns();
  PixelsOfRays found;
  std::vector<Vec3> directions;
  for (int r = 0; r < rays.rows(); ++r) {
    for (int c = 0; c < rays.columns(); ++c) {
      found.pixel.push_back(static_cast<std::size_t>(r + left) * static_cast<std::size_t>(camera.columns) +
                            static_cast<std::size_t>(c + left));
      // Right, down and forward: a proper frame.
      const Vec3 d = pixelDirection(camera, c + left, r + left);
      directions.emplace_back(d.x(), -d.y(), 1.0);
      found.stretch.push_back(d.norm());
    }
  }
  const Eigen::Matrix3d turn = bestTurn(directions, rays);
  const double pixel = 2.0 * std::tan(0.5 * camera.horizontalFov) / camera.columns;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec3 there = turn.transpose() * rays.ray(i).direction;
    const double off = there.z() > 0.0 ? (there / there.z() - directions[i]).norm() / pixel : 1e9;
    found.worst = std::max(found.worst, off);
  }
  if (found.worst > kMostPixelError) {
    char text[64];
    std::snprintf(text, sizeof text, " that look up to %.1f pixels beside them", std::min(found.worst, 99999.0));
    refuse(camera, profile, text);
  }
  return found;
}

ProfileSource profileOf(const CameraModel& camera, const std::string& name, const CameraPlace& place) {
  if (!(camera.horizontalFov > 0.0 && camera.verticalFov > 0.0) || camera.columns < 3 || camera.rows < 3)
    throw InvalidInput("the camera " + name + " measures " + describe(camera) +
                       ", expected at least 3 x 3 pixels and a field of view");
  const auto point = [](const Vec3& p) { return nlohmann::ordered_json{p.x(), p.y(), p.z()}; };
  nlohmann::ordered_json receivers = nlohmann::ordered_json::array();
  if (place.projector) receivers.push_back(point(*place.projector));
  nlohmann::ordered_json json;
  json["name"] = name;
  json["scanner"] = {{"type", "pinhole"},
                     {"position", point(place.position)},
                     {"look_at", point(place.lookAt)},
                     {"rows", camera.rows - 1},
                     {"columns", camera.columns - 1},
                     {"horizontal_fov_deg", degrees(withoutFirst(camera.horizontalFov, camera.columns))},
                     {"vertical_fov_deg", degrees(withoutFirst(camera.verticalFov, camera.rows))},
                     {"receivers", receivers},
                     {"breakdown_angle_deg", 70},
                     {"range_mm", {200, 2000}}};
  json["workspace"] = {{"type", "turntable"}, {"steps", place.steps}};
  json["viewing_volume"] = {{"radius_mm", 150}, {"height_mm", 300}};
  json["positional_space"] = {{"surface", "cylinder"}, {"rows", 20}, {"columns", 72}};
  json["mechanics"] = {{"angle_sigma_deg", 0.5}, {"position_sigma_mm", 0.5}};
  return {"depth_camera.json", json.dump(2) + "\n", {}};
}

}  // namespace vantage
