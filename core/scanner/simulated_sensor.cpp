#include "scanner/simulated_sensor.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "base/random.h"

namespace vantage {
namespace {

// The stream of random numbers of a ray of a scan.
std::uint64_t rayStream(int ordinal, std::size_t ray) {
  return (static_cast<std::uint64_t>(ordinal) + 1) << 40 | ray;
}

// Lines of sight begin this far in front of the surface [mm], clear of the triangle they leave.
constexpr double kSurfaceOffset = 1e-2;

bool receiverSees(const RayCaster& object, const Vec3& point, const Vec3& normal, std::span<const Vec3> receivers,
                  const Pose& T_table_scanner) {
  if (receivers.empty()) return true;
  const Vec3 start = point + kSurfaceOffset * normal;
  for (const Vec3& r : receivers) {
    const Vec3 receiver = T_table_scanner * r;
    if ((receiver - point).dot(normal) > 0.0 && !object.occluded(start, receiver)) return true;
  }
  return false;
}

}  // namespace

SimulatedSensor::SimulatedSensor(std::shared_ptr<const Mesh> object, std::shared_ptr<const ScannerProfile> profile,
                                 const SimulationOptions& options, std::shared_ptr<SimulatedTable> table)
    : mesh_(std::move(object)), profile_(std::move(profile)), options_(options), table_(std::move(table)) {}

void SimulatedSensor::open(const Progress& progress) {
  if (object_) return;
  progress.checkpoint(0.0);
  object_.emplace(*mesh_, RayCaster::Precision::Robust);
}

std::optional<std::string> SimulatedSensor::notReady() const {
  if (!object_) return "it is not open";
  return {};
}

RangeImage SimulatedSensor::capture(const Progress& progress) {
  if (const auto reason = notReady()) throw DeviceError(identity() + ": " + *reason);
  if (!table_->truth()) throw DeviceError(identity() + ": the table has not been moved to a position yet");
  const RayGrid& rays = *profile_->rays;
  RangeImage image;
  image.rays = profile_->rays;
  image.range.assign(rays.size(), kNoSample);

  const Pose T_true = *table_->truth();
  const int ordinal = table_->scans();
  const double minCosine = std::cos(profile_->breakdownAngle);
  const double sigma = options_.ideal ? 0.0 : profile_->noise.rangeSigma;
  const double dropout = options_.ideal ? 0.0 : profile_->noise.dropout;
  parallelChunks(rays.size(), 1024, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 origin = T_true * rays.ray(i).origin;
      const Vec3 direction = T_true.linear() * rays.ray(i).direction;
      const auto hit = object_->intersect(origin, direction);
      if (!hit || hit->distance < profile_->minRange || hit->distance > profile_->maxRange) continue;
      // A sheet without thickness is scanned from either side.
      const Vec3 normal = hit->normal.dot(direction) > 0.0 ? Vec3(-hit->normal) : hit->normal;
      if (-normal.dot(direction) < minCosine) continue;
      if (!receiverSees(*object_, origin + hit->distance * direction, normal, rays.receivers(i), T_true)) continue;
      Random random(options_.seed, rayStream(ordinal, i));
      if (dropout > 0.0 && random.uniform() < dropout) continue;
      const double range = hit->distance + (sigma > 0.0 ? sigma * random.normal() : 0.0);
      if (range > 0.0) image.range[i] = static_cast<float>(range);
    }
  });
  table_->countScan();
  return image;
}

Rig simulatedRig(std::shared_ptr<const Mesh> object, const std::shared_ptr<const ScannerProfile>& profile,
                 const SimulationOptions& options, int scansBefore) {
  const auto table = std::make_shared<SimulatedTable>(profile, options, scansBefore);
  return {std::make_shared<SimulatedSensor>(std::move(object), profile, options, table), table};
}

}  // namespace vantage
