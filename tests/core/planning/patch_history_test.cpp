#include "planning/patch_history.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/planning/scenes.h"
#include "support/meshes.h"

namespace vantage {
namespace {

// A patch in the middle of what the flat scanner sees, turned away from its first position by an angle [rad].
VoidPatch patchTurned(double angle) {
  VoidPatch patch;
  patch.centre = {0, 0, 100};
  patch.normal = {std::cos(angle), std::sin(angle), 0};
  patch.weight = 1.0;
  return patch;
}

// What views from these positions say about the patch.
PatchHistory historyOf(const VoidPatch& patch, const std::vector<std::size_t>& positions, const Mesh& obstacles = {}) {
  const ScannerProfile profile = testing::flatScanner();
  std::vector<Pose> taken;
  taken.reserve(positions.size());
  for (const std::size_t position : positions) taken.push_back(profile.workspace.poses[position]);
  return testing::sceneOf(profile, obstacles, {patch}, taken)->history();
}

TEST(PatchHistory, AttractsEveryViewWhileNoneHasSeenIt) {
  const PatchHistory history = historyOf(patchTurned(0.0), {2});  // from behind
  EXPECT_EQ(history.looks(0), 0);
  EXPECT_TRUE(history.attracts(0, 0.1));
}

TEST(PatchHistory, AttractsOnlyViewsThatSeeItClearlyMoreSquarely) {
  const double seen = std::cos(radians(40.0));
  const PatchHistory history = historyOf(patchTurned(radians(40.0)), {0});
  EXPECT_EQ(history.looks(0), 1);
  EXPECT_FALSE(history.attracts(0, seen));
  EXPECT_FALSE(history.attracts(0, seen + PatchHistoryOptions().cosineGain - 1e-9));
  EXPECT_TRUE(history.attracts(0, seen + PatchHistoryOptions().cosineGain + 1e-9));
}

TEST(PatchHistory, RemembersAGrazingViewWithoutCountingItAsALook) {
  const PatchHistory history = historyOf(patchTurned(radians(75.0)), {0});
  EXPECT_EQ(history.looks(0), 0);
  EXPECT_FALSE(history.attracts(0, std::cos(radians(75.0))));
  EXPECT_TRUE(history.attracts(0, std::cos(radians(60.0))));
}

TEST(PatchHistory, TakesAViewAtTheBreakdownAngleForNoLook) {
  EXPECT_EQ(historyOf(patchTurned(radians(57.0)), {0}).looks(0), 0);  // less than 6 degrees inside of 60
  EXPECT_EQ(historyOf(patchTurned(radians(53.0)), {0}).looks(0), 1);
}

TEST(PatchHistory, IsAnsweredAfterTwoLooks) {
  EXPECT_FALSE(historyOf(patchTurned(radians(45.0)), {0}).answered(0));
  const PatchHistory history = historyOf(patchTurned(radians(45.0)), {0, 1});
  EXPECT_TRUE(history.answered(0));
  EXPECT_FALSE(history.attracts(0, 1.0));
}

TEST(PatchHistory, HasNotSeenWhatTheModelHides) {
  EXPECT_EQ(historyOf(patchTurned(0.0), {0}, testing::makeBox({100, -5, 95}, {110, 5, 105})).looks(0), 0);
}

}  // namespace
}  // namespace vantage
