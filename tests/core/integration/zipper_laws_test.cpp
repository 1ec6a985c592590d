// What must hold of every integration, on scans of closed objects with noise.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/measures.h"
#include "integration/zipper.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::around;
using testing::countBowTies;
using testing::Direction;
using testing::eulerCharacteristic;
using testing::joined;
using testing::makeBox;
using testing::makeSphere;
using testing::scanFrom;

constexpr double kRadius = 30.0;
constexpr double kNoise = 0.1;

std::vector<Direction> allAround() {
  std::vector<Direction> directions = around(6);
  directions.push_back({0.3, radians(90.0)});
  directions.push_back({0.0, radians(-90.0)});
  return directions;
}

std::vector<View> ballViews(double noise) {
  return scanFrom(makeSphere(kRadius, 60), allAround(), noise);
}

void expectManifold(const Mesh& mesh) {
  EXPECT_EQ(measure(mesh).nonManifoldEdges, 0U);
  EXPECT_EQ(countBowTies(mesh), 0U);
}

void expectSame(const Model& a, const Model& b) {
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.vertexView, b.vertexView);
  EXPECT_EQ(a.vertexSample, b.vertexSample);
  EXPECT_EQ(a.triangleView, b.triangleView);
}

TEST(ZipperLaws, BallSeenFromEverywhereCloses) {
  for (const double noise : {0.0, kNoise}) {
    const Model model = zipper(ballViews(noise), {}).model;
    expectManifold(model.mesh);
    const MeshMeasures m = measure(model.mesh);
    EXPECT_EQ(m.boundaryEdges, 0U);
    EXPECT_EQ(m.components, 1U);
    EXPECT_EQ(eulerCharacteristic(model.mesh), 2);
    // Noise of a twelfth of the spacing roughens it.
    EXPECT_NEAR(m.area, 4.0 * kPi * kRadius * kRadius, (noise > 0.0 ? 0.03 : 0.005) * 4.0 * kPi * kRadius * kRadius);
  }
}

TEST(ZipperLaws, BallSeenFromItsEquatorIsOpenAtThePoles) {
  const Model model = zipper(scanFrom(makeSphere(kRadius, 60), around(8), kNoise), {}).model;
  expectManifold(model.mesh);
  EXPECT_EQ(measure(model.mesh).boundaryLoops, 2U);
  EXPECT_EQ(measure(model.mesh).components, 1U);
  EXPECT_EQ(eulerCharacteristic(model.mesh), 0);
}

TEST(ZipperLaws, SmallPoseErrorsDoNotTearIt) {
  std::vector<View> views = ballViews(kNoise);
  for (std::size_t k = 1; k < views.size(); ++k) {
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    Vec6 error;
    error << sign * radians(0.2), radians(0.1), -sign * radians(0.2), 0.15, sign * 0.2, -0.1;
    views[k].T_object_scanner = smallMotion(error) * views[k].T_object_scanner;
  }
  const Model model = zipper(views, {}).model;
  expectManifold(model.mesh);
  EXPECT_EQ(measure(model.mesh).boundaryEdges, 0U);
  EXPECT_EQ(eulerCharacteristic(model.mesh), 2);
}

TEST(ZipperLaws, BoxWithSharpEdgesCloses) {
  std::vector<Direction> directions;
  for (const double elevation : {-35.0, 35.0})
    for (int i = 0; i < 4; ++i) directions.push_back({radians(45.0 + 90.0 * i), radians(elevation)});
  const Model model = zipper(scanFrom(makeBox(Vec3(-20, -20, -20), Vec3(20, 20, 20), 4), directions, 0.02), {}).model;
  expectManifold(model.mesh);
  EXPECT_EQ(measure(model.mesh).components, 1U);
  // Corners and edges are cut by up to a sample spacing.
  EXPECT_NEAR(measure(model.mesh).area, 9600.0, 0.03 * 9600.0);
}

TEST(ZipperLaws, NumberOfThreadsChangesNothing) {
  const std::vector<View> views = ballViews(kNoise);
  const Model one = zipper(views, {}, Progress({}, {}, 1)).model;
  expectSame(one, zipper(views, {}, Progress({}, {}, 3)).model);
}

