#include "void_space/edge_classification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::makePlate;
using testing::makeStep;
using testing::modelOf;
using testing::parallelScanner;
using testing::scanView;

constexpr std::uint32_t kFirst = 0;

// One view, the model it makes, and its verdict on vertical edges.
class Scene {
 public:
  explicit Scene(const View& view, const ClassificationOptions& options = {})
      : Scene(std::vector<View>{view}, modelOf(view).mesh, options) {}
  Scene(std::vector<View> views, const Mesh& model, const ClassificationOptions& options = {})
      : views_(std::move(views)), model_(model), rays_(views_), classifier_(model_, rays_, options) {}

  // By the ray through the edge's middle.
  [[nodiscard]] EdgeVerdict verdict(const EdgeFrame& e, std::uint32_t view = kFirst) const {
    return classifier_.classify(e, passage(e, view), true);
  }
  [[nodiscard]] bool sees(const EdgeFrame& e, std::uint32_t view = kFirst) const {
    return classifier_.sees(e, passage(e, view));
  }
  [[nodiscard]] bool measured(const EdgeFrame& e, std::uint32_t view = kFirst) const {
    return classifier_.measured(e, passage(e, view));
  }

 private:
  [[nodiscard]] RayPassage passage(const EdgeFrame& e, std::uint32_t view) const {
    return rays_.through(view, e.middle).value();
  }

  std::vector<View> views_;
  RayCaster model_;
  RayIndex rays_;
  EdgeClassifier classifier_;
};

// Vertical edges, 1 mm long, of a surface that faces +x and lies at smaller or at larger y.
EdgeFrame rightEnd(double x, double y) {
  return makeEdgeFrame({x, y, 50}, {x, y, 51}, {1, 0, 0});
}
EdgeFrame leftEnd(double x, double y) {
  return makeEdgeFrame({x, y, 51}, {x, y, 50}, {1, 0, 0});
}

double voidDegrees(const EdgeVerdict& verdict) {
  return degrees(verdict.freeSpace.voidAngle().angle);
}

TEST(EdgeClassifier, NearEndOfAStepIsAnOuterJump) {
  const EdgeVerdict verdict = Scene(scanView(makeStep(), parallelScanner())).verdict(rightEnd(20, 0));
  EXPECT_EQ(verdict.edgeClass, EdgeClass::OuterJump);
  EXPECT_NEAR(degrees(verdict.rho), 90.0, 1e-6);
  EXPECT_NEAR(voidDegrees(verdict), 270.0, 1e-6);
}

TEST(EdgeClassifier, FarEndOfAStepIsAnInnerJump) {
  const EdgeVerdict verdict = Scene(scanView(makeStep(), parallelScanner())).verdict(leftEnd(-20, 1));
  EXPECT_EQ(verdict.edgeClass, EdgeClass::InnerJump);
  EXPECT_NEAR(voidDegrees(verdict), 90.0, 1e-6);
}

TEST(EdgeClassifier, ReceiverBehindTheStepMakesALineOfSightJump) {
  // The receiver of the ray at y is at (300, y - 100): it sees the far plate past the near one from y = 12.501 on.
  const Scene scene(scanView(makeStep(), parallelScanner("[-100, 0, 0]")));
  const EdgeVerdict verdict = scene.verdict(leftEnd(-20, 13));
  EXPECT_EQ(verdict.edgeClass, EdgeClass::LineOfSightJump);
  EXPECT_NEAR(voidDegrees(verdict), degrees(std::atan2(320.0, -100.0)), 1e-6);
  const EdgeVerdict near = scene.verdict(rightEnd(20, 0));
  EXPECT_EQ(near.edgeClass, EdgeClass::Regular) << "what lies beside the near plate was not sampled";
}

TEST(EdgeClassifier, ReceiverOnTheOpenSideChangesNothing) {
  const Scene scene(scanView(makeStep(), parallelScanner("[100, 0, 0]")));
  EXPECT_EQ(scene.verdict(rightEnd(20, 0)).edgeClass, EdgeClass::OuterJump);
  EXPECT_EQ(scene.verdict(leftEnd(-20, 1)).edgeClass, EdgeClass::InnerJump);
}

