#include "vtk/navigation.h"

#include <gtest/gtest.h>

#include <array>

namespace vantage {
namespace {

constexpr QSizeF kSize(800.0, 600.0);

void expectNear(const Vec3& a, const Vec3& b, double within = 1e-9) {
  EXPECT_LT((a - b).norm(), within) << a.transpose() << " and " << b.transpose();
}

TEST(SightLine, ThroughTheMiddleIsTheViewingDirection) {
  const Camera camera;
  expectNear(sightLine(camera, {400.0, 300.0}, kSize).direction, camera.forward());
}

TEST(SightLine, ThroughTheTopEdgeIsHalfTheViewAngleUp) {
  Camera camera;
  camera.eye = {10.0, 0.0, 0.0};
  camera.viewAngle = radians(40.0);
  const Vec3 direction = sightLine(camera, {400.0, 0.0}, kSize).direction;
  expectNear(direction, {-std::cos(radians(20.0)), 0.0, std::sin(radians(20.0))});
}

TEST(SightLine, RightOfTheMiddleIsToTheRight) {
  Camera camera;
  camera.eye = {10.0, 0.0, 0.0};  // looks along -x: +y is to the right
  EXPECT_GT(sightLine(camera, {500.0, 300.0}, kSize).direction.y(), 0.0);
}

TEST(DistanceTo, IsMeasuredToTheQuadFromEitherSideAndMissesBesideIt) {
  const std::array<Vec3, 4> quad{Vec3(5, -1, -1), Vec3(5, 1, -1), Vec3(5, 1, 1), Vec3(5, -1, 1)};
  EXPECT_DOUBLE_EQ(distanceTo(quad, {Vec3::Zero(), Vec3::UnitX()}).value(), 5.0);
  EXPECT_DOUBLE_EQ(distanceTo(quad, {Vec3(12, 0.5, 0), -Vec3::UnitX()}).value(), 7.0);
  EXPECT_FALSE(distanceTo(quad, {Vec3(0, 1.1, 0), Vec3::UnitX()}));
  EXPECT_FALSE(distanceTo(quad, {Vec3::Zero(), -Vec3::UnitX()})) << "behind";
  EXPECT_FALSE(distanceTo(quad, {Vec3(5, -3, 0), Vec3::UnitY()})) << "along its plane";
}

TEST(CameraToward, HasEveryCornerOfTheBoxInSight) {
  const BoundingBox box{{-30.0, -80.0, 0.0}, {50.0, 20.0, 120.0}};
  for (const Vec3& forward : {Vec3(-1.0, 0.0, 0.0), Vec3(0.0, 0.0, -1.0), Vec3(-1.0, 0.5, -0.5)}) {
    for (const double aspect : {0.5, 1.0, 2.0}) {
      const Camera camera = cameraToward(forward, box, aspect);
      for (int c = 0; c < 8; ++c) {
        const Vec3 corner((c & 1) ? box.min.x() : box.max.x(), (c & 2) ? box.min.y() : box.max.y(),
                          (c & 4) ? box.min.z() : box.max.z());
        const Vec3 offset = corner - camera.eye;
        const double depth = offset.dot(camera.forward());
        const double half = std::tan(0.5 * camera.viewAngle) * depth;
        EXPECT_GT(depth, 0.0);
        EXPECT_LE(std::abs(offset.dot(camera.up)), half);
        EXPECT_LE(std::abs(offset.dot(camera.right())), half * aspect);
      }
    }
  }
}

TEST(Navigation, EverySchemeCanTurnPanAndZoomWithTheMouse) {
  const std::array buttons{Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
  const std::array<Qt::KeyboardModifiers, 3> modifiers{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
  for (int s = 0; s < kNavigationSchemes; ++s) {
    bool turns = false;
    bool pans = false;
    bool zooms = false;
    for (const auto button : buttons)
      for (const auto modifier : modifiers) {
        const Motion motion = motionFor(static_cast<NavigationScheme>(s), button, modifier);
        turns = turns || motion == Motion::Trackball || motion == Motion::Turntable;
        pans = pans || motion == Motion::Pan;
        zooms = zooms || motion == Motion::Zoom;
      }
    EXPECT_TRUE(turns && pans && zooms) << "scheme " << s;
  }
}

TEST(Navigation, SchemesDifferWhereTheirProgramsDo) {
  EXPECT_EQ(motionFor(NavigationScheme::MeshLab, Qt::LeftButton, Qt::NoModifier), Motion::Trackball);
  EXPECT_EQ(motionFor(NavigationScheme::MeshLab, Qt::MiddleButton, Qt::NoModifier), Motion::Pan);
  EXPECT_EQ(motionFor(NavigationScheme::CloudCompare, Qt::RightButton, Qt::NoModifier), Motion::Pan);
  EXPECT_EQ(motionFor(NavigationScheme::Blender, Qt::LeftButton, Qt::NoModifier), Motion::None);
  EXPECT_EQ(motionFor(NavigationScheme::Blender, Qt::MiddleButton, Qt::NoModifier), Motion::Turntable);
  EXPECT_EQ(motionFor(NavigationScheme::ParaView, Qt::RightButton, Qt::NoModifier), Motion::Zoom);
}

TEST(Navigation, TurningKeepsTargetAndDistance) {
  const Camera camera;
  for (const Motion motion : {Motion::Trackball, Motion::Turntable, Motion::Roll}) {
    const Camera after = moved(camera, motion, {100.0, 100.0}, {180.0, 40.0}, kSize);
    expectNear(after.target, camera.target);
    EXPECT_NEAR(after.distance(), camera.distance(), 1e-9);
    EXPECT_NEAR(after.up.norm(), 1.0, 1e-9);
  }
}

TEST(Navigation, TheTurntableKeepsTheHorizonLevelEvenOverThePole) {
  Camera camera;
  for (int i = 0; i < 100; ++i) {
    camera = moved(camera, Motion::Turntable, {0.0, 0.0}, {37.0, i % 20 < 10 ? 90.0 : -90.0}, kSize);
    EXPECT_NEAR(camera.right().z(), 0.0, 1e-9);
    EXPECT_GT(camera.up.z(), 0.0);
  }
}

TEST(Navigation, PanningMovesWhatIsAtTheTargetWithTheMouse) {
  const Camera camera;
  const Camera after = moved(camera, Motion::Pan, {400.0, 300.0}, {500.0, 250.0}, kSize);
  // The old target is now seen under the place where the mouse went.
  const SightLine line = sightLine(after, {500.0, 250.0}, kSize);
  expectNear(line.direction, (camera.target - after.eye).normalized(), 1e-9);
}

TEST(Navigation, ZoomingThereAndBackIsNoMove) {
  const Camera camera;
  expectNear(zoomed(zoomed(camera, 3.0), -3.0).eye, camera.eye, 1e-9);
  EXPECT_LT(zoomed(camera, 1.0).distance(), camera.distance());
}

TEST(Navigation, ZoomingEndsBeforeTheTarget) {
  Camera camera;
  camera = zoomed(camera, 1000.0);
  EXPECT_GT(camera.distance(), 0.5);
  EXPECT_LT(zoomed(camera, -1e6).distance(), 1e7);
}

}  // namespace
}  // namespace vantage
