#include "integration/colouring.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/errors.h"
#include "integration/view_witness.h"
#include "integration/zipper.h"
#include "scenes.h"
#include "support/coloured_scan.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::around;
using testing::differenceOf;
using testing::flat;
using testing::lookDown;
using testing::makeSphere;
using testing::paintAt;
using testing::scanFrom;

// The view with a colour for every sample, by its place in scanner coordinates.
View coloured(const View& view, const std::function<Colour(const Vec3&)>& paint) {
  RangeImage image = *view.image;
  for (std::size_t i = 0; i < image.range.size(); ++i)
    image.colours.push_back(image.valid(i) ? paint(image.point(i)) : Colour{});
  View result = view;
  result.image = std::make_shared<const RangeImage>(std::move(image));
  return result;
}

View inColour(const View& view, const Colour& colour) {
  return coloured(view, [&](const Vec3&) { return colour; });
}

std::vector<View> paintedSphere(int count) {
  std::vector<View> views = scanFrom(makeSphere(30.0, 60), around(count), 0.05);
  for (View& view : views) view.image = std::make_shared<const RangeImage>(testing::painted(*view.image));
  return views;
}

Model published(std::span<const View> views) {
  return applyConsensus(zipper(views, {}).model, views, {});
}

TEST(Colouring, OfOneViewIsThatOfItsSamples) {
  int next = 0;
  const View view = coloured(lookDown({11, 11, 0, 0}, flat(0.0)), [&](const Vec3&) {
    ++next;
    return Colour{static_cast<std::uint8_t>(next * 37), static_cast<std::uint8_t>(next * 91), 255};
  });
  const std::vector<View> views{view};
  const Model model = published(views);
  const VertexColours colours = colourVertices(model, views, {});
  ASSERT_EQ(colours.size(), 121U);
  for (std::size_t v = 0; v < colours.size(); ++v) EXPECT_EQ(colours[v], view.image->colours[model.vertexSample[v]]);
}

TEST(Colouring, LiesBetweenTheSamplesAroundAVertex) {
  // The model's vertices lie in the middle of the second view's cells, which alone saw colours.
  const std::vector<View> views{lookDown({41, 41, 0, 0}, flat(0.0)),
                                coloured(lookDown({41, 41, 0.5, 0.5}, flat(0.0)), [](const Vec3& p) {
                                  return Colour{static_cast<std::uint8_t>(std::lround(6.0 * p.x())),
                                                static_cast<std::uint8_t>(std::lround(4.0 * p.y())), 9};
                                })};
  const Model model = applyConsensus(integrateView({}, views, 0, {}).model, views, {});
  const VertexColours colours = colourVertices(model, views, {});
  int asked = 0;
  for (std::size_t v = 0; v < colours.size(); ++v) {
    const Vec3& p = model.mesh.vertices[v];
    if (p.x() < 1.0 || p.y() < 1.0) continue;  // beside the second view
    ASSERT_TRUE(colours[v]) << p.transpose();
    EXPECT_NEAR((*colours[v])[0], 6.0 * p.x(), 0.51);
    EXPECT_NEAR((*colours[v])[1], 4.0 * p.y(), 0.51);
    EXPECT_EQ((*colours[v])[2], 9);
    ++asked;
  }
  EXPECT_EQ(asked, 40 * 40);
}

TEST(Colouring, AveragesAsTheConsensusDoes) {
  const std::vector<View> views{inColour(lookDown({41, 41, 0, 0}, flat(0.2)), {200, 0, 50}),
                                inColour(lookDown({41, 41, 0.5, 0.5}, flat(-0.2)), {100, 0, 150})};
  const Model model = applyConsensus(integrateView({}, views, 0, {}).model, views, {});
  // The published surface lies 0.144 mm below the first view and 0.256 mm above the second one (see the consensus); the
  // limit is 0.8 mm.
  const auto fade = [](double excess) { return (1.0 - excess * excess) * (1.0 - excess * excess); };
  const double share = fade(0.144 / 0.8) / (fade(0.144 / 0.8) + fade(0.256 / 0.8));
  const VertexColours colours = colourVertices(model, views, {});
  for (std::size_t v = 0; v < colours.size(); ++v) {
    const Vec3& p = model.mesh.vertices[v];
    if (std::abs(p.x() - 20.0) > 10.0 || std::abs(p.y() - 20.0) > 10.0) continue;  // where views fade
    ASSERT_TRUE(colours[v]);
    EXPECT_NEAR((*colours[v])[0], 100.0 + 100.0 * share, 0.51);
    EXPECT_NEAR((*colours[v])[2], 150.0 - 100.0 * share, 0.51);
  }
}

