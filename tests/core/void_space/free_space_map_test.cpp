#include "void_space/free_space_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

constexpr Space kFree = Space::Free;
constexpr Space kConditional = Space::ConditionallyFree;
constexpr Space kUnknown = Space::Unknown;

// A map from intervals in degrees.
FreeSpaceMap mapOf(std::vector<SpaceInterval> intervals, double thinWedge = 0.0) {
  for (SpaceInterval& i : intervals) i = {radians(i.begin), radians(i.end), i.space};
  return FreeSpaceMap(intervals, radians(thinWedge));
}

// Compares with intervals in degrees that cover the full turn.
void expectIntervals(const FreeSpaceMap& map, const std::vector<SpaceInterval>& expected) {
  ASSERT_EQ(map.intervals().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(degrees(map.intervals()[i].begin), expected[i].begin, 1e-9) << "interval " << i;
    EXPECT_NEAR(degrees(map.intervals()[i].end), expected[i].end, 1e-9) << "interval " << i;
    EXPECT_EQ(map.intervals()[i].space, expected[i].space) << "interval " << i;
  }
}

void expectVoidAngle(const FreeSpaceMap& map, double angleDegrees, bool bridged) {
  EXPECT_NEAR(degrees(map.voidAngle().angle), angleDegrees, 1e-9);
  EXPECT_EQ(map.voidAngle().bridged, bridged);
}

TEST(FreeSpaceMap, IsUnknownAtFirst) {
  expectIntervals(FreeSpaceMap(), {{0, 360, kUnknown}});
  expectVoidAngle(FreeSpaceMap(), 0, false);
}

TEST(FreeSpaceMap, OuterJumpIsFreeUpToTheFarSideOfTheRay) {  // Fig. 9b
  expectIntervals(outerJump(radians(70)), {{0, 250, kFree}, {250, 360, kUnknown}});
  expectVoidAngle(outerJump(radians(70)), 250, false);
}

TEST(FreeSpaceMap, InnerJumpIsFreeUpToTheRay) {  // Fig. 10a
  expectIntervals(innerJump(radians(70)), {{0, 70, kFree}, {70, 360, kUnknown}});
  expectVoidAngle(innerJump(radians(70)), 70, false);
}

TEST(FreeSpaceMap, LineOfSightJumpIsFreeUpToTheLineOfSight) {  // Fig. 10b
  expectIntervals(lineOfSightJump(radians(55)), {{0, 55, kFree}, {55, 360, kUnknown}});
  expectVoidAngle(lineOfSightJump(radians(55)), 55, false);
}

TEST(FreeSpaceMap, RegularEdgeHasTwoUnknownOneFreeAndOneConditionalPart) {  // Fig. 10c: u = 110, v = 230
  expectIntervals(regular(radians(80), radians(60), false),
                  {{0, 80, kConditional}, {80, 110, kUnknown}, {110, 230, kFree}, {230, 360, kUnknown}});
}

TEST(FreeSpaceMap, RegularEdgeOfTheSamplingRayIsFreeUpToIt) {
  const FreeSpaceMap map = regular(radians(80), radians(60), true);
  expectIntervals(map, {{0, 80, kFree}, {80, 110, kUnknown}, {110, 230, kFree}, {230, 360, kUnknown}});
  expectVoidAngle(map, 230, true);
}

TEST(FreeSpaceMap, LimbOfASphereContinuesFlat) {
  expectVoidAngle(regular(radians(30), radians(60), true), 180, true);
}

TEST(FreeSpaceMap, RegularEdgeWithoutAWedgeNeedsNoBridge) {
  const FreeSpaceMap map = regular(radians(80), radians(90), true);
  expectIntervals(map, {{0, 260, kFree}, {260, 360, kUnknown}});
  expectVoidAngle(map, 260, false);
}

TEST(FreeSpaceMap, SamplingRimKnowsNothingBeyondTheRay) {
  expectIntervals(samplingRim(radians(80), true), {{0, 80, kFree}, {80, 360, kUnknown}});
  expectIntervals(samplingRim(radians(80), false), {{0, 80, kConditional}, {80, 360, kUnknown}});
  expectVoidAngle(samplingRim(radians(80), true), 80, false);
}

TEST(FreeSpaceMap, SurfaceThatGoesOnEndsTheFreeSpace) {
  expectIntervals(surfaceGoesOn(radians(175)), {{0, 175, kFree}, {175, 360, kUnknown}});
}

TEST(FreeSpaceMap, IntervalsPastAFullTurnAreClipped) {
  expectIntervals(outerJump(radians(200)), {{0, 360, kFree}});
  expectVoidAngle(outerJump(radians(200)), 360, false);
  expectIntervals(regular(radians(250), radians(60), false),
                  {{0, 250, kConditional}, {250, 280, kUnknown}, {280, 360, kFree}});
  expectIntervals(regular(radians(340), radians(60), false), {{0, 340, kConditional}, {340, 360, kUnknown}});
  expectIntervals(mapOf({{-40, 20, kFree}}), {{0, 20, kFree}, {20, 360, kUnknown}});
}

TEST(FreeSpaceMap, NeighboursOfOneKindAreOneInterval) {
  expectIntervals(mapOf({{0, 20, kFree}, {20, 50, kFree}, {60, 60, kFree}}), {{0, 50, kFree}, {50, 360, kUnknown}});
}

TEST(FreeSpaceMap, RefusesIntervalsOutOfOrder) {
  EXPECT_THROW(mapOf({{30, 20, kFree}}), InvalidInput);
  EXPECT_THROW(mapOf({{0, 30, kFree}, {20, 50, kFree}}), InvalidInput);
  EXPECT_THROW(mapOf({{0, std::numeric_limits<double>::quiet_NaN(), kFree}}), InvalidInput);
}

