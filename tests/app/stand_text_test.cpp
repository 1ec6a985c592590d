#include "stand_text.h"

#include <gtest/gtest.h>

#include "docks/stand_strip.h"

namespace vantage {
namespace {

Stand standWith(AlignmentVerdict verdict, AlignmentReason reason, std::optional<double> value) {
  StandAlignment alignment;
  alignment.verdict = verdict;
  alignment.reason = reason;
  alignment.value = value;
  return {{}, {}, std::make_shared<const StandAlignment>(alignment)};
}

Stand used(Stand stand, PoseChoice choice, bool sameSurface = false) {
  StandAlignment alignment = *stand.alignment;
  alignment.used = 0;
  alignment.choice = choice;
  alignment.sameSurface = sameSurface;
  stand.T_object_table = Pose::Identity();
  stand.alignment = std::make_shared<const StandAlignment>(alignment);
  return stand;
}

const Stand kFirst{Pose::Identity()};
const Stand kUntried{};
const Stand kGood = standWith(AlignmentVerdict::Good, AlignmentReason::OnePose, 0.4);
const Stand kTwoPoses = standWith(AlignmentVerdict::Ambiguous, AlignmentReason::SeveralPoses, 2.0);
const Stand kFailed = standWith(AlignmentVerdict::Failed, AlignmentReason::Contradiction, 0.05);

std::string sentence(const Stand& stand) {
  return standSentence({kFirst, stand}, 1).toStdString();
}

TEST(StandText, SaysWhatAStandIsToTheObject) {
  EXPECT_EQ(standRoleOf({kFirst}, 0), StandRole::Reference);
  EXPECT_EQ(standRoleOf({kFirst, kUntried}, 1), StandRole::NotAligned);
  EXPECT_EQ(standRoleOf({kFirst, kTwoPoses}, 1), StandRole::NotAligned);
  EXPECT_EQ(standRoleOf({kFirst, used(kGood, PoseChoice::Evidence)}, 1), StandRole::Aligned);
  EXPECT_EQ(standRoleOf({kFirst, used(kTwoPoses, PoseChoice::Operator)}, 1), StandRole::Doubtful);
  EXPECT_EQ(standRoleOf({kFirst, used(kTwoPoses, PoseChoice::Operator, true)}, 1), StandRole::Aligned)
      << "the choice makes no difference";
  EXPECT_EQ(standRoleOf({kFirst, used(kFailed, PoseChoice::Despite)}, 1), StandRole::Despite);
}

TEST(StandText, SaysWhatCameOfAligning) {
  EXPECT_EQ(sentence(kUntried), "Stand 1 is a model of its own: it is not put together with the object yet.");
  EXPECT_EQ(sentence(kTwoPoses), "Stand 1 is not aligned, the scans leave it open: 2 poses are possible.");
  EXPECT_EQ(sentence(kFailed),
            "Stand 1 could not be aligned: 5.0 % of the surface cannot be there in the best pose, or should have been "
            "seen and was not.");
  EXPECT_EQ(sentence(used(kGood, PoseChoice::Evidence)),
            "Stand 1 is aligned: one pose is possible, with 40 % of the surface in common.");
  EXPECT_EQ(sentence(used(kFailed, PoseChoice::Despite)),
            "Stand 1 is in the model although something speaks against it: 5.0 % of the surface cannot be there in the "
            "best pose, or should have been seen and was not.");
}

Moment momentOf(const std::vector<Stand>& stands) {
  auto outline = std::make_shared<StateOutline>();
  outline->stands = stands;
  Moment moment;
  moment.stand = static_cast<int>(stands.size()) - 1;
  moment.outline = outline;
  return moment;
}

TEST(StandSpans, GroupMomentsByStandAsItIsNow) {
  const std::vector<Stand> one{kFirst};
  const std::vector<Stand> two{kFirst, kUntried};
  const std::vector<Stand> aligned{kFirst, used(kGood, PoseChoice::Evidence)};
  EXPECT_TRUE(standSpans({momentOf(one), momentOf(one)}, 1).empty()) << "it was never turned over";
  const std::vector<Moment> moments{momentOf(one), momentOf(one), momentOf(two), momentOf(two), momentOf(aligned)};
  auto spans = standSpans(moments, 3);
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].last, 1);
  EXPECT_EQ(spans[1].first, 2);
  EXPECT_EQ(spans[1].last, 4);
  EXPECT_EQ(spans[1].role, StandRole::NotAligned) << "that it was aligned was undone";
  EXPECT_EQ(standSpans(moments, 4)[1].role, StandRole::Aligned);
  spans = standSpans(moments, 0);
  EXPECT_FALSE(spans[0].undone);
  EXPECT_TRUE(spans[1].undone);
  EXPECT_EQ(spans[1].role, StandRole::Aligned) << "as it was last";
}

}  // namespace
}  // namespace vantage