TEST(Colouring, IsThereOnlyWhereAScanWithColoursSawTheSurface) {
  const Colour red{200, 10, 10};
  const std::vector<View> views{lookDown({21, 31, 0, 0}, flat(0.0)),
                                inColour(lookDown({21, 31, 20.3, 0}, flat(0.0)), red)};
  EXPECT_TRUE(haveColours(views));
  const Model model = published(views);
  const VertexColours colours = colourVertices(model, views, {});
  std::size_t without = 0;
  for (std::size_t v = 0; v < colours.size(); ++v) {
    const double x = model.mesh.vertices[v].x();
    without += colours[v] ? 0 : 1;
    if (x < 19.5) {
      EXPECT_FALSE(colours[v]) << x;
    }
    if (x > 20.5) {
      EXPECT_EQ(colours[v], red) << x;
    }
  }
  EXPECT_EQ(countColourless(colours), without);
  EXPECT_GE(without, 20U * 20U);
}

TEST(Colouring, ThereIsNoneWithoutScansInColour) {
  const std::vector<View> views{lookDown({21, 31, 0, 0}, flat(0.0))};
  EXPECT_FALSE(haveColours(views));
  EXPECT_TRUE(colourVertices(published(views), views, {}).empty());
}

TEST(Colouring, OfAVertexOfWhichNoViewSaysAnythingIsThatOfItsSample) {
  const Colour green{10, 200, 30};
  const std::vector<View> views{inColour(lookDown({11, 11, 0, 0}, flat(0.0)), green)};
  Model model = published(views);
  for (Vec3& p : model.mesh.vertices) p.z() += 5.0;
  EXPECT_EQ(colourVertices(model, views, {}), VertexColours(121, green));
}

TEST(Colouring, FollowsThePaintThroughZipperingAndConsensus) {
  const std::vector<View> views = paintedSphere(6);
  const Model model = published(views);
  const VertexColours colours = colourVertices(model, views, {});
  ASSERT_EQ(colours.size(), model.mesh.vertices.size());
  int most = 0;
  for (std::size_t v = 0; v < colours.size(); ++v) {
    ASSERT_TRUE(colours[v]);
    most = std::max(most, differenceOf(*colours[v], paintAt(model.mesh.vertices[v])));
  }
  // 1.5 a millimetre, of which noise and interpolation leave a few tenths, and rounding twice.
  EXPECT_LE(most, 2);
}

TEST(Colouring, LeavesTheGeometryAsItIs) {
  const std::vector<View> painted = paintedSphere(3);
  std::vector<View> plain = painted;
  for (View& view : plain) {
    RangeImage image = *view.image;
    image.colours.clear();
    view.image = std::make_shared<const RangeImage>(std::move(image));
  }
  const Model one = published(plain);
  const Model other = published(painted);
  EXPECT_EQ(one.mesh.vertices, other.mesh.vertices);
  EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
}

TEST(Colouring, NumberOfThreadsChangesNothing) {
  const std::vector<View> views = paintedSphere(4);
  const Model model = published(views);
  EXPECT_EQ(colourVertices(model, views, {}, Progress({}, {}, 1)),
            colourVertices(model, views, {}, Progress({}, {}, 3)));
}

TEST(Colouring, RefusesAModelOfOtherViews) {
  const std::vector<View> views = paintedSphere(2);
  Model model = published(views);
  model.vertexView[5] = 7;
  EXPECT_THROW((void)colourVertices(model, views, {}), InvalidInput);
}

TEST(Colouring, StopsWhenAsked) {
  const std::vector<View> views = paintedSphere(2);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)colourVertices(published(views), views, {}, Progress({}, stop.get_token(), 1)), Cancelled);
}

TEST(ViewWitness, SaysWhereItsSurfaceLiesAndWhatItCounts) {
  const ViewWitness witness(lookDown({41, 41, 0, 0}, flat(0.2)), {});
  std::optional<GridPosition> hint;
  const Opinion opinion = witness.ask({20.25, 20.5, 0.0}, Vec3::UnitZ(), hint);
  EXPECT_NEAR(opinion.offset, 0.2, 1e-5);
  EXPECT_NEAR(opinion.weight, std::pow(1.0 - std::pow(0.2 / 0.8, 2.0), 2.0), 1e-4);
  EXPECT_NEAR(opinion.contact.weights[0] + opinion.contact.weights[1] + opinion.contact.weights[2], 1.0, 1e-12);
  EXPECT_EQ(witness.ask({20.25, 20.5, 0.0}, -Vec3::UnitZ(), hint).weight, 0.0);
}

}  // namespace
}  // namespace vantage
