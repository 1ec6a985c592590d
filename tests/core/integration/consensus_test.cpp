#include "integration/consensus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "integration/zipper.h"
#include "scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

using testing::around;
using testing::flat;
using testing::Height;
using testing::lookDown;
using testing::makeSphere;
using testing::scanFrom;

// Farthest that a vertex is from the height, of those around the middle of a 41 x 41 window where views do not fade.
double deviationInside(const Model& model, double z) {
  double worst = 0.0;
  for (const Vec3& p : model.mesh.vertices)
    if (std::abs(p.x() - 20.0) < 10.0 && std::abs(p.y() - 20.0) < 10.0) worst = std::max(worst, std::abs(p.z() - z));
  return worst;
}

TEST(Consensus, AveragesByTheFormula) {
  const std::vector<View> views{lookDown({41, 41, 0, 0}, flat(0.2)), lookDown({41, 41, 0.5, 0.5}, flat(-0.2))};
  const Model model = integrateView({}, views, 0, {}).model;
  // The limit is 0.8 spacings of 1 mm; the second view is off by half of it and counts (1 - 1/4)^2.
  const double weight = 0.5625;
  EXPECT_LT(deviationInside(applyConsensus(model, views, {}), 0.2 - 0.4 * weight / (1.0 + weight)), 1e-5);
}

TEST(Consensus, ViewCountsByItsConfidence) {
  // The second view sees the same plane at 60 degrees, but 0.1 mm too high: half the weight.
  Pose oblique = Pose::Identity();
  oblique.translate(Vec3(20, 20, 0));
  oblique.rotate(Eigen::AngleAxisd(radians(60.0), Vec3::UnitY()));
  const auto tilted = [](double x, double) { return std::tan(radians(60.0)) * x + 0.1 / std::cos(radians(60.0)); };
  const std::vector<View> views{lookDown({41, 41, 0, 0}, flat(0.0)), lookDown({81, 41, -20, -40}, tilted, oblique)};
  const Model model = integrateView({}, views, 0, {}).model;
  const Model result = applyConsensus(model, views, {});
  const double fade = std::pow(1.0 - std::pow(0.1 / 0.8, 2.0), 2.0);
  EXPECT_LT(deviationInside(result, 0.1 * 0.5 * fade / (1.0 + 0.5 * fade)), 1e-4);
  EXPECT_NEAR(*std::min_element(result.confidence.begin(), result.confidence.end()), 1.0, 1e-4);
}

TEST(Consensus, SurfaceBeyondTheLimitHasNoSay) {
  const std::vector<View> views{lookDown({41, 41, 0, 0}, flat(0.0)), lookDown({41, 41, 0.5, 0.5}, flat(-0.9))};
  const Model model = integrateView({}, views, 0, {}).model;
  EXPECT_LT(deviationInside(applyConsensus(model, views, {}), 0.0), 1e-5);
}

TEST(Consensus, UndersideOfAThinPlateHasNoSay) {
  Pose fromBelow = Pose::Identity();
  fromBelow.rotate(Eigen::AngleAxisd(kPi, Vec3::UnitX()));
  const std::vector<View> views{lookDown({41, 41, 0, 0}, flat(0.0)), lookDown({41, 41, 0, -40}, flat(0.3), fromBelow)};
  const Model model = integrateView({}, views, 0, {}).model;
  EXPECT_LT(deviationInside(applyConsensus(model, views, {}), 0.0), 1e-5);
}

TEST(Consensus, KeepsTopologyAndProvenance) {
  const std::vector<View> views = scanFrom(makeSphere(30.0, 60), around(6), 0.1);
  const Model model = zipper(views, {}).model;
  const Model result = applyConsensus(model, views, {});
  EXPECT_EQ(result.mesh.triangles, model.mesh.triangles);
  EXPECT_EQ(result.vertexView, model.vertexView);
  EXPECT_EQ(result.vertexSample, model.vertexSample);
  EXPECT_EQ(result.triangleView, model.triangleView);
}

TEST(Consensus, NoiseAveragesOut) {
  const std::vector<View> views = scanFrom(makeSphere(30.0, 60), around(12), 0.1);
  const Model model = zipper(views, {}).model;
  const auto rms = [](const Model& m) {
    double sum = 0.0;
    for (const Vec3& v : m.mesh.vertices) sum += std::pow(v.norm() - 30.0, 2.0);
    return std::sqrt(sum / static_cast<double>(m.mesh.vertices.size()));
  };
  // Away from the poles about four views see a vertex.
  EXPECT_GT(rms(model), 0.07);
  EXPECT_LT(rms(applyConsensus(model, views, {})), 0.6 * rms(model));
}

TEST(Consensus, NumberOfThreadsChangesNothing) {
  const std::vector<View> views = scanFrom(makeSphere(30.0, 60), around(4), 0.1);
  const Model model = zipper(views, {}).model;
  EXPECT_EQ(applyConsensus(model, views, {}, Progress({}, {}, 1)).mesh.vertices,
            applyConsensus(model, views, {}, Progress({}, {}, 3)).mesh.vertices);
}

TEST(Consensus, RefusesAViewWithoutMesh) {
  EXPECT_THROW((void)applyConsensus({}, std::vector<View>(1), {}), InvalidInput);
}

}  // namespace
}  // namespace vantage
