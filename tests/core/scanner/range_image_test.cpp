#include "scanner/range_image.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "base/errors.h"
#include "scanner/ray_patterns.h"

namespace vantage {
namespace {

RangeImage flatImage() {
  RangeImage image;
  image.rays = std::make_shared<const RayGrid>(makeRays(LinearStripe{Vec3(100, 0, 0), 2, 3, 3, 2}, {}));
  image.range.assign(9, 10.0F);
  return image;
}

TEST(RangeImage, PointsLieAlongTheirRays) {
  const RangeImage image = flatImage();
  EXPECT_TRUE(image.point(0).isApprox(Vec3(90, -1, -1)));
  EXPECT_TRUE(image.point(8).isApprox(Vec3(90, 1, 1)));
}

TEST(RangeImage, CountsWhatWasMeasured) {
  RangeImage image = flatImage();
  EXPECT_EQ(image.sampleCount(), 9U);
  image.range[4] = kNoSample;
  EXPECT_FALSE(image.valid(4));
  EXPECT_EQ(image.sampleCount(), 8U);
}

TEST(RangeImage, ValidateRefusesWhatIsNone) {
  EXPECT_NO_THROW(validate(flatImage()));
  EXPECT_THROW(validate(RangeImage{}), InvalidInput);
  RangeImage image = flatImage();
  image.range.pop_back();
  EXPECT_THROW(validate(image), InvalidInput);
  for (const float distance :
       {-1.0F, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    image = flatImage();
    image.range[3] = distance;
    EXPECT_THROW(validate(image), InvalidInput) << distance;
  }
}

TEST(RangeImage, ValidateRefusesAPoseThatIsNoRigidMotion) {
  RangeImage image = flatImage();
  image.T_table_scanner.linear() *= 2.0;
  EXPECT_THROW(validate(image), InvalidInput);
  image = flatImage();
  image.T_table_scanner.linear()(0, 0) = -1.0;  // a mirror
  EXPECT_THROW(validate(image), InvalidInput);
  image = flatImage();
  image.T_table_scanner.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(validate(image), InvalidInput);
}

}  // namespace
}  // namespace vantage
