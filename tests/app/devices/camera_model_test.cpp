#include "devices/camera_model.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

const CameraModel kCamera{640, 480, radians(58.0), radians(45.2)};
const Vec3 kPosition(450, 0, 250);
const Vec3 kLookAt(0, 0, 60);

ScannerProfile pinholeProfile(int columns, int rows, double horizontal, double vertical) {
  ScannerProfile profile;
  profile.name = "Arm";
  profile.rays = std::make_shared<const RayGrid>(
      makeRays(Pinhole{kPosition, kLookAt, rows, columns, radians(horizontal), radians(vertical)}, {}));
  return profile;
}

std::string refusalOf(const CameraModel& camera, const ScannerProfile& profile) {
  try {
    static_cast<void>(pixelsOfRays(camera, profile));
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

TEST(CameraModel, TheAxisGoesThroughHalfTheColumns) {
  EXPECT_TRUE(pixelDirection(kCamera, 320, 240).isApprox(Vec3(0, 0, 1)));
  EXPECT_NEAR(pixelDirection(kCamera, 0, 240).x(), -std::tan(radians(29.0)), 1e-12);
  EXPECT_NEAR(pixelDirection(kCamera, 320, 0).y(), std::tan(radians(22.6)), 1e-12);
  EXPECT_EQ(describe(kCamera), "640 x 480 pixels over 58.0 x 45.2 degrees");
}

TEST(CameraModel, TheProfileOfACameraHasItsPixelsAsRays) {
  const ProfileSource source = profileOf(kCamera, "Depth Camera", {kPosition, kLookAt, Vec3(75, 0, 0), 36});
  const ScannerProfile profile = parseProfile(source);
  EXPECT_EQ(profile.rays->columns(), 639);
  EXPECT_EQ(profile.rays->rows(), 479);
  EXPECT_TRUE(profile.rays->triangulates());
  const PixelsOfRays pixels = pixelsOfRays(kCamera, profile);
  EXPECT_LT(pixels.worst, 1e-6);
  const Vec3 forward = (kLookAt - kPosition).normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  const Vec3 up = right.cross(forward);
  for (const auto& [x, y] : {std::pair{1, 1}, {639, 1}, {320, 240}, {17, 400}}) {
    const std::size_t i = profile.rays->index(y - 1, x - 1);
    EXPECT_EQ(pixels.pixel[i], static_cast<std::size_t>(y * 640 + x));
    const Vec3 d = pixelDirection(kCamera, x, y);
    const Vec3 expected = d.x() * right + d.y() * up + forward;
    EXPECT_TRUE(profile.rays->ray(i).direction.isApprox(expected.normalized(), 1e-9)) << x << " " << y;
    EXPECT_NEAR(pixels.stretch[i], expected.norm(), 1e-9);
  }
}

TEST(CameraModel, AProfileOfAsManyRaysFitsToWithinHalfAPixel) {
  const PixelsOfRays pixels = pixelsOfRays(kCamera, pinholeProfile(640, 480, 58.0, 45.2));
  EXPECT_GT(pixels.worst, 0.01);
  EXPECT_LE(pixels.worst, kMostPixelError);
  EXPECT_EQ(pixels.pixel.front(), 0U);
  EXPECT_EQ(pixels.pixel.back(), 640U * 480U - 1U);
}

TEST(CameraModel, AnotherProfileIsRefusedAndToldWhatTheCameraHas) {
  const std::string fov = refusalOf(kCamera, pinholeProfile(640, 480, 50.0, 38.5));
  EXPECT_NE(fov.find("640 x 480 pixels over 58.0 x 45.2 degrees"), std::string::npos) << fov;
  EXPECT_NE(fov.find("pixels beside them"), std::string::npos) << fov;
  const std::string size = refusalOf(kCamera, pinholeProfile(320, 240, 58.0, 45.2));
  EXPECT_NE(size.find("Arm has 320 x 240 rays"), std::string::npos) << size;
  ScannerProfile stripe = pinholeProfile(64, 48, 50, 40);
  stripe.rays = std::make_shared<const RayGrid>(makeRays(LinearStripe{Vec3(300, 0, 150), 40, 48, 64, 40}, {}));
  EXPECT_NE(refusalOf({64, 48, 0.9, 0.7}, stripe).find("one point"), std::string::npos);
}

TEST(CameraModel, AMirroredProfileDoesNotFit) {
  ScannerProfile profile = pinholeProfile(64, 48, 50, 40);
  std::vector<RangingRay> rays;
  for (int r = 0; r < 48; ++r)
    for (int c = 63; c >= 0; --c) rays.push_back(profile.rays->ray(profile.rays->index(r, c)));
  profile.rays = std::make_shared<const RayGrid>(48, 64, rays, std::vector<Vec3>{}, 0);
  EXPECT_NE(refusalOf({64, 48, radians(50.0), radians(40.0)}, profile), "");
}

TEST(CameraModel, ACameraWithoutAFieldOfViewHasNoProfile) {
  EXPECT_THROW(static_cast<void>(profileOf({640, 480, 0.0, 0.0}, "Blind", {})), InvalidInput);
  EXPECT_TRUE(sizeFits(640, 480, *pinholeProfile(639, 479, 50, 40).rays));
  EXPECT_FALSE(sizeFits(640, 480, *pinholeProfile(638, 479, 50, 40).rays));
}

}  // namespace
}  // namespace vantage