TEST(ZipperLaws, EveryVertexIsTheSampleItNames) {
  const std::vector<View> views = ballViews(kNoise);
  const Model model = zipper(views, {}).model;
  for (std::size_t v = 0; v < model.mesh.vertices.size(); ++v) {
    const View& view = views[model.vertexView[v]];
    ASSERT_EQ(model.mesh.vertices[v], view.T_object_scanner * view.image->point(model.vertexSample[v]));
  }
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t)
    for (const std::uint32_t v : model.mesh.triangles[t]) ASSERT_GE(model.triangleView[t], model.vertexView[v]);
}

TEST(ZipperLaws, ReposingWithUnchangedPosesIsTheIdentity) {
  const std::vector<View> views = ballViews(kNoise);
  const Model model = zipper(views, {}).model;
  expectSame(model, reposed(model, views));
}

TEST(ZipperLaws, ReposingFollowsTheViews) {
  std::vector<View> views = ballViews(kNoise);
  const Model model = zipper(views, {}).model;
  const Vec3 shift(0.1, -0.2, 0.3);
  views[2].T_object_scanner.pretranslate(shift);
  const Model moved = reposed(model, views);
  for (std::size_t v = 0; v < model.mesh.vertices.size(); ++v) {
    const Vec3 expected = model.vertexView[v] == 2 ? shift : Vec3(Vec3::Zero());
    EXPECT_NEAR((moved.mesh.vertices[v] - model.mesh.vertices[v] - expected).norm(), 0.0, 1e-12);
  }
}

TEST(ZipperLaws, SameViewTwiceChangesNothing) {
  std::vector<View> views = ballViews(kNoise);
  views.push_back(views[2]);
  const Model before = zipper(std::span(views).first(3), {}).model;
  const Integration after = integrateView(before, views, 8, {});
  EXPECT_EQ(after.statistics.removedFromModel, 0U);
  EXPECT_NEAR(area(after.model.mesh), area(before.mesh), 1e-3 * area(before.mesh));
  EXPECT_EQ(measure(after.model.mesh).boundaryLoops, measure(before.mesh).boundaryLoops);
}

TEST(ZipperLaws, ViewOfWhatIsKnownAddsNoSurface) {
  // Everything is closed: whatever the ninth view replaces, the ball stays one.
  std::vector<Direction> directions = allAround();
  directions.push_back({0.4, 0.5});
  const std::vector<View> views = scanFrom(makeSphere(kRadius, 60), directions, kNoise);
  const Model before = zipper(std::span(views).first(8), {}).model;
  const Integration after = integrateView(before, views, 8, {});
  expectManifold(after.model.mesh);
  EXPECT_EQ(measure(after.model.mesh).boundaryEdges, 0U);
  EXPECT_NEAR(area(after.model.mesh), area(before.mesh), 2e-3 * area(before.mesh));
}

TEST(ZipperLaws, PiecesThatDoNotTouchAreBothKept) {
  const Mesh object = joined(makeSphere(12.0, 40, Vec3(0, -16, 0)), makeSphere(12.0, 40, Vec3(0, 16, 0)));
  const Model model = zipper(scanFrom(object, {{0.0, 0.0}, {0.5, 0.0}, {-0.5, 0.0}}, kNoise), {}).model;
  expectManifold(model.mesh);
  EXPECT_EQ(measure(model.mesh).components, 2U);
}

TEST(ZipperLaws, MovingEverythingKeepsTheTopology) {
  std::vector<View> views = ballViews(kNoise);
  const Model here = zipper(views, {}).model;
  Vec6 x;
  x << 0.7, -0.4, 1.1, 30.0, -12.0, 5.0;
  const Pose motion = smallMotion(x);
  for (View& view : views) view.T_object_scanner = motion * view.T_object_scanner;
  const Model there = zipper(views, {}).model;
  EXPECT_EQ(there.mesh.triangles, here.mesh.triangles);
  EXPECT_EQ(there.vertexSample, here.vertexSample);
  EXPECT_NEAR(area(there.mesh), area(here.mesh), 1e-6);
}

}  // namespace
}  // namespace vantage
