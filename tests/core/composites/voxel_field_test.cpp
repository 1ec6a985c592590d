#include "composites/voxel_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "base/errors.h"
#include "base/random.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

TEST(VoxelField, KnowsTheNearestPointToWithinACube) {
  const Mesh ball = testing::makeSphere(30.0, 30, Vec3(1, 2, 3));
  const VoxelField field(ball.vertices, {}, 3.0, 12.0, {});
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p =
        Vec3(1, 2, 3) + 38.0 * random.uniform() * Vec3(random.normal(), random.normal(), random.normal()).normalized();
    double least = 1e9;
    for (const Vec3& q : ball.vertices) least = std::min(least, (p - q).norm());
    const auto found = field.nearest(p);
    ASSERT_TRUE(found);
    EXPECT_LE((p - ball.vertices[*found]).norm(), least + 3.0 * std::sqrt(3.0));
  }
  EXPECT_FALSE(field.nearest(Vec3(1, 2, 3 + 60.0)));
}

TEST(VoxelField, IsFreeWhereRaysPassedAndNotBehindTheSurface) {
  const Mesh body = testing::makeBox(Vec3(-20, -20, 10), Vec3(20, 20, 90), 8);
  const Composite stand = testing::acquireStand(body, Pose::Identity(), 1);
  const VoxelField field(stand.model->mesh.vertices, stand.views, 5.0, 30.0, {});
  EXPECT_TRUE(field.isFree(Vec3(35, 0, 50)));    // before the side that the scanner saw from +x
  EXPECT_FALSE(field.isFree(Vec3(0, 0, 50)));    // inside
  EXPECT_FALSE(field.isFree(Vec3(-35, 0, 50)));  // behind
  EXPECT_FALSE(field.isFree(Vec3(35, 0, 118)));  // above: no ray that measured passed there
  EXPECT_FALSE(field.isFree(Vec3(21, 0, 50)));   // on the surface
}

TEST(VoxelField, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const Mesh ball = testing::makeSphere(30.0, 30);
  EXPECT_THROW(VoxelField(ball.vertices, {}, 3.0, 12.0, Progress({}, source.get_token(), 1)), Cancelled);
}

}  // namespace
}  // namespace vantage
