#include <gtest/gtest.h>

#include "base/errors.h"
#include "devices/openni2_sensor.h"

namespace vantage {
namespace {

TEST(WithoutOpenNi2, IsSaidInASentence) {
  EXPECT_THROW(static_cast<void>(connectedCameras()), DeviceError);
  EXPECT_THROW(static_cast<void>(profileOfCamera({}, {})), DeviceError);
  EXPECT_THROW(static_cast<void>(makeOpenNi2Sensor({}, nullptr)), DeviceError);
}

}  // namespace
}  // namespace vantage