TEST(EdgeClassifier, LineOfSightJumpToTheOtherSideIsItsMirrorImage) {
  // The near plate stands at y > 0 between the far one and a receiver at (300, y + 100).
  const Mesh step = testing::joined(makePlate(20, -0.001, 24.5), makePlate(-20, -24.5, 24.5));
  const Scene scene(scanView(step, parallelScanner("[100, 0, 0]")));
  const EdgeVerdict verdict = scene.verdict(rightEnd(-20, -13));
  EXPECT_EQ(verdict.edgeClass, EdgeClass::LineOfSightJump);
  EXPECT_NEAR(voidDegrees(verdict), degrees(std::atan2(320.0, -100.0)), 1e-6);
}

TEST(EdgeClassifier, EndOfAPlateIsRegular) {
  const EdgeVerdict verdict = Scene(scanView(makePlate(0, -25, 10.5), parallelScanner())).verdict(rightEnd(0, 10));
  EXPECT_EQ(verdict.edgeClass, EdgeClass::Regular);
  EXPECT_NEAR(voidDegrees(verdict), 240.0, 1e-6) << "rho + pi/2 + theta_b";
  EXPECT_TRUE(verdict.freeSpace.voidAngle().bridged);
}

TEST(EdgeClassifier, EndOfTheSamplingAreaIsARim) {
  const EdgeVerdict verdict = Scene(scanView(makePlate(0, -50, 50), parallelScanner())).verdict(rightEnd(0, 30));
  EXPECT_EQ(verdict.edgeClass, EdgeClass::Rim);
  EXPECT_NEAR(voidDegrees(verdict), 90.0, 1e-6);
}

TEST(EdgeClassifier, SurfaceThatGoesOnIsRegularUpToIt) {
  // An edge in the middle of the plate, as where triangles were lost. The surface beside it is flat.
  const EdgeVerdict flat = Scene(scanView(makePlate(0, -25, 25), parallelScanner())).verdict(rightEnd(0, 10));
  EXPECT_EQ(flat.edgeClass, EdgeClass::Regular);
  EXPECT_NEAR(voidDegrees(flat), 180.0, 1e-3);
  // One spacing on the surface is one spacing nearer: 45 degrees toward the scanner.
  const EdgeVerdict rising = Scene(scanView(makePlate(0, -25, 25), parallelScanner())).verdict(rightEnd(-1, 10));
  EXPECT_NEAR(voidDegrees(rising), 135.0, 1e-3);
}

TEST(EdgeClassifier, RangeImageKnowsAJumpWhereTheModelLostItsTriangles) {
  const View view = scanView(makeStep(), parallelScanner());
  const Scene scene({view}, makePlate(20, -24, 0));
  EXPECT_EQ(scene.verdict(rightEnd(20, 0)).edgeClass, EdgeClass::OuterJump);
}

TEST(EdgeClassifier, ModelKnowsTheOccluderWhereTheImageHasAHole) {
  const View full = scanView(makeStep(), parallelScanner());
  const View hole = testing::without(full, [](const Vec3& p) { return p.x() > 0.0 && p.y() > -6.5; });
  EXPECT_EQ(Scene({hole}, modelOf(full).mesh).verdict(leftEnd(-20, 1)).edgeClass, EdgeClass::InnerJump);
}

TEST(EdgeClassifier, FartherSurfaceThatTheViewDidNotSampleIsNoOuterJump) {
  // The model knows the far plate from elsewhere, but the view saw nothing of it: something unseen is in the way.
  const View full = scanView(makeStep(), parallelScanner());
  const View nearOnly = testing::without(full, [](const Vec3& p) { return p.x() < 0.0; });
  EXPECT_EQ(Scene({nearOnly}, modelOf(full).mesh).verdict(rightEnd(20, 0)).edgeClass, EdgeClass::Regular);
  // A single lost sample is no such evidence.
  const View dropout = testing::without(
      full, [](const Vec3& p) { return p.x() < 0.0 && std::abs(p.y() - 1) < 0.1 && std::abs(p.z() - 51) < 0.6; });
  EXPECT_EQ(Scene({dropout}, modelOf(full).mesh).verdict(rightEnd(20, 0)).edgeClass, EdgeClass::OuterJump);
}

