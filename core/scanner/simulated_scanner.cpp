#include "scanner/simulated_scanner.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "base/random.h"

namespace vantage {
namespace {

// Streams of random numbers: one for the mechanics, one for every ray of every scan.
constexpr std::uint64_t kMechanicsStream = 0x6d65636861ULL << 24;
std::uint64_t rayStream(int ordinal, std::size_t ray) {
  return (static_cast<std::uint64_t>(ordinal) + 1) << 40 | ray;
}

// Lines of sight begin this far in front of the surface [mm], clear of the triangle they leave.
constexpr double kSurfaceOffset = 1e-2;

bool receiverSees(const RayCaster& object, const Vec3& point, const Vec3& normal, std::span<const Vec3> receivers,
                  const Pose& T_object_scanner) {
  if (receivers.empty()) return true;
  const Vec3 start = point + kSurfaceOffset * normal;
  for (const Vec3& r : receivers) {
    const Vec3 receiver = T_object_scanner * r;
    if ((receiver - point).dot(normal) > 0.0 && !object.occluded(start, receiver)) return true;
  }
  return false;
}

}  // namespace

SimulatedScanner::SimulatedScanner(const Mesh& object, std::shared_ptr<const ScannerProfile> profile,
                                   const SimulationOptions& options, int scansBefore)
    : profile_(std::move(profile)),
      options_(options),
      ordinal_(scansBefore),
      object_(object, RayCaster::Precision::Robust) {}

Pose SimulatedScanner::mechanicalError(int ordinal) const {
  Pose error = Pose::Identity();
  if (options_.ideal) return error;
  for (int move = 1; move <= ordinal; ++move) {
    Random random(options_.seed, kMechanicsStream + static_cast<std::uint64_t>(move));
    Pose step = Pose::Identity();
    step.translate(Vec3(profile_->mechanics.positionSigma * random.normal(),
                        profile_->mechanics.positionSigma * random.normal(), 0.0));
    step.rotate(Eigen::AngleAxisd(profile_->mechanics.angleSigma * random.normal(), Vec3::UnitZ()));
    error = error * step;
  }
  return error;
}

RangeImage SimulatedScanner::scan(int position, const Progress& progress) {
  if (position < 0 || position >= static_cast<int>(profile_->workspace.size()))
    throw DeviceError("simulated scanner: position " + std::to_string(position) + " is not one of the workspace's " +
                      std::to_string(profile_->workspace.size()));
  const RayGrid& rays = *profile_->rays;
  RangeImage image;
  image.rays = profile_->rays;
  image.position = position;
  image.T_object_scanner = profile_->workspace.poses[static_cast<std::size_t>(position)];
  image.range.assign(rays.size(), kNoSample);

  const Pose T_true = mechanicalError(ordinal_) * image.T_object_scanner;
  const double minCosine = std::cos(profile_->breakdownAngle);
  const double sigma = options_.ideal ? 0.0 : profile_->noise.rangeSigma;
  const double dropout = options_.ideal ? 0.0 : profile_->noise.dropout;
  parallelChunks(rays.size(), 1024, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 origin = T_true * rays.ray(i).origin;
      const Vec3 direction = T_true.linear() * rays.ray(i).direction;
      const auto hit = object_.intersect(origin, direction);
      if (!hit || hit->distance < profile_->minRange || hit->distance > profile_->maxRange) continue;
      // A sheet without thickness is scanned from either side.
      const Vec3 normal = hit->normal.dot(direction) > 0.0 ? Vec3(-hit->normal) : hit->normal;
      if (-normal.dot(direction) < minCosine) continue;
      if (!receiverSees(object_, origin + hit->distance * direction, normal, rays.receivers(i), T_true)) continue;
      Random random(options_.seed, rayStream(ordinal_, i));
      if (dropout > 0.0 && random.uniform() < dropout) continue;
      const double range = hit->distance + (sigma > 0.0 ? sigma * random.normal() : 0.0);
      if (range > 0.0) image.range[i] = static_cast<float>(range);
    }
  });
  ++ordinal_;
  return image;
}

}  // namespace vantage
