#include "integration/mending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "base/errors.h"
#include "geometry/measures.h"
#include "integration/zipper.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::expectDisc;
using testing::flat;
using testing::Height;
using testing::kNothing;
using testing::lookDown;
using testing::modelOf;
using testing::Window;

const Window kWindow{31, 31, 0.0, 0.0};

// A window without samples in a box.
Height without(const Vec2& from, const Vec2& to, const Height& height) {
  return [=](double x, double y) {
    return x >= from.x() && x <= to.x() && y >= from.y() && y <= to.y() ? kNothing : height(x, y);
  };
}

// The view's mesh without the triangles whose centre lies in a box.
Model cutOut(const View& view, const Vec2& from, const Vec2& to) {
  Mesh mesh = view.mesh->mesh;
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3 c = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    return c.x() > from.x() && c.x() < to.x() && c.y() > from.y() && c.y() < to.y();
  });
  Model model = modelOf(mesh);
  for (std::size_t v = 0; v < model.vertexSample.size(); ++v) model.vertexSample[v] = view.mesh->sample[v];
  return model;
}

TEST(Mend, SlitThatAViewHasMeasuredCloses) {
  const std::vector<View> views{lookDown(kWindow, flat(0.0))};
  const Model slit = cutOut(views[0], {5, 10}, {25, 11});
  ASSERT_EQ(measure(slit.mesh).boundaryLoops, 2U);
  const MendedModel mended = mend(slit, views, {});
  EXPECT_EQ(mended.holesClosed, 1U);
  expectDisc(mended.model.mesh);
  EXPECT_NEAR(area(mended.model.mesh), 900.0, 1e-9);
}

TEST(Mend, SlitThatOnlyAnotherViewHasMeasuredCloses) {
  // A gently curved surface that the first view has no samples of inside of a slit.
  const auto bowl = [](double x, double y) { return 0.01 * ((x - 15.0) * (x - 15.0) + (y - 15.0) * (y - 15.0)); };
  const View whole = lookDown(kWindow, bowl);
  const View across = lookDown({41, 41, -5.3, -5.4}, bowl);
  const Model slit = cutOut(whole, {6, 14}, {24, 16});
  const std::vector<View> views{lookDown(kWindow, without({7, 14.5}, {23, 15.5}, bowl)), across};
  for (const Triangle& t : slit.mesh.triangles)
    for (const std::uint32_t v : t) ASSERT_TRUE(views[0].image->valid(slit.vertexSample[v])) << v;
  const MendedModel mended = mend(slit, views, {});
  EXPECT_EQ(mended.holesClosed, 1U);
  expectDisc(mended.model.mesh);
  EXPECT_EQ(mend(slit, std::vector<View>{views[0]}, {}).holesClosed, 0U);
}

TEST(Mend, BordersThatOverlapAreReplaced) {
  // The slit's border is pushed over the opposite one, as samples are that two views place differently.
  const std::vector<View> views{lookDown(kWindow, flat(0.0))};
  Model model = cutOut(views[0], {5, 10}, {25, 11});
  for (Vec3& p : model.mesh.vertices)
    if (p.y() == 10.0 && p.x() > 5.5 && p.x() < 24.5) p += Vec3(0.0, 1.4, 0.2);
  ZipperOptions steep;
  steep.breakdownAngle = radians(75.0);
  const MendedModel mended = mend(model, views, steep);
  EXPECT_EQ(mended.holesClosed, 1U);
  expectDisc(mended.model.mesh);
}

TEST(Mend, HoleThatNoViewHasMeasuredStays) {
  const std::vector<View> views{lookDown(kWindow, without({11, 11}, {19, 19}, flat(0.0))),
                                lookDown({31, 31, 0.4, 0.3}, without({10.5, 10.5}, {19.5, 19.5}, flat(0.0)))};
  const Model before = integrateView({}, views, 0, {}).model;
  const MendedModel mended = mend(before, views, {});
  EXPECT_EQ(mended.holesClosed, 0U);
  EXPECT_EQ(mended.model.mesh.triangles, before.mesh.triangles);
}

TEST(Mend, HoleThatAViewHasLookedThroughStays) {
  const std::vector<View> views{lookDown(kWindow, without({13, 13}, {17, 17}, flat(0.0))),
                                lookDown({31, 31, 0.4, 0.3}, flat(-6.0))};
  const Model before = integrateView({}, views, 0, {}).model;
  EXPECT_EQ(mend(before, views, {}).holesClosed, 0U);
}

TEST(Mend, OuterBorderStaysWhereItIs) {
  const std::vector<View> views{lookDown({12, 12, 0, 0}, flat(0.0))};
  const Model before = integrateView({}, views, 0, {}).model;
  EXPECT_EQ(mend(before, views, {}).model.mesh.triangles, before.mesh.triangles);
}

TEST(Mend, NumberOfThreadsChangesNothing) {
  const std::vector<View> views{lookDown(kWindow, flat(0.0)), lookDown({31, 31, 0.4, 0.3}, flat(0.1))};
  const Model slit = cutOut(views[0], {5, 10}, {25, 12});
  const Model one = mend(slit, views, {}, Progress({}, {}, 1)).model;
  const Model three = mend(slit, views, {}, Progress({}, {}, 3)).model;
  EXPECT_EQ(one.mesh.vertices, three.mesh.vertices);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
}

TEST(Mend, RefusesViewsWithoutTheirPiecesAndStops) {
  const std::vector<View> views{lookDown(kWindow, flat(0.0))};
  const Model model = integrateView({}, views, 0, {}).model;
  EXPECT_THROW((void)mend(model, std::vector<View>(1), {}), InvalidInput);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)mend(model, views, {}, Progress({}, stop.get_token(), 1)), Cancelled);
  EXPECT_TRUE(mend({}, {}, {}).model.mesh.empty());
}

}  // namespace
}  // namespace vantage
