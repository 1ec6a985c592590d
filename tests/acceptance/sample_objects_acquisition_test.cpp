#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"
#include "report/evaluation.h"
#include "support/simulation.h"

// The main job on what is shipped: the sample objects before the sample scanner, with noise and mechanical errors.

namespace vantage {
namespace {

struct Acquired {
  AcquisitionState state;
  Evaluation evaluation;
};

Acquired acquireSample(const std::string& name) {
  const std::string resources = std::string(VANTAGE_SOURCE_DIR) + "/resources/";
  const auto profile = std::make_shared<const ScannerProfile>(loadProfile(resources + "scanners/rotating_stripe.json"));
  const Mesh object = loadMesh(resources + "objects/" + name + ".ply").mesh;
  const Progress progress = Progress().withThreads(2);
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile, progress));
  MemoryJournal journal(profile, {});
  Acquisition(journal, {testing::simulation(object, profile), images}).runUntilTheEnd(progress);
  Acquired result{*journal.state(), {}};
  result.evaluation = evaluate(result.state.model->mesh, object, *profile, {}, progress);
  return result;
}

// What every acquisition must keep: no wrong surface, no broken mesh, an end of its own.
void expectSound(const Acquired& acquired) {
  EXPECT_EQ(acquired.state.termination, Termination::Finished);
  EXPECT_LE(acquired.evaluation.rms, 0.15);
  EXPECT_LE(acquired.evaluation.falseSurface, 0.002);
  EXPECT_EQ(measure(acquired.state.model->mesh).nonManifoldEdges, 0U);
  for (const PatchOutlook& outlook : acquired.state.plan->outlook)
    EXPECT_LE(static_cast<int>(outlook.reason), static_cast<int>(EdgeReason::Answered));
}

TEST(SampleObjects, MugIsCompleteInEightViews) {
  const Acquired mug = acquireSample("mug");
  expectSound(mug);
  EXPECT_LE(countScans(mug.state, ScanStatus::In), 8U);
  EXPECT_GE(mug.evaluation.coverage, 0.985);
}

TEST(SampleObjects, HandsetIsCompleteInFourteenViews) {
  const Acquired handset = acquireSample("handset");
  expectSound(handset);
  EXPECT_LE(countScans(handset.state, ScanStatus::In), 14U);
  EXPECT_GE(handset.evaluation.coverage, 0.97);
}

// Its wings, arms and tail hide so much of it that 20 views chosen with full knowledge of the object cover 98 %.
TEST(SampleObjects, CandleHolderIsNearlyCompleteInTwentyViews) {
  const Acquired candleHolder = acquireSample("candle_holder");
  expectSound(candleHolder);
  EXPECT_LE(countScans(candleHolder.state, ScanStatus::In), 20U);
  EXPECT_GE(candleHolder.evaluation.coverage, 0.965);
}

}  // namespace
}  // namespace vantage
