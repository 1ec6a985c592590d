#include "acquisition/phase_times.h"

#include <gtest/gtest.h>

#include "support/scenes/small_scene.h"

namespace vantage {
namespace {

TEST(Phase, IsFoundByItsName) {
  for (int i = 0; i < kPhases; ++i) EXPECT_EQ(phaseNamed(name(static_cast<Phase>(i))), static_cast<Phase>(i));
  EXPECT_EQ(phaseNamed("lunch"), std::nullopt);
}

TEST(PhaseTimer, CountsStepsOfOtherNamesToThePhaseThatTheyInterrupt) {
  PhaseTimer timer;
  const Progress progress = timer.watch({});
  progress.part(0.0, 0.1, "warming_up").checkpoint(0.0);
  const Progress registering = progress.part(0.1, 0.5, name(Phase::Register));
  registering.checkpoint(0.0);
  registering.part(0.5, 1.0, "refine").checkpoint(0.0);
  progress.part(0.5, 1.0, name(Phase::Integrate)).checkpoint(0.0);
  const PhaseTimes seconds = timer.finish();
  EXPECT_EQ(seconds.size(), 2U);
  EXPECT_TRUE(seconds.contains(Phase::Register));
  EXPECT_TRUE(seconds.contains(Phase::Integrate));
}

TEST(PhaseTimer, MeetsEveryPhaseInAStepOfAnAcquisition) {
  AcquisitionSettings settings;
  settings.maxViews = 2;
  const AcquisitionState state = testing::acquireSmallObject(settings, 1);
  EXPECT_EQ(state.scans.front().record.seconds.size(), static_cast<std::size_t>(kPhases));
}

}  // namespace
}  // namespace vantage
