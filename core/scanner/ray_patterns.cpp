#include "scanner/ray_patterns.h"

#include <cmath>

namespace vantage {
namespace {

// Collects the rays of a grid with the receivers of their heads.
class Rays {
 public:
  Rays(int rows, int columns, const ReceiverOffsets& offsets) : rows_(rows), columns_(columns), offsets_(offsets) {
    const auto count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    rays_.reserve(count);
    receivers_.reserve(count * offsets.size());
  }

  void add(const RangingRay& ray, const Vec3& head, const Vec3& right, const Vec3& up, const Vec3& forward) {
    rays_.push_back(ray);
    for (const Vec3& o : offsets_) receivers_.push_back(head + o[0] * right + o[1] * up + o[2] * forward);
  }

  RayGrid grid() && {
    return {rows_, columns_, std::move(rays_), std::move(receivers_), static_cast<int>(offsets_.size())};
  }

 private:
  int rows_;
  int columns_;
  const ReceiverOffsets& offsets_;
  std::vector<RangingRay> rays_;
  std::vector<Vec3> receivers_;
};

// i of count places evenly over [-extent/2, extent/2], ends included.
double spread(int i, int count, double extent) {
  return extent * (static_cast<double>(i) / (count - 1) - 0.5);
}

}  // namespace

RayGrid makeRays(const RotatingStripe& s, const ReceiverOffsets& receivers) {
  Rays rays(s.samplesPerStripe, s.stripes, receivers);
  const Vec3 up = Vec3::UnitZ();
  for (int i = 0; i < s.samplesPerStripe; ++i) {
    for (int j = 0; j < s.stripes; ++j) {
      const double a = spread(j, s.stripes, s.sweep);
      const Vec3 forward(-std::cos(a), std::sin(a), 0.0);
      const Vec3 origin = s.position + spread(i, s.samplesPerStripe, s.stripeHeight) * up;
      rays.add({origin, forward}, s.position, forward.cross(up), up, forward);
    }
  }
  return std::move(rays).grid();
}

RayGrid makeRays(const LinearStripe& s, const ReceiverOffsets& receivers) {
  Rays rays(s.samplesPerStripe, s.stripes, receivers);
  const Vec3 up = Vec3::UnitZ();
  const Vec3 forward = -Vec3::UnitX();
  for (int i = 0; i < s.samplesPerStripe; ++i) {
    for (int j = 0; j < s.stripes; ++j) {
      const Vec3 head = s.position + spread(j, s.stripes, s.travel) * Vec3::UnitY();
      rays.add({head + spread(i, s.samplesPerStripe, s.stripeHeight) * up, forward}, head, forward.cross(up), up,
               forward);
    }
  }
  return std::move(rays).grid();
}

RayGrid makeRays(const Pinhole& s, const ReceiverOffsets& receivers) {
  Rays rays(s.rows, s.columns, receivers);
  const Vec3 forward = (s.lookAt - s.position).normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 up = right.cross(forward);
  const double halfWidth = std::tan(0.5 * s.horizontalFov);
  const double halfHeight = std::tan(0.5 * s.verticalFov);
  for (int i = 0; i < s.rows; ++i) {
    for (int j = 0; j < s.columns; ++j) {
      const double x = halfWidth * (2.0 * (j + 0.5) / s.columns - 1.0);
      const double y = halfHeight * (1.0 - 2.0 * (i + 0.5) / s.rows);
      rays.add({s.position, (forward + x * right + y * up).normalized()}, s.position, right, up, forward);
    }
  }
  return std::move(rays).grid();
}

}  // namespace vantage
