#include "planning/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"
#include "core/planning/scenes.h"
#include "forecast/forecast_ledger.h"
#include "geometry/measures.h"
#include "planning/choice.h"
#include "planning/planner_options.h"
#include "planning/position_sight.h"

namespace vantage {
namespace {

const testing::ScannedObject& object() {
  static const testing::ScannedObject scanned({0, 5});
  return scanned;
}

const ScannerImages& images() {
  static const ScannerImages computed = computeScannerImages(*object().profile);
  return computed;
}

Plan planOf(const PlanInput& input, const PlannerOptions& options = {}, const Progress& progress = {}) {
  return planNextView(input, images(), options, progress);
}

// The object and its views, moved in the object's frame.
PlanInput moved(PlanInput input, const Pose& motion) {
  Model model = *input.model;
  model.mesh = transformed(model.mesh, motion);
  input.model = std::make_shared<const Model>(std::move(model));
  for (View& view : input.views) view.T_object_scanner = motion * view.T_object_scanner;
  return input;
}

void expectSame(double a, double b, const PositionScore& score) {
  EXPECT_NEAR(a, b, 1e-6 * std::max(1.0, std::abs(b))) << "position " << score.position;
}

// As the paper plans: the voxels of a forecast lie in the object's frame, and turn with it.
PlannerOptions byPatches() {
  PlannerOptions options;
  options.forecast = false;
  return options;
}

PlannerOptions forecasting() {
  PlannerOptions options;
  options.forecast = true;
  return options;
}

// What the planner says of a view that is then taken, against what the view shows. Of two views of three spheres that
// is little to go by: patches alone promise less than a tenth of it.
TEST(Planner, ForecastsTheSurfaceThatAViewShows) {
  const Plan plan = planOf(object().input(), forecasting());
  ASSERT_EQ(plan.outcome, PlanOutcome::Found);
  ASSERT_TRUE(plan.forecast.has_value());
  const PositionScore& chosen = plan.scores[static_cast<std::size_t>(*plan.position)];
  const double before = area(object().model->mesh);
  const testing::ScannedObject with({0, 5, *plan.position});
  const double shown = area(with.model->mesh) - before;
  ASSERT_GT(shown, 0.0);
  EXPECT_GT(promise(chosen), 0.15 * shown);
  EXPECT_LT(promise(chosen), 2.5 * shown);
}

TEST(Planner, TheLedgerCorrectsAForecast) {
  PlanInput input = object().input();
  const Plan first = planOf(input, forecasting());
  const double spacing = 0.5 * (input.views[0].mesh->spacing + input.views[1].mesh->spacing);
  input.ledger.assign(4, {1e6, 0.5e6});
  const Plan later = planOf(input, forecasting());
  ASSERT_TRUE(later.forecast.has_value());
  EXPECT_EQ(later.forecast->trust.factor, trustIn(input.ledger, spacing, forecasting().ledger).factor);
  EXPECT_LT(later.forecast->trust.factor, first.forecast->trust.factor);
  for (std::size_t i = 0; i < first.scores.size(); ++i) {
    const double uncorrected = first.scores[i].voidArea / first.forecast->trust.factor;
    EXPECT_NEAR(later.scores[i].voidArea, later.forecast->trust.factor * uncorrected, 0.01 + 1e-3 * uncorrected) << i;
    ASSERT_TRUE(later.scores[i].uncorrected.has_value());
    EXPECT_NEAR(*later.scores[i].uncorrected * later.forecast->trust.factor, promise(later.scores[i]), 1e-6);
  }
}

TEST(Planner, AForecastThatIsNotWorthAViewSaysWhatIsLeft) {
  PlannerOptions options = forecasting();
  options.termination.threshold = 1e9;
  const Plan plan = planOf(object().input(), options);
  EXPECT_EQ(plan.outcome, PlanOutcome::Finished);
  ASSERT_TRUE(plan.forecast && plan.forecast->left);
  const SurfaceLeft& left = *plan.forecast->left;
  double most = 0.0;
  for (const PositionScore& score : plan.scores) most = std::max(most, score.voidArea);
  EXPECT_GE(left.area, 0.9 * most);
  EXPECT_LE(left.least, left.area);
  EXPECT_GE(left.most, left.area);
  EXPECT_EQ(plan.voidLeft, left.area);
}

// After a view that showed more than F one more is tried from where most is forecast, after one that did not none.
TEST(Planner, ProbesBeforeItBelievesItsOwnPrediction) {
  PlannerOptions options = forecasting();
  const Plan plan = planOf(object().input(), options);
  double best = 0.0;
  for (const PositionScore& score : plan.scores) best = std::max(best, promise(score));
  options.probeShare = 0.01;
  PlanInput input = object().input();
  input.ledger = {{0.0, 1e6}};  // it says nothing of the factor
  options.termination.threshold = 1.5 * best;
  const Plan probing = planOf(input, options);
  ASSERT_EQ(probing.outcome, PlanOutcome::Found);
  EXPECT_TRUE(probing.forecast->probing);
  EXPECT_EQ(probing.position, plan.position);
  EXPECT_EQ(probing.terminationThreshold, 1.5 * best);
  input.ledger = {{0.0, best}};
  EXPECT_EQ(planOf(input, options).outcome, PlanOutcome::Finished);
  options.probeShare = 1.0;
  input.ledger = {{0.0, 1e6}};
  EXPECT_EQ(planOf(input, options).outcome, PlanOutcome::Finished);
}

TEST(Planner, AForecastIsTheSameForAnyNumberOfThreads) {
  const Plan one = planOf(object().input(), forecasting());
  const Plan four = planOf(object().input(), forecasting(), Progress().withThreads(4));
  EXPECT_EQ(one.position, four.position);
  for (std::size_t i = 0; i < one.scores.size(); ++i) {
    EXPECT_EQ(one.scores[i].voidArea, four.scores[i].voidArea);
    EXPECT_EQ(one.scores[i].uncorrected, four.scores[i].uncorrected);
  }
}

TEST(Planner, ChoosesWhatPromisesMostOfAllPositionsThatAreAllowed) {
  const Plan plan = planOf(object().input());
  ASSERT_EQ(plan.outcome, PlanOutcome::Found);
  ASSERT_TRUE(plan.position.has_value());
  const PositionScore& chosen = plan.scores[static_cast<std::size_t>(*plan.position)];
  EXPECT_EQ(chosen.constraint, Constraint::Chosen);
  EXPECT_TRUE(chosen.tracedVoidArea.has_value());
  EXPECT_TRUE(chosen.poseSigma.has_value());
  EXPECT_GT(promise(chosen), plan.terminationThreshold);
  EXPECT_GT(chosen.overlapArea, plan.leastOverlap);
  for (const PositionScore& score : plan.scores) {
    if (score.constraint == Constraint::Outscored) {
      EXPECT_LE(promise(score), promise(chosen)) << "position " << score.position;
    }
  }
}

TEST(Planner, PromisesNothingOfAPositionThatWasTaken) {
  const Plan plan = planOf(object().input());
  EXPECT_EQ(plan.scores[0].voidArea, 0.0);
  EXPECT_EQ(plan.scores[5].voidArea, 0.0);
  EXPECT_GT(plan.scores[0].overlapArea, 0.0);
}

TEST(Planner, FinishesWhereNothingPromisesMoreThanTheThresholdAndSaysWhyEveryEdgeIsLeft) {
  PlannerOptions options = byPatches();
  options.termination.threshold = 1e6;
  const Plan plan = planOf(object().input(), options);
  EXPECT_EQ(plan.outcome, PlanOutcome::Finished);
  EXPECT_EQ(plan.position, std::nullopt);
  ASSERT_EQ(plan.outlook.size(), plan.voids->patches.size());
  double left = 0.0;
  for (const PatchOutlook& outlook : plan.outlook) left += outlook.promise;
  EXPECT_GT(left, 0.0);
  EXPECT_DOUBLE_EQ(plan.voidLeft, left);
}

TEST(Planner, FindsNoOverlapWhereNoneIsEnoughHoweverRelaxed) {
  PlannerOptions options;
  options.leastOverlap = 1e9;
  options.maxRelaxations = 2;
  options.tableAloneShare = 1.0;
  const Plan plan = planOf(object().input(), options);
  EXPECT_EQ(plan.outcome, PlanOutcome::NoOverlap);
  EXPECT_EQ(plan.position, std::nullopt);
  EXPECT_EQ(plan.relaxations, 2);
}

TEST(Planner, SendsTheTableWhereNothingOverlapsEnough) {
  PlannerOptions options;
  options.leastOverlap = 1e9;
  const Plan plan = planOf(object().input(), options);
  ASSERT_EQ(plan.outcome, PlanOutcome::Found);
  EXPECT_TRUE(plan.tableAlone);
  const auto most = std::max_element(plan.scores.begin(), plan.scores.end(),
                                     [](const auto& a, const auto& b) { return promise(a) < promise(b); });
  EXPECT_EQ(plan.position, most->position);
  EXPECT_FALSE(planOf(object().input(), {}).tableAlone);
}

TEST(Planner, GivesTheSameForAnyNumberOfThreads) {
  const Plan one = planOf(object().input(), {}, Progress().withThreads(1));
  const Plan four = planOf(object().input(), {}, Progress().withThreads(4));
  EXPECT_EQ(one.position, four.position);
  for (std::size_t i = 0; i < one.scores.size(); ++i) {
    EXPECT_EQ(one.scores[i].voidArea, four.scores[i].voidArea);
    EXPECT_EQ(one.scores[i].overlapArea, four.scores[i].overlapArea);
    EXPECT_EQ(one.scores[i].tracedVoidArea, four.scores[i].tracedVoidArea);
    EXPECT_EQ(one.scores[i].poseSigma, four.scores[i].poseSigma);
  }
}

TEST(Planner, ChoosesTheSameHoweverTheObjectsFrameLies) {
  const Pose motion = Eigen::Translation3d(3.0, -2.0, 7.0) * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());
  PlanInput input = moved(object().input(), motion);
  input.T_object_table = motion;
  const Plan plain = planOf(object().input(), byPatches());
  const Plan turned = planOf(input, byPatches());
  EXPECT_EQ(turned.position, plain.position);
  ASSERT_EQ(turned.scores.size(), plain.scores.size());
  for (std::size_t i = 0; i < plain.scores.size(); ++i) {
    const PositionScore& score = plain.scores[i];
    expectSame(turned.scores[i].voidArea, score.voidArea, score);
    expectSame(turned.scores[i].overlapArea, score.overlapArea, score);
    ASSERT_EQ(turned.scores[i].tracedVoidArea.has_value(), score.tracedVoidArea.has_value());
    expectSame(turned.scores[i].tracedVoidArea.value_or(0.0), score.tracedVoidArea.value_or(0.0), score);
    expectSame(turned.scores[i].poseSigma.value_or(0.0), score.poseSigma.value_or(0.0), score);
  }
  for (std::size_t p = 0; p < plain.voids->patches.size(); ++p)
    EXPECT_TRUE(turned.voids->patches[p].centre.isApprox(motion * plain.voids->patches[p].centre, 1e-9));
}

// Another stand: the object is turned by half a turn on the table, so that position i sees it as i + 12 did.
TEST(Planner, OfAnotherStandRulesOutNoPositionThatWasTakenInTheFirst) {
  PlanInput input = object().input();
  input.T_object_table = Pose(Eigen::AngleAxisd(kPi, Vec3::UnitZ()));
  input.taken.clear();
  const Plan other = planOf(input, byPatches());
  const Plan first = planOf(object().input(), byPatches());
  EXPECT_GT(other.scores[0].voidArea, 0.0);
  for (std::size_t i = 0; i < 24; ++i) {
    const std::size_t same = (i + 12) % 24;
    if (same == 0 || same == 5) continue;  // taken in the first
    EXPECT_NEAR(other.scores[i].voidArea, first.scores[same].voidArea, 0.01 * first.scores[same].voidArea + 0.1) << i;
    EXPECT_NEAR(other.scores[i].overlapArea, first.scores[same].overlapArea,
                0.01 * first.scores[same].overlapArea + 0.1);
  }
  input.taken = {0};
  EXPECT_EQ(planOf(input, byPatches()).scores[0].voidArea, 0.0);
}

// Obstacles are decimated here: what explains the plan must see the same ones.
TEST(Planner, IsExplainedByWhatItWasMadeWith) {
  PlannerOptions options;
  options.tracedTriangles = object().model->mesh.triangles.size() - 1;
  options.planningError = 0.05;
  const Plan plan = planOf(object().input(), options);
  const PlanningScene scene(object().input(), plan.voids, options, {});
  EXPECT_LT(scene.surface().triangles.size(), object().model->mesh.triangles.size());
  int traced = 0;
  for (const PositionScore& score : plan.scores) {
    if (!score.tracedVoidArea) continue;
    ++traced;
    const PositionSight sight = computePositionSight(scene, score.position, {});
    for (const std::uint32_t p : score.patches) EXPECT_EQ(sight.patches[p].visibility, Visibility::Seen);
  }
  EXPECT_GT(traced, 0);
}

TEST(Planner, NeedsAView) {
  PlanInput input = object().input();
  input.views.clear();
  EXPECT_THROW((void)planOf(input), InvalidInput);
}

}  // namespace
}  // namespace vantage