TEST(FreeSpaceMap, SharedEndBelongsToTheFreerSide) {
  const FreeSpaceMap map = mapOf({{0, 30, kFree}, {40, 60, kConditional}, {60, 90, kFree}});
  EXPECT_EQ(map.at(0.0), kFree);
  EXPECT_EQ(map.at(map.intervals()[0].end), kFree);
  EXPECT_EQ(map.at(radians(35)), kUnknown);
  EXPECT_EQ(map.at(radians(40)), kConditional);
  EXPECT_EQ(map.at(map.intervals()[3].begin), kFree);
  EXPECT_EQ(map.at(radians(200)), kUnknown);
}

TEST(FreeSpaceMap, MergeConfirmsTheThinWedgeOfTheFirstRay) {              // Fig. 11
  const FreeSpaceMap first = regular(radians(70), radians(60), true);     // wedge 70..100, v = 220
  const FreeSpaceMap second = regular(radians(140), radians(60), false);  // wedge 140..170, v = 290
  const FreeSpaceMap map = FreeSpaceMap::merged(first, second);
  expectIntervals(map, {{0, 290, kFree}, {290, 360, kUnknown}});
  expectVoidAngle(map, 290, false);
}

TEST(FreeSpaceMap, MergeNarrowsTheWedgeFromBelow) {
  const FreeSpaceMap map = FreeSpaceMap::merged(regular(radians(70), radians(60), true),    // free 0..70, 100..220
                                                regular(radians(50), radians(60), false));  // free 80..200
  expectIntervals(map, {{0, 70, kFree}, {70, 80, kUnknown}, {80, 220, kFree}, {220, 360, kUnknown}});
  expectVoidAngle(map, 220, true);
}

TEST(FreeSpaceMap, MergeLeavesTheWedgeOfASteepRayBeyondTheFreeSpace) {
  const FreeSpaceMap map = FreeSpaceMap::merged(regular(radians(70), radians(60), true),     // v = 220
                                                regular(radians(210), radians(60), false));  // wedge 210..240
  expectIntervals(map, {{0, 220, kFree}, {220, 240, kUnknown}, {240, 360, kFree}});
  expectVoidAngle(map, 360, true);
}

TEST(FreeSpaceMap, MergeKeepsUnknownThatPrecedesConditionallyFree) {
  const FreeSpaceMap map = FreeSpaceMap::merged(mapOf({{0, 40, kFree}, {60, 90, kConditional}}),
                                                mapOf({{0, 50, kConditional}, {70, 120, kConditional}}));
  expectIntervals(map, {{0, 50, kFree}, {50, 60, kUnknown}, {60, 120, kConditional}, {120, 360, kUnknown}});
}

TEST(FreeSpaceMap, MergeFreesConditionalSpaceBetweenFreeParts) {
  const FreeSpaceMap map = FreeSpaceMap::merged(mapOf({{0, 40, kFree}, {80, 100, kFree}}),
                                                mapOf({{30, 90, kConditional}, {100, 130, kConditional}}));
  expectIntervals(map, {{0, 130, kFree}, {130, 360, kUnknown}});
}

TEST(FreeSpaceMap, MergeWithNothingKnownFreesOnlyTheLeadingConditionalPart) {
  expectIntervals(FreeSpaceMap::merged(regular(radians(80), radians(60), false), FreeSpaceMap()),
                  {{0, 80, kFree}, {80, 110, kUnknown}, {110, 230, kFree}, {230, 360, kUnknown}});
}

TEST(FreeSpaceMap, MergeDoesNotDependOnTheOrderOfItsTwoMaps) {
  for (int a = 10; a < 350; a += 35)
    for (int b = 5; b < 350; b += 25) {
      const FreeSpaceMap one = regular(radians(a), radians(60), true);
      const FreeSpaceMap two = regular(radians(b), radians(50), false);
      EXPECT_EQ(FreeSpaceMap::merged(one, two).intervals(), FreeSpaceMap::merged(two, one).intervals());
    }
}

TEST(FreeSpaceMap, MergeNeverTakesFreeSpaceBack) {
  for (int a = 10; a < 350; a += 35)
    for (int b = 5; b < 350; b += 25) {
      const FreeSpaceMap one = regular(radians(a), radians(60), true);
      const FreeSpaceMap merged = FreeSpaceMap::merged(one, regular(radians(b), radians(50), false));
      for (int degree = 0; degree < 360; ++degree)
        EXPECT_LE(merged.at(radians(degree + 0.5)), one.at(radians(degree + 0.5))) << a << " " << b << " at " << degree;
    }
}

TEST(FreeSpaceMap, BridgeIsNoWiderThanTheThinWedge) {
  expectVoidAngle(mapOf({{0, 50, kFree}, {80, 200, kFree}}, 30), 200, true);
  expectVoidAngle(mapOf({{0, 50, kFree}, {81, 200, kFree}}, 30), 50, false);
  expectVoidAngle(mapOf({{0, 50, kFree}, {80, 200, kFree}}), 50, false);
}

TEST(FreeSpaceMap, BridgeNeedsAFreePartOnEitherSide) {
  expectVoidAngle(mapOf({{20, 200, kFree}}, 30), 0, false);
  expectVoidAngle(mapOf({{0, 340, kFree}}, 30), 340, false);
  expectVoidAngle(mapOf({{0, 50, kFree}, {60, 90, kConditional}}, 30), 50, false);
}

TEST(FreeSpaceMap, BridgeMaySpanConditionalSpace) {
  expectVoidAngle(mapOf({{0, 50, kFree}, {60, 70, kConditional}, {75, 100, kFree}}, 30), 100, true);
}

}  // namespace
}  // namespace vantage
