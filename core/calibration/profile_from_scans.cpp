#include "calibration/profile_from_scans.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "calibration/pinhole_fit.h"
#include "calibration/ray_field_fit.h"
#include "calibration/sample_motion.h"

namespace vantage {
namespace {

constexpr std::size_t kSamples = 6000;
constexpr double kStandoff = 100.0;  // [mm]
constexpr double kUsualEnd = radians(60.0);
constexpr double kRangeMargin = 0.1;

void require(std::span<const RangeImage> scans) {
  if (scans.empty()) throw InvalidInput("there is no scan, expected at least one to tell the scanner by");
  for (const RangeImage& scan : scans)
    if (scan.rays->rows() != scans.front().rays->rows() || scan.rays->columns() != scans.front().rays->columns())
      throw InvalidInput("the scans have different numbers of rows and columns, expected those of one scanner");
}

struct Rays {
  RayGrid grid;
  Pose T_profile_scan = Pose::Identity();
  std::optional<Pinhole> camera;
  double residual = 0.0;
};

std::vector<GridSample> moved(std::vector<GridSample> samples, const Pose& T) {
  for (GridSample& s : samples) s.point = T * s.point;
  return samples;
}

// The frame of a camera with its axis along z, put so that it looks along -x at what it sees; `down` is what y points.
Pose cameraBeforeTable(const std::vector<GridSample>& samples, double forward, double down) {
  std::vector<double> depths;
  for (const GridSample& s : samples) depths.push_back(forward * s.point.z());
  std::nth_element(depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2), depths.end());
  Pose pose = Pose::Identity();
  pose.linear() << 0.0, 0.0, -forward, 1.0, 0.0, 0.0, 0.0, -down, 0.0;
  pose.translation() = Vec3(depths[depths.size() / 2], 0.0, 0.0);
  return pose;
}

Rays raysOf(std::span<const RangeImage> scans, const ProfileFitOptions& options) {
  const std::vector<GridSample> samples = gridSamples(scans, kSamples);
  const RayGrid& first = *scans.front().rays;
  std::optional<Rays> best;
  std::vector<Pose> frames{Pose::Identity()};
  if (!samples.empty()) {
    frames.push_back(cameraBeforeTable(samples, 1.0, 1.0));    // y down, z forward
    frames.push_back(cameraBeforeTable(samples, -1.0, -1.0));  // y up, z back
  }
  for (const Pose& frame : frames) {
    const auto there = moved(samples, frame);
    const auto camera = fitPinhole(there, first.rows(), first.columns());
    if (!camera) continue;
    // A frame that is not that of the scans is known again by a camera at its origin only.
    const bool atOrigin = (camera->position - frame.translation()).norm() < 1.0;
    if (!frame.isApprox(Pose::Identity()) && !atOrigin) continue;
    RayGrid rays = makeRays(*camera, ReceiverOffsets{});
    const double residual = distanceFromRays(there, rays);
    if (residual <= options.mostOff && (!best || residual < best->residual))
      best = Rays{std::move(rays), frame, camera, residual};
  }
  if (best) return std::move(*best);
  const Vec3 sight = first.rayAt({0.5 * (first.rows() - 1), 0.5 * (first.columns() - 1)}).direction;
  RayGrid rays = fitRayField(samples, first.rows(), first.columns(), sight, kStandoff);
  const double residual = distanceFromRays(samples, rays);
  if (residual > 2.0 * options.mostOff)
    throw InvalidInput("the samples lie " + std::to_string(residual) +
                       " mm beside any rays that change smoothly over rows and columns, at most " +
                       std::to_string(2.0 * options.mostOff) +
                       " mm is allowed: see whether the files are range grids of one scanner that did not move");
  return {std::move(rays), Pose::Identity(), {}, residual};
}

// The scans as taken along the rays.
std::vector<RangeImage> onRays(std::span<const RangeImage> scans, const Rays& rays) {
  const auto grid = std::make_shared<const RayGrid>(rays.grid);
  std::vector<RangeImage> result;
  for (const RangeImage& scan : scans) {
    RangeImage image;
    image.rays = grid;
    image.range.assign(scan.range.size(), kNoSample);
    for (std::size_t i = 0; i < scan.range.size(); ++i) {
      if (!scan.valid(i)) continue;
      const double range = (rays.T_profile_scan * scan.point(i) - grid->ray(i).origin).dot(grid->ray(i).direction);
      if (range > 0.0) image.range[i] = static_cast<float>(range);
    }
    result.push_back(std::move(image));
  }
  return result;
}

double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// From two scans of the same, where there are such.
std::optional<double> noiseOfRepeats(const std::vector<RangeImage>& scans, double scatter) {
  std::optional<double> least;
  for (std::size_t k = 1; k < scans.size(); ++k) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < scans[k].range.size(); ++i)
      if (scans[k].valid(i) && scans[k - 1].valid(i))
        differences.push_back(
            std::abs(static_cast<double>(scans[k].range[i]) - static_cast<double>(scans[k - 1].range[i])));
    if (2 * differences.size() < scans[k].sampleCount() || differences.empty()) continue;
    const double sigma = 1.4826 * quantile(differences, 0.5) / std::sqrt(2.0);
    if (sigma <= 3.0 * scatter + 1e-3 && (!least || sigma < *least)) least = sigma;
  }
  return least;
}

