#include "integration/zipper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/errors.h"
#include "geometry/measures.h"
#include "scenes.h"

namespace vantage {
namespace {

using testing::expectDisc;
using testing::flat;
using testing::Height;
using testing::kNothing;
using testing::lookDown;

double highest(const Mesh& mesh) {
  double z = -std::numeric_limits<double>::infinity();
  for (const Vec3& v : mesh.vertices) z = std::max(z, v.z());
  return z;
}

TEST(Zipper, FirstViewBecomesTheModel) {
  const std::vector<View> views{lookDown({6, 8, 0, 0}, flat(2.0))};
  const Integration result = zipper(views, {});
  EXPECT_EQ(result.model.mesh.triangles, views[0].mesh->mesh.triangles);
  EXPECT_EQ(result.model.mesh.vertices, views[0].mesh->mesh.vertices);
  EXPECT_EQ(result.statistics.added, 70U);
}

TEST(Zipper, OverlappingGridsBecomeOneDisc) {
  // Samples do not meet, and the borders cross: the union is 46.3 x 20 plus 6.4 below and above.
  const std::vector<View> views{lookDown({21, 31, 0, 0}, flat(0.0)), lookDown({21, 31, 15.3, 6.4}, flat(0.0))};
  const Integration result = zipper(views, {});
  expectDisc(result.model.mesh);
  const double unionArea = 30.0 * 20.0 + 30.0 * 20.0 - (30.0 - 15.3) * (20.0 - 6.4);
  // Where the borders cross, a triangle may reach across the re-entrant corner or fall short of it.
  EXPECT_NEAR(area(result.model.mesh), unionArea, 2.0);
  EXPECT_EQ(result.statistics.removedFromViews + result.statistics.added,
            views[0].mesh->mesh.triangles.size() + views[1].mesh->mesh.triangles.size());
}

TEST(Zipper, AbuttingGridsAreStitchedButDistantOnesAreNot) {
  const View left = lookDown({11, 11, 0, 0}, flat(0.0));
  const auto from = [](double edge) { return [=](double x, double) { return x < edge ? kNothing : 0.0; }; };
  const std::vector<View> near{left, lookDown({11, 16, 5.9, 0.3}, from(10.8))};
  expectDisc(zipper(near, {}).model.mesh);
  const std::vector<View> far{left, lookDown({11, 16, 5.9, 0.3}, from(14.8))};
  EXPECT_EQ(measure(zipper(far, {}).model.mesh).components, 2U);
}

TEST(Zipper, MirroredGridFacesTheScannerAllTheSame) {
  const std::vector<View> views{lookDown({21, 21, 0, 0, true}, flat(0.0)),
                                lookDown({21, 21, 12.4, 3.3, true}, flat(0.0)),
                                lookDown({21, 21, 5.2, 14.7}, flat(0.0))};
  const Model model = zipper(views, {}).model;
  expectDisc(model.mesh);
  for (const Triangle& t : model.mesh.triangles) EXPECT_GT(triangleNormal(model.mesh, t).z(), 0.99);
}

TEST(Zipper, HoleIsFilledByTheViewThatSeesIt) {
  const auto holed = [](double x, double y) { return std::hypot(x - 10, y - 10) < 4.5 ? kNothing : 0.0; };
  const std::vector<View> views{lookDown({21, 21, 0, 0}, holed), lookDown({13, 13, 4.4, 4.3}, flat(0.0))};
  const Integration first = integrateView({}, views, 0, {});
  EXPECT_EQ(measure(first.model.mesh).boundaryLoops, 2U);
  const Integration both = integrateView(first.model, views, 1, {});
  expectDisc(both.model.mesh);
  EXPECT_NEAR(area(both.model.mesh), 400.0, 1e-6);
}

TEST(Zipper, SurfaceAtAnotherDepthStaysApart) {
  const std::vector<View> views{lookDown({21, 21, 0, 0}, flat(0.0)), lookDown({21, 31, 5.5, 0}, flat(-9.0))};
  const Integration result = zipper(views, {});
  EXPECT_EQ(measure(result.model.mesh).components, 2U);
  EXPECT_EQ(result.statistics.seam, 0U);
}

TEST(Zipper, UndersideIsNotTakenForTheTop) {
  // A plate 0.3 mm thick, seen from above and from below.
  Pose fromBelow = Pose::Identity();
  fromBelow.rotate(Eigen::AngleAxisd(kPi, Vec3::UnitX()));
  const std::vector<View> views{lookDown({21, 21, 0, -10}, flat(0.0)),
                                lookDown({21, 21, 0, -10}, flat(0.3), fromBelow)};
  const Integration result = zipper(views, {});
  EXPECT_EQ(result.statistics.removedFromViews, 0U);
  EXPECT_EQ(result.statistics.removedFromModel, 0U);
  EXPECT_NEAR(area(result.model.mesh), 800.0, 1e-6);
}

TEST(Zipper, BetterViewReplacesSteepSurfaceFromTheBorderInwards) {
  // A slope of 55 degrees, and a scanner that looks at it squarely from near its upper end to beyond the lower.
  const double slope = std::tan(radians(55.0));
  const auto roof = [=](double x, double) { return x < 15.0 ? 0.0 : -slope * (x - 15.0); };
  Pose square = Pose::Identity();
  square.translate(Vec3(20, 10, -5 * slope));
  square.rotate(Eigen::AngleAxisd(radians(55.0), Vec3::UnitY()));
  const std::vector<View> views{lookDown({21, 26, 0, 0}, roof), lookDown({21, 22, -6, -10}, flat(0.0), square)};
  const Integration result = zipper(views, {});
  EXPECT_GT(result.statistics.removedFromModel, 50U);
  EXPECT_EQ(measure(result.model.mesh).components, 1U);
  EXPECT_EQ(measure(result.model.mesh).nonManifoldEdges, 0U);
}

TEST(Zipper, FlapThatABetterViewSeesThroughGoes) {
  // The first view's last columns bend up by 60 degrees, as the samples at a silhouette may; the second sees the plane.
  const auto bent = [](double x, double) { return x <= 17.0 ? 0.0 : std::tan(radians(58.0)) * (x - 17.0); };
  const std::vector<View> views{lookDown({21, 21, 0, 0}, bent), lookDown({31, 41, -5.4, -5.3}, flat(0.0))};
  ASSERT_GT(highest(views[0].mesh->mesh), 4.0);
  const Integration result = zipper(views, {});
  EXPECT_LT(highest(result.model.mesh), 1.7);
}

TEST(Zipper, ConfidenceRisesToTheBestViewOfAVertex) {
  const auto slope = [](double x, double) { return -x; };  // 45 degrees
  Pose square = Pose::Identity();
  square.rotate(Eigen::AngleAxisd(radians(20.0), Vec3::UnitY()));  // 25 degrees remain
  ZipperOptions keepModel;
  keepModel.confidenceMargin = 2.0;
  const auto seenFromThere = [](double x, double) { return -std::tan(radians(25.0)) * x; };
  const std::vector<View> views{lookDown({11, 11, 0, 0}, slope), lookDown({31, 51, -10, -10}, seenFromThere, square)};
  const Model model = zipper(views, keepModel).model;
  for (std::size_t v = 0; v < model.confidence.size(); ++v)
    EXPECT_NEAR(model.confidence[v], std::cos(radians(25.0)), 1e-3);
}

TEST(Zipper, RefusesWhatItCannotWorkWith) {
  const std::vector<View> views{lookDown({6, 8, 0, 0}, flat(2.0))};
  EXPECT_THROW((void)integrateView({}, views, 1, {}), InvalidInput);
  EXPECT_THROW((void)integrateView({}, std::vector<View>(1), 0, {}), InvalidInput);
  Model model = zipper(views, {}).model;
  model.vertexView[3] = 5;
  EXPECT_THROW((void)integrateView(model, views, 0, {}), InvalidInput);
  EXPECT_THROW((void)reposed(model, views), InvalidInput);
}

TEST(Zipper, EmptyViewChangesNothing) {
  const std::vector<View> views{lookDown({6, 8, 0, 0}, flat(2.0)), lookDown({6, 8, 0, 0}, flat(kNothing))};
  const Model first = integrateView({}, views, 0, {}).model;
  const Integration second = integrateView(first, views, 1, {});
  EXPECT_EQ(second.model.mesh.triangles, first.mesh.triangles);
  EXPECT_EQ(second.statistics.added, 0U);
}

TEST(Zipper, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const std::vector<View> views{lookDown({6, 8, 0, 0}, flat(2.0))};
  EXPECT_THROW((void)zipper(views, {}, Progress({}, stop.get_token(), 1)), Cancelled);
}

TEST(Zipper, CrumbsGoOnlyWhenNoMoreViewsCome) {
  const std::vector<View> views{lookDown({61, 61, 0, 0}, flat(0.0)), lookDown({3, 2, 80, 0}, flat(-9.0))};
  ZipperOptions last;
  last.minIslandTriangles = 0;
  EXPECT_EQ(measure(zipper(views, last).model.mesh).components, 2U);
  last.mend = true;
  const Integration mended = zipper(views, last);
  EXPECT_EQ(measure(mended.model.mesh).components, 1U);
  EXPECT_EQ(mended.statistics.islands, 4U);
}

}  // namespace
}  // namespace vantage
