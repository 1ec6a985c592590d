#include "acquisition/acquisition.h"

#include <gtest/gtest.h>

#include "acquisition/memory_journal.h"
#include "base/errors.h"
#include "geometry/measures.h"
#include "report/evaluation.h"
#include "report/report.h"
#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

using testing::acquireSmallObject;

// Everything but what depends on the machine.
nlohmann::ordered_json reportWithoutMachine(const AcquisitionState& state) {
  auto report = makeReport(state, "test");
  report.erase("peak_memory_mb");
  for (auto& view : report["views"]) view.erase("seconds");
  return report;
}

TEST(AutomaticRun, StopsByItselfWithTheScannableSurfaceCovered) {
  const AcquisitionSettings settings;
  const AcquisitionState state = acquireSmallObject(settings, 2);
  EXPECT_EQ(state.termination, Termination::Finished);
  EXPECT_GE(countScans(state, ScanStatus::In), 3U);
  EXPECT_LE(countScans(state, ScanStatus::In), 16U);
  EXPECT_EQ(measure(state.model->mesh).nonManifoldEdges, 0U);
  EvaluationOptions options;
  options.tolerance = 1.0;
  options.samples = 5000;
  const Evaluation e =
      evaluate(state.model->mesh, testing::smallObject(), *testing::smallProfile(), options, Progress());
  EXPECT_GE(e.coverage, 0.95);
  EXPECT_LE(e.rms, 0.15);
}

TEST(AutomaticRun, GivesTheSameBytesForAnyNumberOfThreads) {
  AcquisitionSettings settings;
  settings.maxViews = 3;
  const AcquisitionState one = acquireSmallObject(settings, 1);
  const AcquisitionState three = acquireSmallObject(settings, 3);
  EXPECT_EQ(reportWithoutMachine(one).dump(), reportWithoutMachine(three).dump());
  ASSERT_EQ(one.model->mesh.vertices.size(), three.model->mesh.vertices.size());
  for (std::size_t v = 0; v < one.model->mesh.vertices.size(); ++v)
    ASSERT_EQ(one.model->mesh.vertices[v], three.model->mesh.vertices[v]) << "vertex " << v;
  EXPECT_EQ(one.model->mesh.triangles, three.model->mesh.triangles);
}

TEST(AutomaticRun, NeverMovesTheFirstView) {
  AcquisitionSettings settings;
  settings.maxViews = 3;
  settings.firstView = 5;
  const AcquisitionState state = acquireSmallObject(settings, 2);
  EXPECT_EQ(state.scans.front().station().position, 5);
  EXPECT_EQ(state.scans.front().view.T_object_scanner.matrix(), state.profile->workspace.poses[5].matrix());
}

TEST(AutomaticRun, StopsAtTheMostViewsAllowed) {
  AcquisitionSettings settings;
  settings.maxViews = 2;
  const AcquisitionState state = acquireSmallObject(settings, 2);
  EXPECT_EQ(state.termination, Termination::MaxViews);
  EXPECT_EQ(countScans(state, ScanStatus::In), 2U);
}

TEST(AutomaticRun, UniformTakesEquallySpacedPositions) {
  AcquisitionSettings settings;
  settings.strategy = parseStrategy("uniform:8");
  const AcquisitionState state = acquireSmallObject(settings, 2);
  ASSERT_EQ(state.scans.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(state.scans[i].station().position, static_cast<int>(3 * i));
  EXPECT_EQ(state.termination, Termination::Finished);
}

TEST(AutomaticRun, ObserverHearsOfEveryStepAndCancellingLeavesTheLastOneWhole) {
  std::stop_source stop;
  std::size_t heard = 0;
  MemoryJournal journal(testing::smallProfile(), {});
  Acquisition acquisition(
      journal, testing::smallTools(testing::smallProfile()),
      [&](const Command& /*command*/, const AcquisitionState& before, const AcquisitionState& after) {
        EXPECT_EQ(after.scans.size(), before.scans.size() + 1);
        if (++heard == 2) stop.request_stop();
      });
  EXPECT_THROW(acquisition.runUntilTheEnd(Progress({}, stop.get_token(), 2)), Cancelled);
  EXPECT_EQ(heard, 2U);
  EXPECT_EQ(countScans(*journal.state(), ScanStatus::In), 2U);
  ASSERT_TRUE(journal.state()->model);
}

TEST(Strategy, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(name(parseStrategy("uniform:8")), "uniform:8");
  for (const char* text : {"", "uniform", "uniform:", "uniform:0", "uniform:-1", "uniform:8x", "best"})
    EXPECT_THROW(static_cast<void>(parseStrategy(text)), InvalidInput) << text;
}

}  // namespace
}  // namespace vantage