std::string rayTable(const RayGrid& rays) {
  std::string text;
  char line[256];
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto& [o, d] = rays.ray(i);
    std::snprintf(line, sizeof line, "%.6f,%.6f,%.6f,%.9f,%.9f,%.9f", o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    text += line;
    for (const Vec3& r : rays.receivers(i)) {
      std::snprintf(line, sizeof line, ",%.6f,%.6f,%.6f", r.x(), r.y(), r.z());
      text += line;
    }
    text += '\n';
  }
  return text;
}

// The same rays with the receiver that stands beside their middle.
RayGrid withReceiver(const RayGrid& rays, const Vec3& offset) {
  Vec3 head = Vec3::Zero();
  std::vector<RangingRay> all;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    all.push_back(rays.ray(i));
    head += rays.ray(i).origin / static_cast<double>(rays.size());
  }
  const Vec3 forward = rays.rayAt({0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)}).direction;
  const Vec3 right = std::abs(forward.z()) < 0.99 ? Vec3(forward.cross(Vec3::UnitZ()).normalized()) : Vec3::UnitX();
  const Vec3 receiver = head + offset.x() * right + offset.y() * right.cross(forward) + offset.z() * forward;
  return {rays.rows(), rays.columns(), std::move(all), std::vector<Vec3>(rays.size(), receiver), 1};
}

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

nlohmann::ordered_json triple(const Vec3& v) {
  return {rounded(v.x(), 1e-4), rounded(v.y(), 1e-4), rounded(v.z(), 1e-4)};
}

nlohmann::ordered_json scannerJson(const Rays& rays, const ProfileFit& fit, const ProfileFitOptions& options) {
  nlohmann::ordered_json json{{"type", fit.type}};
  if (rays.camera) {
    json["position"] = triple(rays.camera->position);
    json["look_at"] = triple(rays.camera->lookAt);
    json["rows"] = rays.camera->rows;
    json["columns"] = rays.camera->columns;
    json["horizontal_fov_deg"] = rounded(degrees(rays.camera->horizontalFov), 1e-6);
    json["vertical_fov_deg"] = rounded(degrees(rays.camera->verticalFov), 1e-6);
    json["receivers"] = nlohmann::ordered_json::array();
    if (options.receiver) json["receivers"].push_back(triple(*options.receiver));
  } else {
    json["file"] = options.rayFile;
    json["rows"] = rays.grid.rows();
    json["columns"] = rays.grid.columns();
  }
  json["breakdown_angle_deg"] = degrees(fit.breakdownAngle);
  json["range_mm"] = {std::floor(fit.nearest * (1.0 - kRangeMargin)), std::ceil(fit.farthest * (1.0 + kRangeMargin))};
  json["noise"] = {{"range_sigma_mm", rounded(fit.noise, 1e-4)}, {"dropout", 0.0}};
  return json;
}

}  // namespace

ProfileFit profileFromScans(std::span<const RangeImage> scans, const ProfileFitOptions& options,
                            const Progress& progress) {
  require(scans);
  progress.checkpoint(0.0);
  const Rays rays = raysOf(scans, options);
  progress.checkpoint(0.4);
  const std::vector<RangeImage> images = onRays(scans, rays);
  ProfileFit fit;
  fit.type = rays.camera ? "pinhole" : "rays";
  fit.residual = rays.residual;
  std::vector<double> ranges;
  for (const RangeImage& image : images) {
    fit.noise = std::max(fit.noise, RangeNoiseCurve(image).median());
    for (std::size_t i = 0; i < image.range.size(); ++i)
      if (image.valid(i)) ranges.push_back(static_cast<double>(image.range[i]));
  }
  if (ranges.empty()) throw InvalidInput("the scans have no samples before the scanner");
  fit.nearest = quantile(ranges, 0.001);
  fit.farthest = quantile(ranges, 0.999);
  const auto repeated = noiseOfRepeats(images, fit.noise);
  fit.noiseFromRepeats = repeated.has_value();
  fit.noise = repeated.value_or(fit.noise);
  const std::vector<double> angles = incidenceAngles(images, progress.part(0.5, 1.0));
  fit.end = angles.empty() ? SampleEnd{kUsualEnd, 0.0, radians(90.0)} : sampleEnd(angles);
  fit.breakdownAngle = radians(std::clamp(std::round(degrees(fit.end.angle)), 30.0, 85.0));

  nlohmann::ordered_json json{{"name", options.name}, {"scanner", scannerJson(rays, fit, options)}};
  json["workspace"] = {{"type", "turntable"}, {"steps", options.steps}};
  json["viewing_volume"] = {{"radius_mm", 150}, {"height_mm", 300}};
  fit.source.path = "profile";
  fit.source.text = json.dump(2) + "\n";
  if (!rays.camera)
    fit.source.attachments[options.rayFile] =
        rayTable(options.receiver ? withReceiver(rays.grid, *options.receiver) : rays.grid);
  (void)parseProfile(fit.source);
  return fit;
}

}  // namespace vantage
