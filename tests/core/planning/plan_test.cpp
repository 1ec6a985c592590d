#include "planning/plan.h"

#include <gtest/gtest.h>

#include <set>

#include "planning/patch_outlook.h"

namespace vantage {
namespace {

template <typename Enum>
std::set<std::string_view> namesUpTo(Enum last) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(last); ++i) names.insert(name(static_cast<Enum>(i)));
  return names;
}

TEST(Plan, HasNoPositionUntilOneIsFound) {
  EXPECT_EQ(Plan().position, std::nullopt);
}

TEST(Plan, NamesOutcomesConstraintsAndReasonsApart) {
  EXPECT_EQ(namesUpTo(PlanOutcome::NoOverlap), (std::set<std::string_view>{"found", "finished", "no_overlap"}));
  EXPECT_EQ(namesUpTo(Constraint::PoseUncertain),
            (std::set<std::string_view>{"chosen", "outscored", "below_threshold", "overlap_short", "pose_uncertain"}));
  EXPECT_EQ(namesUpTo(EdgeReason::Answered),
            (std::set<std::string_view>{"out_of_reach", "too_steep", "light_blocked", "receiver_blocked",
                                        "below_threshold", "answered"}));
}

}  // namespace
}  // namespace vantage
