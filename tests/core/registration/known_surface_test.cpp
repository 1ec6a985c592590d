#include "registration/known_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/meshes.h"

namespace vantage {
namespace {

// 2 x 2 rays from the origin along +z, watched by receivers 100 mm to either side.
RayGrid raysWithReceivers() {
  const RangingRay ray{Vec3::Zero(), Vec3::UnitZ()};
  std::vector<Vec3> receivers;
  for (int i = 0; i < 4; ++i) receivers.insert(receivers.end(), {Vec3(100, 0, 0), Vec3(-100, 0, 0)});
  return {2, 2, std::vector<RangingRay>(4, ray), receivers, 2};
}

// A wall across z between two places in x, at half the way to z = 200.
Mesh wall(double from, double to) {
  return testing::makeBox(Vec3(from, -50, 99), Vec3(to, 50, 101));
}

bool hidden(const std::vector<Mesh>& walls, const Vec3& p) {
  std::vector<const Mesh*> meshes;
  for (const Mesh& mesh : walls) meshes.push_back(&mesh);
  return KnownSurface(meshes, 4.0, {}).hides(p, raysWithReceivers(), 0, Pose::Identity());
}

const Vec3 kPoint(0, 0, 200);

TEST(KnownSurface, HidesWhatTheLightDoesNotReach) {
  EXPECT_TRUE(hidden({wall(-10, 10)}, kPoint));
  EXPECT_FALSE(hidden({wall(-10, 10)}, Vec3(0, 0, 90)));
}

TEST(KnownSurface, HidesWhatNoReceiverSees) {
  EXPECT_FALSE(hidden({wall(30, 70)}, kPoint));
  EXPECT_FALSE(hidden({wall(-70, -30)}, kPoint));
  EXPECT_TRUE(hidden({wall(30, 70), wall(-70, -30)}, kPoint));
}

TEST(KnownSurface, HidesNoPointOfItsOwn) {
  EXPECT_FALSE(hidden({wall(-10, 10)}, Vec3(0, 0, 100.5)));
}

TEST(KnownSurface, IsWhereItIsAndNotWhereTheScannerIs) {
  const std::array<const Mesh*, 0> none{};
  EXPECT_FALSE(KnownSurface(none, 2.0, {}).hides(kPoint, raysWithReceivers(), 0, Pose::Identity()));
  const Mesh mesh = wall(-10, 10);
  const std::array<const Mesh*, 1> meshes{&mesh};
  Pose moved = Pose::Identity();
  moved.translation() = Vec3(300, 0, 0);
  EXPECT_FALSE(KnownSurface(meshes, 2.0, {}).hides(kPoint, raysWithReceivers(), 0, moved));
}

}  // namespace
}  // namespace vantage
