#include "session/stand_json.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "session/session_json.h"

namespace vantage {
namespace {

Stand alignedStand() {
  StandAlignment alignment;
  alignment.verdict = AlignmentVerdict::Ambiguous;
  alignment.reason = AlignmentReason::SeveralPoses;
  alignment.value = 2.0;
  alignment.candidates = {{Pose::Identity(), 0.4, 1.0 / 3.0, 0.0, 0.01, 0.02, 0.5, true}, {}};
  alignment.used = 1;
  alignment.choice = PoseChoice::Despite;
  return {Pose::Identity(), Vec3(0.0, 0.6, 0.8), std::make_shared<const StandAlignment>(alignment)};
}

TEST(StandJson, ComesBackToTheLastBit) {
  const Stand read = standFrom(standJson(alignedStand()), 2, "step 1");
  EXPECT_EQ(standJson(read), standJson(alignedStand()));
  ASSERT_TRUE(read.alignment);
  EXPECT_EQ(read.alignment->candidates[0].rms, 1.0 / 3.0);
  EXPECT_EQ(read.alignment->used, 1);
  EXPECT_EQ(read.down, Vec3(0.0, 0.6, 0.8));
}

TEST(StandJson, WhatIsErasedComesBackToTheLastBit) {
  Stand stand = alignedStand();
  const Region region = BelowPlane{Vec3(0, 0, 1.0 / 3.0), Vec3::UnitZ()};
  stand.erased.push_back({4, std::make_shared<const RegionProbe>(region)});
  const Stand read = standFrom(standJson(stand), 2, "step 1");
  ASSERT_EQ(read.erased.size(), 1U);
  EXPECT_EQ(read.erased[0].number, 4);
  EXPECT_TRUE(read.erased[0].region->region() == region);
  auto json = standJson(stand);
  json["erased"][0]["region"]["normal"] = {0, 0, 0};
  EXPECT_THROW(static_cast<void>(standFrom(json, 2, "step 1")), InvalidInput);
  EXPECT_FALSE(standJson(alignedStand()).contains("erased"));
}

TEST(StandJson, TheStandThatASideWasToldInComesBack) {
  Stand stand = alignedStand();
  stand.reference = 1;
  EXPECT_EQ(standFrom(standJson(stand), 2, "step 1").reference, 1);
  EXPECT_THROW(static_cast<void>(standFrom(standJson(stand), 1, "step 1")), InvalidInput);
}

TEST(StandJson, OfAStandOfEarlierVersionsIsAsItWas) {
  EXPECT_EQ(standsText({{Pose::Identity()}, {}}),
            R"({"stands":[{"T_object_table":[1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0]},)"
            R"({"T_object_table":null}]})");
}

TEST(StandJson, ModelsThatAreSetAsideComeBack) {
  const std::vector<Stand> stands(3, alignedStand());
  const std::vector<OutlinedModel> aside{{0, 4}, {1, 9}};
  EXPECT_EQ(asideFromText(standsText(stands, aside), "step 1"), aside);
  EXPECT_TRUE(asideFromText(standsText(stands), "step 1").empty());
  EXPECT_THROW(static_cast<void>(asideFromText(standsText(stands, {{3, 4}}), "step 1")), InvalidInput);
  EXPECT_THROW(static_cast<void>(asideFromText(standsText(stands, {{1, 4}, {1, 5}}), "step 1")), InvalidInput);
}

TEST(StandJson, WhatCannotBeIsRefused) {
  nlohmann::json json = standJson(alignedStand());
  json["alignment"]["used"] = 2;
  EXPECT_THROW(static_cast<void>(standFrom(json, 2, "step 1")), InvalidInput);
  json = standJson(alignedStand());
  json["alignment"]["verdict"] = "fine";
  EXPECT_THROW(static_cast<void>(standFrom(json, 2, "step 1")), InvalidInput);
  json = standJson(alignedStand());
  json["down"] = {1, 2};
  EXPECT_THROW(static_cast<void>(standFrom(json, 2, "step 1")), InvalidInput);
}

TEST(StandJson, PickedPointsComeBack) {
  const PickedPairs picks{{Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3)}};
  const PickedPairs read = picksFrom(picksJson(picks), "picks.json");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].reference, picks[0].reference);
  EXPECT_EQ(read[0].moved, picks[0].moved);
  const auto half = nlohmann::json::parse(R"([{"on_object": [1, 2, 3]}])");
  EXPECT_THROW(static_cast<void>(picksFrom(half, "picks.json")), InvalidInput);
}

}  // namespace
}  // namespace vantage
