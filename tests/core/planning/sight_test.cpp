#include "scanner/sight.h"

#include <gtest/gtest.h>

#include "core/planning/scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

Mesh wall(const Vec3& min, const Vec3& max) {
  return testing::makeBox(min, max);
}

Visibility look(const Mesh& obstacles, const Vec3& point, const Vec3& normal) {
  const ScannerProfile profile = testing::flatScanner();
  const RayCaster caster(obstacles);
  return SightTest(profile, caster, {}).look(Pose::Identity(), point, normal.normalized()).visibility;
}

const Mesh kNothing;

TEST(SightTest, SeesAPointThatFacesTheScanner) {
  EXPECT_EQ(look(kNothing, {0, 0, 100}, {1, 0, 0}), Visibility::Seen);
}

TEST(SightTest, ReachesNeitherBesideTheRaysNorBeyondTheirRange) {
  EXPECT_EQ(look(kNothing, {0, 0, 210}, {1, 0, 0}), Visibility::OutOfReach);
  EXPECT_EQ(look(kNothing, {-110, 0, 100}, {1, 0, 0}), Visibility::OutOfReach);
  EXPECT_EQ(look(kNothing, {210, 0, 100}, {1, 0, 0}), Visibility::OutOfReach);
}

TEST(SightTest, FindsTheBreakdownAngle) {
  const auto tilted = [](double angle) { return Vec3(std::cos(radians(angle)), 0.0, std::sin(radians(angle))); };
  EXPECT_EQ(look(kNothing, {0, 0, 100}, tilted(59.0)), Visibility::Seen);
  EXPECT_EQ(look(kNothing, {0, 0, 100}, tilted(61.0)), Visibility::TooSteep);
}

TEST(SightTest, TellsABlockedLightFromABlockedReceiver) {
  const Mesh inTheLight = wall({100, -5, 95}, {110, 5, 105});
  EXPECT_EQ(look(inTheLight, {0, 0, 100}, {1, 0, 0}), Visibility::LightBlocked);
  // Halfway to the receiver at (300, 60, 100) the line of sight passes y = 30.
  const Mesh inTheSight = wall({140, 20, 95}, {160, 40, 105});
  EXPECT_EQ(look(inTheSight, {0, 0, 100}, {1, 0, 0}), Visibility::ReceiverBlocked);
}

TEST(SightTest, TurnsWithThePose) {
  const ScannerProfile profile = testing::flatScanner();
  const RayCaster caster(kNothing);
  const SightTest sight(profile, caster, {});
  const Sight s = sight.look(profile.workspace.poses[1], {0, 20, 100}, Vec3::UnitY());
  EXPECT_EQ(s.visibility, Visibility::Seen);
  EXPECT_NEAR(s.cosine, 1.0, 1e-12);
  EXPECT_TRUE(s.direction.isApprox(Vec3::UnitY(), 1e-12));
}

TEST(SightTest, DoesNotMindWhatIsNearerThanTheMargin) {
  const ScannerProfile profile = testing::flatScanner();
  const Mesh nearby = wall({0.5, -5, 95}, {0.6, 5, 105});
  const RayCaster caster(nearby);
  const auto with = [&](double margin) {
    return SightTest(profile, caster, {radians(60.0), 0.1, margin}).look(Pose::Identity(), {0, 0, 100}, Vec3::UnitX());
  };
  EXPECT_EQ(with(0.1).visibility, Visibility::LightBlocked);
  EXPECT_EQ(with(1.0).visibility, Visibility::Seen);
}

TEST(SightTest, IsReceivedOnlyOnTheSideThatTheNormalPointsTo) {
  const ScannerProfile profile = testing::flatScanner();
  const RayCaster caster(kNothing);
  const SightTest sight(profile, caster, {});
  const std::size_t ray = profile.rays->nearest(*profile.rays->locate({0, 0, 100}));
  EXPECT_TRUE(sight.received(Pose::Identity(), ray, {0, 0, 100}, Vec3::UnitX()));
  EXPECT_FALSE(sight.received(Pose::Identity(), ray, {0, 0, 100}, -Vec3::UnitX()));
}

TEST(Visibility, HasANameForEveryValue) {
  EXPECT_EQ(name(Visibility::OutOfReach), "out_of_reach");
  EXPECT_EQ(name(Visibility::Seen), "seen");
}

}  // namespace
}  // namespace vantage
