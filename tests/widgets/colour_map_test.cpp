#include "look/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vantage {
namespace {

constexpr std::array kMaps{ColourMap::Viridis, ColourMap::Cividis};

TEST(ColourMap, LightnessRisesAllTheWay) {
  for (const ColourMap map : kMaps) {
    double before = -1.0;
    for (int i = 0; i <= 20; ++i) {
      const double now = lightness(colourAt(map, i / 20.0));
      EXPECT_GT(now, before) << "at " << i / 20.0;
      before = now;
    }
  }
}

TEST(ColourMap, ReachesFromDarkToLight) {
  for (const ColourMap map : kMaps) {
    EXPECT_LT(lightness(colourAt(map, 0.0)), 20.0);
    EXPECT_GT(lightness(colourAt(map, 1.0)), 85.0);
  }
}

TEST(ColourMap, ValuesOutsideTakeTheNearerEnd) {
  for (const ColourMap map : kMaps) {
    EXPECT_EQ(colourAt(map, -3.0), colourAt(map, 0.0));
    EXPECT_EQ(colourAt(map, 7.0), colourAt(map, 1.0));
    EXPECT_EQ(colourAt(map, std::numeric_limits<double>::infinity()), colourAt(map, 1.0));
    EXPECT_EQ(colourAt(map, std::nan("")), colourAt(map, 0.0));
  }
}

TEST(ColourMap, LightnessOfBlackAndWhite) {
  EXPECT_NEAR(lightness({0, 0, 0}), 0.0, 1e-9);
  EXPECT_NEAR(lightness({255, 255, 255}), 100.0, 1e-6);
}

TEST(Categories, AreAllDifferentForTwentyFourViews) {
  for (std::size_t a = 0; a < 24; ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(categoryColour(a), categoryColour(b)) << a << " and " << b;
}

TEST(PatchStates, AnAnsweredPatchIsAnsweredWhateverTheOutcome) {
  const PatchOutlook outlook{2, true, EdgeReason::TooSteep};
  EXPECT_EQ(patchState(outlook, PlanOutcome::Found), PatchState::Answered);
  EXPECT_EQ(patchState(outlook, PlanOutcome::Finished), PatchState::Answered);
}

TEST(PatchStates, ReasonsCountOnceNothingIsProposed) {
  const PatchOutlook outlook{0, false, EdgeReason::LightBlocked};
  EXPECT_EQ(patchState(outlook, PlanOutcome::Found), PatchState::Open);
  EXPECT_EQ(patchState(outlook, PlanOutcome::Finished), PatchState::LightBlocked);
  EXPECT_EQ(patchState({1, false, EdgeReason::BelowThreshold}, PlanOutcome::Found), PatchState::LookedAt);
  EXPECT_EQ(patchState({1, false, EdgeReason::BelowThreshold}, PlanOutcome::Finished), PatchState::TooLittle);
}

}  // namespace
}  // namespace vantage
