#include "registration/view_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scanner/ray_patterns.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::makeBall;
using testing::makeProfile;
using testing::scanFrom;

// Parallel rays along -x on a 1 mm grid that meet the tilted plane x = 0.2 y everywhere.
View tiltedPlane() {
  auto image = std::make_shared<RangeImage>();
  image->rays =
      std::make_shared<RayGrid>(makeRays(LinearStripe{Vec3(100, 0, 0), 20.0, 21, 21, 20.0}, ReceiverOffsets{}));
  for (std::size_t i = 0; i < image->rays->size(); ++i)
    image->range.push_back(static_cast<float>(100.0 - 0.2 * image->rays->ray(i).origin.y()));
  View view;
  view.image = image;
  view.mesh = std::make_shared<ViewMesh>(triangulate(*image, TriangulationOptions()));
  return view;
}

TEST(ViewSurface, FindsThePointWhereTheRayMeetsTheSurface) {
  const View view = tiltedPlane();
  const ViewSurface surface(*view.mesh, *view.image->rays);
  std::optional<GridPosition> position;
  const auto sample = surface.sample(Vec3(7.0, 3.3, -2.6), position);
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->point.isApprox(Vec3(0.66, 3.3, -2.6), 1e-4));
  EXPECT_TRUE(sample->normal.isApprox(Vec3(1, -0.2, 0).normalized(), 1e-4));
  EXPECT_TRUE(sample->direction.isApprox(-Vec3::UnitX(), 1e-12));
  EXPECT_NEAR(sample->confidence, 1.0 / std::sqrt(1.04), 1e-4);
  EXPECT_TRUE(sample->inside);
}

TEST(ViewSurface, KnowsItsBorderAndItsEnd) {
  const View view = tiltedPlane();
  const ViewSurface surface(*view.mesh, *view.image->rays);
  std::optional<GridPosition> position;
  const auto rim = surface.sample(Vec3(5.0, 9.6, 0.0), position);
  ASSERT_TRUE(rim);
  EXPECT_FALSE(rim->inside);
  position.reset();
  EXPECT_FALSE(surface.sample(Vec3(5.0, 12.0, 0.0), position));
}

TEST(ViewSurface, HasNothingWhereSamplesAreMissing) {
  const View whole = tiltedPlane();
  RangeImage image = *whole.image;
  image.range[image.rays->index(10, 10)] = kNoSample;
  const ViewMesh mesh = triangulate(image, TriangulationOptions());
  const ViewSurface surface(mesh, *image.rays);
  std::optional<GridPosition> position;
  const Vec3 hole = image.rays->ray(image.rays->index(10, 10)).origin;
  EXPECT_FALSE(surface.sample(Vec3(1.0, hole.y() + 0.05, hole.z() - 0.05), position));
}

TEST(ViewSurface, PointsInsideLeaveOutTheBorder) {
  const View view = tiltedPlane();
  const ViewSurface surface(*view.mesh, *view.image->rays);
  EXPECT_EQ(surface.pointsInside().size(), 19U * 19U);
}

TEST(ViewSurface, OfManyPointsInsideSomeAreTaken) {
  const View view = tiltedPlane();
  const ViewSurface surface(*view.mesh, *view.image->rays);
  const OrientedVertices all = surface.pointsInside();
  const OrientedVertices some = surface.pointsInside(100);
  EXPECT_GT(some.size(), 60U);
  EXPECT_LT(some.size(), 140U);
  std::size_t k = 0;
  for (std::size_t i = 0; i < all.size() && k < some.size(); ++i)
    if (all.pointAt(i) == some.pointAt(k)) ++k;
  EXPECT_EQ(k, some.size());
}

TEST(ViewSurface, EstimatesTheNoiseOfItsSamples) {
  // Noise along the ray is seen across the surface, so a little smaller than along it.
  const View view = scanFrom(makeBall(), makeProfile(0.1), 0);
  const double noise = ViewSurface(*view.mesh, *view.image->rays).noise();
  EXPECT_GT(noise, 0.06);
  EXPECT_LT(noise, 0.12);
}

}  // namespace
}  // namespace vantage
