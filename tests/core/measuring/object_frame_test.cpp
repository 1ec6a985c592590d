#include "measuring/object_frame.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace vantage {
namespace {

void expectRigid(const Pose& pose) {
  EXPECT_NEAR((pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
}

TEST(ObjectFrame, ThreePicksAreOriginAxisAndPlane) {
  const Vec3 a(5, 1, 2);
  const Vec3 b(8, 1, 6);
  const Vec3 c(5, 4, 2.5);
  const Pose T_out_object = frameFromPicks({a, b, c});
  expectRigid(T_out_object);
  EXPECT_NEAR((T_out_object * a).norm(), 0.0, 1e-12);
  EXPECT_NEAR((T_out_object * b - Vec3(5, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((T_out_object * c).z(), 0.0, 1e-12);
  EXPECT_GT((T_out_object * c).y(), 0.0);
  EXPECT_THROW(static_cast<void>(frameFromPicks({a, b, a})), InvalidInput);
}

TEST(ObjectFrame, OnABaseItStandsOnZero) {
  const SurfacePlane base = planeThrough({Vec3(0, 0, 1), Vec3(4, 0, 2), Vec3(0, 3, 1)});
  const Vec3 origin(1, 1, 8);
  const Pose T_out_object = frameOnBase(base, origin, Vec3(3, 1, 7));
  expectRigid(T_out_object);
  EXPECT_NEAR((T_out_object * origin).head<2>().norm(), 0.0, 1e-12);
  EXPECT_NEAR((T_out_object * origin).z(), base.distance(origin), 1e-12);
  EXPECT_NEAR((T_out_object * Vec3(3, 1, 7)).y(), 0.0, 1e-12);
  EXPECT_GT((T_out_object * Vec3(3, 1, 7)).x(), 0.0);
  EXPECT_THROW(static_cast<void>(frameOnBase(base, origin, origin + base.normal)), InvalidInput);
}

TEST(ObjectFrame, OnAPlaneAloneItTurnsAsLittleAsPossible) {
  const Pose flat = frameOnPlane({Vec3::UnitZ(), 3.0});
  EXPECT_NEAR((flat * Vec3(1, 2, 3) - Vec3(1, 2, 0)).norm(), 0.0, 1e-12);
  const SurfacePlane base = planeThrough({Vec3(0, 0, 1), Vec3(4, 0, 2), Vec3(0, 3, 1)});
  const Pose tilted = frameOnPlane(base);
  expectRigid(tilted);
  for (const Vec3& p : {Vec3(0, 0, 1), Vec3(4, 0, 2), Vec3(0, 3, 1)}) EXPECT_NEAR((tilted * p).z(), 0.0, 1e-12);
  expectRigid(frameOnPlane({-Vec3::UnitZ(), -3.0}));
}

}  // namespace
}  // namespace vantage
