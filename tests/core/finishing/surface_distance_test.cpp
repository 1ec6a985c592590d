#include "finishing/surface_distance.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makeGrid;
using testing::makeSphere;

TEST(SurfaceDistance, OfASurfaceToItselfIsNothing) {
  const SurfaceDistance distance = distanceBetween(makeSphere(10.0, 12), makeSphere(10.0, 12));
  EXPECT_NEAR(distance.greatest, 0.0, 1e-6);
  EXPECT_NEAR(distance.rms, 0.0, 1e-6);
}

TEST(SurfaceDistance, OfParallelSheetsIsTheGap) {
  Mesh above = makeGrid(10, 10, 1.0);
  for (Vec3& v : above.vertices) v.z() = 0.25;
  const SurfaceDistance distance = distanceBetween(makeGrid(10, 10, 1.0), above, Progress({}, {}, 3));
  EXPECT_NEAR(distance.greatest, 0.25, 1e-6);
  EXPECT_NEAR(distance.rms, 0.25, 1e-6);
}

TEST(SurfaceDistance, CountsBothWays) {
  // The small sheet lies on the large one; the far corner of the large one is sqrt(2) 6 away from the small one.
  const Mesh large = makeGrid(10, 10, 1.0);
  const Mesh small = makeGrid(4, 4, 1.0);
  EXPECT_NEAR(distanceBetween(large, small).greatest, 6.0 * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(distanceBetween(small, large).greatest, 6.0 * std::sqrt(2.0), 1e-5);
}

TEST(SurfaceDistance, NeedsTwoSurfaces) {
  EXPECT_THROW(static_cast<void>(distanceBetween({}, makeGrid(1, 1, 1.0))), InvalidInput);
  EXPECT_THROW(static_cast<void>(distanceBetween(makeGrid(1, 1, 1.0), {})), InvalidInput);
}

}  // namespace
}  // namespace vantage