TEST(EdgeClassifier, ShadowBeginsBeyondTheUnsampledRimOfTheOccluder) {
  const View view = testing::without(scanView(makeStep(), parallelScanner()),
                                     [](const Vec3& p) { return p.x() > 0.0 && p.y() > -1.5; });
  EXPECT_EQ(Scene(view).verdict(leftEnd(-20, 1)).edgeClass, EdgeClass::InnerJump);
  ClassificationOptions near;
  near.shadowReach = 1;
  EXPECT_EQ(Scene(view, near).verdict(leftEnd(-20, 1)).edgeClass, EdgeClass::Regular);
}

TEST(EdgeClassifier, EdgeAlongTheDepthOfALimbContinuesFlat) {
  // Surface that leans by 60 degrees about z, cut by an edge that runs up the slope: the ray samples no other surface
  // through it than the flat continuation, whatever its 60 degrees look like in the plane across the edge.
  const Vec3 slope(-std::sin(radians(60)), std::cos(radians(60)), 0.0);
  const Vec3 normal(std::cos(radians(60)), std::sin(radians(60)), 0.0);
  const EdgeFrame e = makeEdgeFrame(Vec3(0, 0, 50), Vec3(0, 0, 50) + slope, normal);
  const View nothing =
      testing::without(scanView(makePlate(0, -25, 25), parallelScanner()), [](const Vec3&) { return true; });
  const EdgeVerdict verdict = Scene({nothing}, Mesh{}).verdict(e);
  EXPECT_EQ(verdict.edgeClass, EdgeClass::Regular);
  EXPECT_NEAR(voidDegrees(verdict), 180.0, 0.1);
}

TEST(EdgeClassifier, SeesAnEdgeThatNothingHides) {
  const Scene scene(scanView(makeStep(), parallelScanner("[-100, 0, 0]")));
  EXPECT_TRUE(scene.sees(rightEnd(20, 0)));
  EXPECT_TRUE(scene.sees(leftEnd(-20, 13)));
  EXPECT_FALSE(scene.sees(leftEnd(-20, -5))) << "behind the near plate";
  EXPECT_FALSE(scene.sees(leftEnd(-20, 5))) << "no line of sight";
}

TEST(EdgeClassifier, DoesNotSeeAlongAnEdge) {
  const Scene scene(scanView(makePlate(0, -25, 25), parallelScanner()));
  const Vec3 from(0, 0, 50);
  const auto leaning = [&](double angle) {
    return makeEdgeFrame(from, from + Vec3(std::cos(radians(angle)), std::sin(radians(angle)), 0), {0, 0, 1});
  };
  EXPECT_TRUE(scene.sees(leaning(32))) << "a surface through it can face the scanner by 58 degrees";
  EXPECT_FALSE(scene.sees(leaning(28))) << "none faces it by less than 62 degrees";
}

TEST(EdgeClassifier, MeasuredMeansASampleAtTheEdgeSeenFromTheFront) {
  const Scene scene(scanView(makePlate(0, -25, 25), parallelScanner()));
  EXPECT_TRUE(scene.measured(rightEnd(0, 10)));
  EXPECT_TRUE(scene.measured(rightEnd(1, 10)));
  EXPECT_FALSE(scene.measured(rightEnd(5, 10))) << "the sample lies 5 mm behind";
  EXPECT_FALSE(scene.measured(rightEnd(-5, 10))) << "the sample lies 5 mm in front";
  EXPECT_FALSE(scene.measured(makeEdgeFrame({0, 10, 50}, {0, 10, 51}, {-1, 0, 0}))) << "from behind";
}

}  // namespace
}  // namespace vantage
