#include "calibration/profile_from_scans.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "calibration/grid_samples.h"
#include "calibration/pinhole_fit.h"
#include "calibration/ray_field_fit.h"
#include "turning_scene.h"

namespace vantage::testing {
namespace {

std::vector<RangeImage> imagesOf(const TurningScene& scene, std::vector<double> angles = {0, 50, 100}) {
  std::vector<RangeImage> images;
  for (const CalibrationScan& scan : scene.scans(angles)) images.push_back(*scan.image);
  return images;
}

TurningScene lumpBefore(std::shared_ptr<const ScannerProfile> profile) {
  TurningScene scene;
  scene.object = makeLump();
  scene.profile = std::move(profile);
  scene.wall = true;
  return scene;
}

// The same samples in the frame of a camera: x right, y down, z forward. The rays are from its origin.
RangeImage inCamera(const RangeImage& image) {
  const RayGrid& rays = *image.rays;
  const Vec3 forward = rays.rayAt({0.5 * (rays.rows() - 1), 0.5 * (rays.columns() - 1)}).direction;
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  Eigen::Matrix3d turn;
  turn << right.transpose(), (forward.cross(right)).transpose(), forward.transpose();
  std::vector<RangingRay> turned;
  for (std::size_t i = 0; i < rays.size(); ++i)
    turned.push_back({Vec3::Zero(), (turn * rays.ray(i).direction).normalized()});
  RangeImage result = image;
  result.rays = std::make_shared<const RayGrid>(rays.rows(), rays.columns(), std::move(turned), std::vector<Vec3>(), 0);
  return result;
}

TEST(ProfileFromScans, FindsACamera) {
  const TurningScene scene = lumpBefore(cameraOverTable());
  const ProfileFit fit = profileFromScans(imagesOf(scene), {});
  EXPECT_EQ(fit.type, "pinhole");
  EXPECT_LT(fit.residual, 0.1);
  EXPECT_NEAR(fit.noise, 0.1, 0.03);
  // Little of a lump is steep: where its samples end is on the safe side, and the truth between what is said.
  EXPECT_GT(degrees(fit.breakdownAngle), 60.0);
  EXPECT_LT(degrees(fit.breakdownAngle), 78.0);
  EXPECT_LE(fit.end.from, scene.profile->breakdownAngle + radians(1.0));
  EXPECT_GE(fit.end.to, scene.profile->breakdownAngle - radians(1.0));
  const ScannerProfile profile = parseProfile(fit.source);
  ASSERT_EQ(profile.rays->size(), scene.profile->rays->size());
  EXPECT_EQ(profile.workspace.size(), 90U);
  const RayGrid& truth = *scene.profile->rays;
  for (const std::size_t i : {std::size_t{0}, truth.size() / 2, truth.size() - 1}) {
    EXPECT_LT((profile.rays->ray(i).origin - truth.ray(i).origin).norm(), 1.0) << i;
    EXPECT_LT((profile.rays->ray(i).direction - truth.ray(i).direction).norm(), 0.003) << i;
  }
  EXPECT_FALSE(profile.rays->triangulates());
}

TEST(ProfileFromScans, PutsACameraAtItsOriginBeforeTheTable) {
  std::vector<RangeImage> images = imagesOf(lumpBefore(cameraOverTable()));
  for (RangeImage& image : images) image = inCamera(image);
  const ProfileFit fit = profileFromScans(images, {});
  EXPECT_EQ(fit.type, "pinhole");
  const ScannerProfile profile = parseProfile(fit.source);
  EXPECT_GT(profile.rays->ray(0).origin.x(), 200.0);
  const double middle = 0.5 * (profile.rays->columns() - 1);
  EXPECT_LT(profile.rays->rayAt({0.5 * (profile.rays->rows() - 1), middle}).direction.x(), -0.99);
}

TEST(ProfileFromScans, OtherRaysBecomeATable) {
  const TurningScene scene = lumpBefore(stripeScanner());
  ProfileFitOptions options;
  options.receiver = Vec3(60, 0, 0);
  const std::vector<RangeImage> images = imagesOf(scene);
  const ProfileFit fit = profileFromScans(images, options);
  EXPECT_EQ(fit.type, "rays");
  EXPECT_LT(fit.residual, 0.5);
  const ScannerProfile profile = parseProfile(fit.source);
  EXPECT_TRUE(profile.rays->triangulates());
  EXPECT_LT(distanceFromRays(gridSamples(images, 2000), *profile.rays), 0.5);
}

TEST(ProfileFromScans, NoiseComesFromScansOfTheSame) {
  TurningScene scene = lumpBefore(cameraOverTable(0.2));
  scene.turnsPerCount = 0.0;
  const ProfileFit fit = profileFromScans(imagesOf(scene), {});
  EXPECT_TRUE(fit.noiseFromRepeats);
  EXPECT_NEAR(fit.noise, 0.2, 0.02);
}

TEST(ProfileFromScans, RefusesNoScansAndNoSamples) {
  EXPECT_THROW((void)profileFromScans({}, {}), InvalidInput);
  RangeImage empty = imagesOf(lumpBefore(stripeScanner()), {0.0}).front();
  empty.range.assign(empty.range.size(), kNoSample);
  EXPECT_THROW((void)profileFromScans(std::vector<RangeImage>{empty}, {}), InvalidInput);
}

TEST(PinholeFit, OnePlaneTellsNoCamera) {
  std::vector<GridSample> samples;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column)
      samples.push_back(
          {static_cast<double>(row), static_cast<double>(column), Vec3(0.0, 3.0 * column - 30.0, 30.0 - 3.0 * row)});
  EXPECT_FALSE(fitPinhole(samples, 20, 20));
}

TEST(RayFieldFit, ParallelRaysStayParallel) {
  std::vector<GridSample> samples;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column)
      samples.push_back({static_cast<double>(row), static_cast<double>(column),
                         Vec3(7.0 * ((row * 5 + column * 3) % 11), 2.0 * column, 2.0 * row)});
  const RayGrid rays = fitRayField(samples, 20, 20, -Vec3::UnitX(), 50.0);
  for (const std::size_t i : {std::size_t{0}, std::size_t{210}, std::size_t{399}}) {
    EXPECT_NEAR(rays.ray(i).direction.x(), -1.0, 1e-6);
    EXPECT_NEAR(rays.ray(i).origin.x(), 120.0, 1e-6);
  }
  EXPECT_LT(distanceFromRays(samples, rays), 0.01);
}

}  // namespace
}  // namespace vantage::testing
