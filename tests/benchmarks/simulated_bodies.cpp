#include "simulated_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vantage {
namespace {

double boxDistance(const Vec3& p, const Vec3& half) {
  const Vec3 q = p.cwiseAbs() - half;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

Body box(const Vec3& centre, const Vec3& half) {
  return [=](const Vec3& p) { return boxDistance(p - centre, half); };
}

Body capsule(const Vec3& a, const Vec3& b, double radius) {
  return [=](const Vec3& p) {
    const Vec3 u = b - a;
    const double t = std::clamp((p - a).dot(u) / std::max(u.squaredNorm(), 1e-12), 0.0, 1.0);
    return (p - a - t * u).norm() - radius;
  };
}

Body cylinder(double radius, double low, double high) {
  return [=](const Vec3& p) {
    const double r = p.head<2>().norm() - radius;
    const double h = std::abs(p.z() - 0.5 * (low + high)) - 0.5 * (high - low);
    return std::hypot(std::max(r, 0.0), std::max(h, 0.0)) + std::min(std::max(r, h), 0.0);
  };
}

Body together(std::vector<Body> parts) {
  return [parts = std::move(parts)](const Vec3& p) {
    double least = 1e30;
    for (const Body& part : parts) least = std::min(least, part(p));
    return least;
  };
}

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

Vec3 somewhere(Random& random, double radius, double low, double high) {
  const double angle = 2.0 * kPi * random.uniform();
  const double r = radius * std::sqrt(random.uniform());
  return {r * std::cos(angle), r * std::sin(angle), between(random, low, high)};
}

// Bodies of about 100 mm, standing on z = 0 about the axis.
Body uniqueBody(Random& random) {
  std::vector<Body> parts{
      capsule(Vec3(0, 0, 12), Vec3(between(random, -6, 6), between(random, -6, 6), 75), between(random, 12, 20))};
  const auto limbs = 3 + random.below(4);
  for (std::uint64_t i = 0; i < limbs; ++i) {
    const Vec3 from = somewhere(random, 10, 15, 80);
    const Vec3 to = somewhere(random, 42, 10, 95);
    if (random.uniform() < 0.3)
      parts.push_back(
          box(0.5 * (from + to), Vec3(between(random, 5, 14), between(random, 5, 14), between(random, 5, 14))));
    else
      parts.push_back(capsule(from, to, between(random, 5, 11)));
  }
  return together(std::move(parts));
}

Body symmetricBody(Random& random) {
  if (random.uniform() < 0.5)
    return together(
        {cylinder(between(random, 22, 35), 0, 60), cylinder(between(random, 10, 18), 60, between(random, 80, 105))});
  return together({box(Vec3(0, 0, 40), Vec3(between(random, 15, 30), between(random, 15, 30), 40)),
                   cylinder(between(random, 8, 14), 80, 98)});
}

Body plate(Random& random) {
  return box(Vec3(0, 0, 45), Vec3(between(random, 2, 6), between(random, 35, 50), 45));
}

Body partOnTable(Random& random) {
  const double h = between(random, 10, 22);
  return together({box(Vec3(0, 0, -3), Vec3(50, 50, 3)), capsule(Vec3(0, 0, 0), Vec3(3, 2, h), between(random, 5, 8)),
                   box(Vec3(between(random, 6, 10), 0, 4), Vec3(between(random, 5, 8), between(random, 3, 5), 4))});
}

// Along a ray in object coordinates; nothing beyond `most` or where the surface is steeper than 72 degrees.
std::optional<double> traced(const Body& body, const Vec3& origin, const Vec3& direction, double most, double step) {
  double along = 0.0;
  for (int i = 0; i < 200 && along < most; ++i) {
    const Vec3 p = origin + along * direction;
    const double distance = body(p);
    if (distance < 1e-3 * step) {
      const double h = 1e-2 * step;
      const Vec3 gradient(body(p + Vec3(h, 0, 0)) - body(p - Vec3(h, 0, 0)),
                          body(p + Vec3(0, h, 0)) - body(p - Vec3(0, h, 0)),
                          body(p + Vec3(0, 0, h)) - body(p - Vec3(0, 0, h)));
      if (-gradient.normalized().dot(direction) < std::cos(radians(72.0))) return std::nullopt;
      return along;
    }
    along += distance;
  }
  return std::nullopt;
}

}  // namespace

const char* name(BodyKind kind) {
  constexpr std::array<const char*, kBodyKinds> kNames{"unique", "symmetric", "plate", "part on table"};
  return kNames.at(static_cast<std::size_t>(kind));
}

Body bodyOf(BodyKind kind, Random& random) {
  switch (kind) {
    case BodyKind::Symmetric:
      return symmetricBody(random);
    case BodyKind::Plate:
      return plate(random);
    case BodyKind::PartOnTable:
      return partOnTable(random);
    case BodyKind::Unique:
      break;
  }
  return uniqueBody(random);
}

Body scaledBy(const Body& body, double factor) {
  return [body, factor](const Vec3& p) { return factor * body(p / factor); };
}

RangeImage scanned(const Body& body, const Pose& T_object_scanner, const std::shared_ptr<const RayGrid>& rays,
                   double reach, double pitch, double noise, std::uint64_t seed) {
  RangeImage image;
  image.rays = rays;
  image.range.assign(rays->size(), kNoSample);
  for (std::size_t i = 0; i < rays->size(); ++i) {
    const RangingRay& ray = rays->ray(i);
    const auto along =
        traced(body, T_object_scanner * ray.origin, T_object_scanner.linear() * ray.direction, reach, pitch);
    if (along) image.range[i] = static_cast<float>(*along + noise * Random(seed, i).normal());
  }
  return image;
}

}  // namespace vantage
