#include "report/edges_left.h"

#include <gtest/gtest.h>

#include <memory>

namespace vantage {
namespace {

// Edges of 1, 2, 4, ... mm, left for those reasons.
Plan planLeaving(const std::vector<EdgeReason>& reasons) {
  Plan plan;
  auto voids = std::make_shared<VoidSurface>();
  double width = 1.0;
  for (const EdgeReason reason : reasons) {
    VoidPatch patch;
    patch.width = width;
    voids->patches.push_back(patch);
    plan.outlook.emplace_back();
    plan.outlook.back().reason = reason;
    width *= 2.0;
  }
  plan.voids = voids;
  return plan;
}

TEST(EdgesLeft, AreSummedByReasonInTheOrderOfReasons) {
  const auto left = edgesLeft(planLeaving({EdgeReason::Answered, EdgeReason::OutOfReach, EdgeReason::Answered}));
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[0].reason, EdgeReason::OutOfReach);
  EXPECT_EQ(left[0].edges, 1U);
  EXPECT_EQ(left[0].length, 2.0);
  EXPECT_EQ(left[1].reason, EdgeReason::Answered);
  EXPECT_EQ(left[1].edges, 2U);
  EXPECT_EQ(left[1].length, 5.0);
}

TEST(EdgesLeft, AreNotKnownWithoutThePatches) {
  EXPECT_TRUE(edgesLeft(Plan{}).empty());
  Plan plan = planLeaving({EdgeReason::TooSteep});
  plan.outlook.clear();
  EXPECT_TRUE(edgesLeft(plan).empty());
}

}  // namespace
}  // namespace vantage
