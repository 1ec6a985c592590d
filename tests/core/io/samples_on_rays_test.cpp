#include "io/samples_on_rays.h"

#include "core/io/expect_error.h"
#include "support/written_scans.h"

namespace vantage {
namespace {

using testing::stripeProfile;

TEST(SamplesOnRays, TakesTheFrontMostOfARay) {
  const ScannerProfile profile = stripeProfile();
  const std::size_t i = profile.rays->index(10, 20);
  const RangingRay& ray = profile.rays->ray(i);
  const std::vector<Vec3> points{ray.origin + 320.0 * ray.direction, ray.origin + 290.0 * ray.direction,
                                 Vec3(500, 0, 0)};
  const std::vector<Colour> colours{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  const SamplesOnRays placed = samplesOnRays(points, colours, profile.rays);
  EXPECT_EQ(placed.hidden, 1U);
  EXPECT_EQ(placed.outside, 1U);
  EXPECT_EQ(placed.image.sampleCount(), 1U);
  EXPECT_NEAR(placed.image.range[i], 290.0, 1e-3);
  EXPECT_EQ(placed.image.colours[i], (Colour{2, 2, 2}));
}

// Points of an oblique plane anywhere between the rays: the rays meet the plane itself.
TEST(SamplesOnRays, MeetsTheSurfaceBetweenPoints) {
  const ScannerProfile profile = stripeProfile();
  const Vec3 normal = Vec3(1, 0.5, 0.3).normalized();
  const auto onPlane = [&](const RangingRay& ray) { return -normal.dot(ray.origin) / normal.dot(ray.direction); };
  std::vector<Vec3> points;
  for (double r = 0.3; r < 39.0; r += 0.93)
    for (double c = 0.2; c < 47.0; c += 0.91) {
      const RangingRay ray = profile.rays->rayAt({r, c});
      points.push_back(ray.origin + onPlane(ray) * ray.direction);
    }
  const SamplesOnRays placed = samplesOnRays(points, {}, profile.rays);
  EXPECT_TRUE(placed.image.colours.empty());
  double worst = 0.0;
  for (int r = 1; r < 38; ++r)
    for (int c = 1; c < 46; ++c) {
      const std::size_t i = profile.rays->index(r, c);
      if (!placed.image.valid(i)) continue;
      worst = std::max(worst, std::abs(static_cast<double>(placed.image.range[i]) - onPlane(profile.rays->ray(i))));
    }
  EXPECT_GT(placed.image.sampleCount(), 1500U);
  EXPECT_LT(worst, 0.05);
}

TEST(SamplesOnRays, StopsWhenItIsAskedTo) {
  const ScannerProfile profile = stripeProfile();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(samplesOnRays({Vec3::Zero()}, {}, profile.rays, Progress({}, stop.get_token(), 1))),
               Cancelled);
}

}  // namespace
}  // namespace vantage
